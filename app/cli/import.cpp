// glisson-cli import PATH --case CASE: makes a case out of a study.

#include <fmt/format.h>

#include "casefile/import.h"
#include "command.h"
#include "imaging/study.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct Options {
  std::string path;
  std::string case_folder;
  casefile::ImportChoice choice;
};

Result<Outcome> import_path(const Options& options, const Progress& progress) {
  const auto study = imaging::scan(options.path, progress.part(0.0, 0.3));
  if (!study) return failure(study.error());
  const auto made = casefile::new_case_from(*study, options.case_folder, options.choice, progress.part(0.3, 1.0));
  if (!made) return failure(made.error());

  Outcome outcome{{{"case", options.case_folder}, {"volumes", Json::array()}, {"structures", Json::array()}}, {}};
  for (const auto& volume : made->volumes) {
    outcome.document["volumes"].push_back({{"role", imaging::role_name(volume.role)},
                                           {"id", volume.id},
                                           {"size", volume.grid.size},
                                           {"spacing_mm", json_of(volume.grid.spacing_mm)},
                                           {"origin_mm", json_of(volume.grid.origin_mm)},
                                           {"direction", direction_json(volume.grid.direction)},
                                           {"notes", volume.notes}});
    outcome.text +=
        fmt::format("{:22} {} x {} x {}\n", volume.id, volume.grid.size[0], volume.grid.size[1], volume.grid.size[2]) +
        bullet_list(volume.notes);
  }
  for (const casefile::Entry& entry : made->patient.entries()) {
    if (!entry.id.starts_with("labels/")) continue;
    outcome.document["structures"].push_back(entry.id.substr(7));
    outcome.text += fmt::format("{}\n", entry.id);
  }
  const std::string& origin = made->patient.origin();
  if (!origin.empty()) outcome.document["origin"] = origin;
  outcome.text += fmt::format("{}{}\n", options.case_folder, origin.empty() ? "" : " (" + origin + ")");
  return outcome;
}

}  // namespace

void add_import(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("import", "Make a case from a study (DICOM, NIfTI, NRRD or MHA)");
  auto options = std::make_shared<Options>();
  command->add_option("path", options->path, "Folder, DICOMDIR or file")->required();
  command->add_option("--case", options->case_folder, "The case to make: NAME.glisson")->required();
  command->add_option("--anatomy", options->choice.anatomy_uid, "Series that shows the anatomy");
  command->add_option("--stiffness", options->choice.stiffness_uid, "Series with the stiffness map");
  command->add_option("--magnitude", options->choice.magnitude_uid, "Series with the MRE magnitude");
  command
      ->add_option("--phase", options->choice.phase_uids,
                   "Series with the MRE phase; once for each where directions or frequencies are series of their own")
      ->allow_extra_args(false);
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return import_path(*options, progress); }; });
}

}  // namespace glisson::cli
