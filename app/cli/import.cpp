// glisson-cli import PATH --case CASE [--add]: makes a case out of a study, or adds a study to a case.

#include <fmt/format.h>
#include <algorithm>

#include "casefile/import.h"
#include "command.h"
#include "imaging/study.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct ImportCommand {
  std::string path;
  std::string case_folder;
  casefile::ImportChoice choice;
  std::vector<std::string> label_values;  // "5=liver"
  bool add = false;
  bool replace = false;
};

Result<casefile::NewCase> add_to_case(const imaging::Study& study, const ImportCommand& options,
                                      const casefile::ImportChoice& choice, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  auto imported = casefile::import_study(*patient, study, choice, progress,
                                         options.replace ? casefile::Replacing::wanted : casefile::Replacing::refused);
  if (!imported) return failure(imported.error());
  return casefile::NewCase{*std::move(patient), *std::move(imported)};
}

Result<Outcome> import_path(const ImportCommand& options, const Progress& progress) {
  casefile::ImportChoice choice = options.choice;
  for (const std::string& text : options.label_values) choice.label_names.insert(*casefile::named_value(text));
  const auto study = imaging::scan(options.path, progress.part(0.0, 0.3));
  if (!study) return failure(study.error());
  const Progress rest = progress.part(0.3, 1.0);
  const auto made = options.add || options.replace ? add_to_case(*study, options, choice, rest)
                                                   : casefile::new_case_from(*study, options.case_folder, choice, rest);
  if (!made) return failure(made.error());

  Outcome outcome{{{"case", options.case_folder},
                   {"volumes", Json::array()},
                   {"structures", Json::array()},
                   {"labels", Json::array()}},
                  {}};
  for (const auto& volume : made->imported.volumes) {
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
  std::vector<std::string> said;  // of many structures of one file the same once
  for (const casefile::ImportedStructure& structure : made->imported.structures) {
    const auto notes = messages(structure.notes);
    outcome.document["structures"].push_back(structure.id.substr(7));
    outcome.document["labels"].push_back(
        {{"structure", structure.id.substr(7)}, {"volume_ml", structure.volume_ml}, {"notes", notes}});
    outcome.text += fmt::format("{:22} {:.1f} ml\n", structure.id, structure.volume_ml);
    for (const std::string& note : notes) {
      if (std::find(said.begin(), said.end(), note) == said.end()) said.push_back(note);
    }
  }
  outcome.text += bullet_list(said);
  const std::string& origin = made->patient.origin();
  if (!origin.empty()) outcome.document["origin"] = origin;
  outcome.text += fmt::format("{}{}\n", options.case_folder, origin.empty() ? "" : " (" + origin + ")");
  return outcome;
}

}  // namespace

void add_import(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("import", "Make a case from a study (DICOM, NIfTI, NRRD or MHA)");
  auto options = std::make_shared<ImportCommand>();
  command->add_option("path", options->path, "Folder, DICOMDIR or file")->required();
  command->add_option("--case", options->case_folder, "The case: NAME.glisson, made anew without --add")->required();
  command->add_option("--anatomy", options->choice.anatomy_uid, "Series that shows the anatomy");
  command->add_option("--stiffness", options->choice.stiffness_uid, "Series with the stiffness map");
  command->add_option("--magnitude", options->choice.magnitude_uid, "Series with the MRE magnitude");
  command
      ->add_option("--phase", options->choice.phase_uids,
                   "Series with the MRE phase; once for each where directions or frequencies are series of their own")
      ->allow_extra_args(false);
  command
      ->add_option("--labels", options->choice.label_uids,
                   "Label map or DICOM SEG to take (several may be given); without, those drawn on the anatomy")
      ->allow_extra_args(false);
  command
      ->add_option("--label-value", options->label_values,
                   "What a value of a label map is: 5=liver (several may be given; values without a name stay out)")
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        return casefile::named_value(text) ? std::string() : "VALUE=NAME, as in 5=liver";
      });
  command->add_flag("--add", options->add,
                    "Into the case that is there; refused where the images are not of its patient");
  command->add_flag("--replace", options->replace,
                    "The same, whoever's they are: an anatomy takes the place of the case's");
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return import_path(*options, progress); }; });
}

}  // namespace glisson::cli
