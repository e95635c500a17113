// glisson-cli study: the dissertation's studies as batch jobs. Each subcommand stands in a file study_NAME.cpp.

#include "command.h"
#include "study_commands.h"

namespace glisson::cli {

void add_study(CLI::App& app, Action& chosen) {
  CLI::App* study = app.add_subcommand("study", "The dissertation's studies, over many patients or loads");
  study->require_subcommand(1);
  add_study_anatomy(*study, chosen);
  add_study_cohort(*study, chosen);
  add_study_beams(*study, chosen);
  add_study_convergence(*study, chosen);
  add_study_data_driven(*study, chosen);
  add_study_example_sequence(*study, chosen);
  add_study_landmarks(*study, chosen);
  add_study_matching(*study, chosen);
  add_study_palpation(*study, chosen);
  add_study_shapes(*study, chosen);
  add_study_validate_stiffness(*study, chosen);
  // --json and the other common options stand after the subcommand as well.
  for (CLI::App* subcommand : study->get_subcommands({})) subcommand->fallthrough();
}

}  // namespace glisson::cli
