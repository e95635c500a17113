// The commands in the order in which --help lists them: the way the work goes.

#include "command.h"

namespace glisson::cli {

void add_commands([[maybe_unused]] CLI::App& app, [[maybe_unused]] Action& chosen) {}

}  // namespace glisson::cli
