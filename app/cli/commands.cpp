// The commands in the order in which --help lists them: the way the work goes.

#include "command.h"

namespace glisson::cli {

void add_commands(CLI::App& app, Action& chosen) {
  add_scan(app, chosen);
  add_platform(app, chosen);
  add_deidentify(app, chosen);
}

}  // namespace glisson::cli
