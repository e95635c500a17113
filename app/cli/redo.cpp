// glisson-cli redo CASE --from RECORDED --step N: what a hand did to another case in the window, done to this one.

#include <fmt/format.h>

#include "casefile/redo_step.h"
#include "recording_commands.h"

namespace glisson::cli {

void add_redo(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "redo", "Do a step again that was done by hand in the window, from the history of the case where it was done");
  auto case_folder = std::make_shared<std::string>(), recorded = std::make_shared<std::string>();
  auto step = std::make_shared<int>();
  command->add_option("case", *case_folder, "The case, as the other one was before that step")->required();
  command->add_option("--from", *recorded, "The case where it was done")->required();
  command->add_option("--step", *step, "Its number, as macro tells it")->required()->check(CLI::PositiveNumber);
  command->callback([&chosen, case_folder, recorded, step] {
    chosen = [case_folder, recorded, step](const Progress&) -> Result<Outcome> {
      auto patient = casefile::Case::open(*case_folder);
      if (!patient) return failure(patient.error());
      return casefile::redo_step(*patient, *recorded, *step).map([&] {
        return Outcome{{{"case", *case_folder}, {"step", *step}}, fmt::format("Step {} is done.\n", *step)};
      });
    };
  });
}

}  // namespace glisson::cli
