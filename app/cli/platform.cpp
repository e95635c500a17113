// glisson-cli platform: wearable computers, what each can do for a case, and this machine measured.
// Each subcommand stands in a file platform_NAME.cpp; list stands beside plan.

#include "command.h"
#include "platform_commands.h"

namespace glisson::cli {

void add_platform(CLI::App& app, Action& chosen) {
  CLI::App* platform =
      app.add_subcommand("platform", "Wearable computers: list them, plan for a case, measure this machine");
  platform->require_subcommand(1);
  add_platform_list(*platform, chosen);
  add_platform_plan(*platform, chosen);
  add_platform_grid(*platform, chosen);
  add_platform_measure(*platform, chosen);
  add_platform_cell(*platform, chosen);
  add_platform_learn(*platform, chosen);
  // --json and the other common options stand after the subcommand as well.
  for (CLI::App* subcommand : platform->get_subcommands({})) subcommand->fallthrough();
}

}  // namespace glisson::cli
