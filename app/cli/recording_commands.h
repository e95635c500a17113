#pragma once
// Commands about what was done before: in the window, and in earlier runs of a gate.

#include "command.h"

namespace glisson::cli {

void add_macro(CLI::App& app, Action& chosen);
void add_redo(CLI::App& app, Action& chosen);
void add_gate_cases(CLI::App& app, Action& chosen);

}  // namespace glisson::cli
