// glisson-cli segment CASE --structure NAME (--seed X,Y,Z ... | --labels FILE): one labelled structure.

#include <fmt/format.h>

#include "casefile/import.h"
#include "casefile/structures.h"
#include "command.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct Options {
  std::string case_folder;
  std::string structure;
  std::vector<std::string> seeds;
  std::optional<std::string> labels;
  std::optional<int> label_value;
};

Result<Outcome> segment(const Options& options, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  std::vector<Eigen::Vector3d> seeds_mm;
  for (const std::string& seed : options.seeds) {
    const auto position = parse_position(seed, "--seed");
    if (!position) return failure(position.error());
    seeds_mm.push_back(*position);
  }
  const auto saved = options.labels ? casefile::import_structure(*patient, options.structure, *options.labels,
                                                                 options.label_value, progress)
                                    : casefile::grow_structure(*patient, options.structure, seeds_mm, progress);
  if (!saved) return failure(saved.error());
  const auto file = patient->file_of(saved->id);
  const std::vector<std::string> notes = messages(saved->notes);
  return Outcome{
      {{"structure", saved->name},
       {"volume_ml", saved->volume_ml},
       {"voxels", saved->voxels},
       {"file", file->string()},
       {"notes", notes}},
      fmt::format("{}: {:.1f} ml, {} voxels\n", saved->name, saved->volume_ml, saved->voxels) + bullet_list(notes)};
}

}  // namespace

void add_segment(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("segment", "Mark one structure: grown from seeds, or from a label file");
  auto options = std::make_shared<Options>();
  command->add_option("case", options->case_folder, "The case")->required();
  command->add_option("--structure", options->structure, "liver, tumour-1, portal-vein, ...")
      ->required()
      ->check([](const std::string& name) {
        return name == casefile::structure_name(name) ? std::string() : "use lower-case letters, digits and dashes";
      });
  CLI::Option* seed = command->add_option("--seed", options->seeds, "X,Y,Z in mm (LPS) inside it; may be repeated")
                          ->allow_extra_args(false);
  CLI::Option* labels = command->add_option("--labels", options->labels, "Label file: NRRD, NIfTI, MHA or DICOM SEG");
  command->add_option("--label-value", options->label_value, "Which label of the file")->needs(labels);
  command->require_option();
  seed->excludes(labels);
  command->callback([&chosen, options] {
    if (options->seeds.empty() && !options->labels) throw CLI::RequiredError("--seed or --labels");
    chosen = [options](const Progress& progress) { return segment(*options, progress); };
  });
}

}  // namespace glisson::cli
