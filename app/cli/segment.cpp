// glisson-cli segment CASE --structure NAME (--seed X,Y,Z ... | --shapes MODEL [--not X,Y,Z ...] | --tubes |
// --labels FILE | --range LOW,HIGH | --unite OTHER | --intersect OTHER | --subtract OTHER): one labelled structure; or
// glisson-cli segment CASE --with COMMAND: all that another program outlines.

#include <fmt/format.h>
#include <algorithm>

#include "casefile/found_liver.h"
#include "casefile/label_map.h"
#include "casefile/outlined_by_program.h"
#include "casefile/structures.h"
#include "command.h"
#include "one_of.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct SegmentCommand {
  std::string case_folder;
  std::string structure;
  std::vector<std::string> seeds, outside;
  std::optional<std::string> labels;
  std::optional<int> label_value;
  std::vector<double> range;
  bool tubes = false;
  std::optional<std::string> shapes;                         // a model's file, or "simulated"
  std::optional<segmentation::VesselBrightness> brightness;  // of tubes
  std::optional<std::string> inside, unite, intersect, subtract;
  std::string with;
  std::vector<std::string> named;  // "1=liver"
};

Result<std::vector<Eigen::Vector3d>> positions(const std::vector<std::string>& texts, const char* option) {
  std::vector<Eigen::Vector3d> positions_mm;
  for (const std::string& text : texts) {
    const auto position = parse_position(text, option);
    if (!position) return failure(position.error());
    positions_mm.push_back(*position);
  }
  return positions_mm;
}

Result<casefile::SavedStructure> change(casefile::Case& patient, const SegmentCommand& options,
                                        const Progress& progress) {
  using casefile::Combination;
  const std::string& name = options.structure;
  if (options.labels) {
    return casefile::import_structure(patient, name, *options.labels, options.label_value, progress);
  }
  if (options.unite) return casefile::combine_structure(patient, name, Combination::unite, *options.unite);
  if (options.intersect) return casefile::combine_structure(patient, name, Combination::intersect, *options.intersect);
  if (options.subtract) return casefile::combine_structure(patient, name, Combination::subtract, *options.subtract);
  if (!options.range.empty()) {
    const segmentation::GreyRange range{options.range.at(0), options.range.at(1)};
    return casefile::threshold_structure(patient, name, range, options.inside);
  }
  const auto seeds_mm = positions(options.seeds, "--seed"), outside_mm = positions(options.outside, "--not");
  if (!seeds_mm) return failure(seeds_mm.error());
  if (!outside_mm) return failure(outside_mm.error());
  if (options.shapes || !outside_mm->empty() || (seeds_mm->empty() && !options.tubes)) {
    return casefile::find_liver(patient, {*seeds_mm, *outside_mm}, options.shapes.value_or(casefile::simulated_shapes),
                                progress);
  }
  if (options.tubes) {
    const std::string within = options.inside.value_or("liver");
    return casefile::segment_vessels(patient, name, *seeds_mm, within, options.brightness, progress);
  }
  return casefile::grow_structure(patient, name, *seeds_mm, progress, options.inside);
}

Result<Outcome> segment(const SegmentCommand& options, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  const auto saved = change(*patient, options, progress);
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

Result<Outcome> outline(const SegmentCommand& options, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  casefile::OutliningProgram program{options.with};
  for (const std::string& text : options.named) program.names.insert(*casefile::named_value(text));
  const auto outlined = casefile::outline_by_program(*patient, program, progress);
  if (!outlined) return failure(outlined.error());
  Outcome outcome{{{"structures", Json::array()}}, ""};
  for (const casefile::ImportedStructure& structure : *outlined) {
    const std::string name = structure.id.substr(7);
    const std::vector<std::string> notes = messages(structure.notes);
    outcome.document["structures"].push_back(
        {{"structure", name}, {"volume_ml", structure.volume_ml}, {"notes", notes}});
    outcome.text += fmt::format("{}: {:.1f} ml\n", name, structure.volume_ml) + bullet_list(notes);
  }
  return outcome;
}

}  // namespace

void add_segment(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "segment",
      "Mark a structure: grown from seeds, vessels by their shape, from a label file, by grey values, by another "
      "structure or program");
  auto options = std::make_shared<SegmentCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  CLI::Option* structure = command->add_option("--structure", options->structure, "liver, tumour-1, portal-vein, ...");
  structure->check([](const std::string& name) {
    return name == casefile::structure_name(name) ? std::string() : "use lower-case letters, digits and dashes";
  });
  std::vector<CLI::Option*> ways;
  CLI::Option* shapes = command->add_option(
      "--shapes", options->shapes,
      "The liver by its brightness and this shape model (\"study shapes\"), or \"simulated\", nobody's: "
      "from seeds, or from none. For the liver without any way given, \"simulated\"");
  ways.push_back(command->add_option("--seed", options->seeds, "X,Y,Z in mm (LPS) inside it; may be repeated")
                     ->allow_extra_args(false));
  const CLI::Option* seed = ways.back();
  CLI::Option* outside = command
                             ->add_option("--not", options->outside,
                                          "X,Y,Z in mm (LPS) in what was wrongly taken for the liver; may be repeated")
                             ->allow_extra_args(false);
  CLI::Option* tubes = command->add_flag("--tubes", options->tubes,
                                         "Vessels by their shape, without a click; with --seed those that hang on it");
  command->add_option("--brightness", options->brightness, "Of the tubes (default: what more of them are)")
      ->transform(one_of(Words<segmentation::VesselBrightness>{{"bright", segmentation::VesselBrightness::bright},
                                                               {"dark", segmentation::VesselBrightness::dark}}))
      ->needs(tubes);
  CLI::Option* labels = command->add_option("--labels", options->labels, "Label file: NRRD, NIfTI, MHA or DICOM SEG");
  ways.push_back(labels);
  command->add_option("--label-value", options->label_value, "Which label of the file")->needs(labels);
  ways.push_back(command->add_option("--range", options->range, "LOW,HIGH: the grey values that belong to it")
                     ->delimiter(',')
                     ->expected(2));
  ways.push_back(command->add_option("--unite", options->unite, "Adds what this other structure of the case holds"));
  ways.push_back(command->add_option("--intersect", options->intersect, "Keeps only what the other one holds too"));
  ways.push_back(command->add_option("--subtract", options->subtract, "Takes away what the other one holds"));
  command->add_option("--inside", options->inside,
                      "Seeds, tubes and grey values: only inside of this structure of the case (tubes: liver)");
  CLI::Option* with =
      command
          ->add_option("--with", options->with,
                       "Another program's command, as TotalSegmentator -i {image} -o {folder}: all that it outlines")
          ->excludes(structure);
  ways.push_back(with);
  command
      ->add_option("--named", options->named,
                   "What a value of its label map is, where the map does not say: 1=liver (several may be given)")
      ->needs(with)
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        return casefile::named_value(text) ? std::string() : "VALUE=NAME, as in 1=liver";
      });
  for (std::size_t k = 0; k < ways.size(); ++k) {
    for (std::size_t n = 0; n < k; ++n) ways[k]->excludes(ways[n]);
    if (k > 0) tubes->excludes(ways[k]);
    if (ways[k] == seed) continue;
    for (CLI::Option* of_liver : {shapes, outside}) of_liver->excludes(ways[k]);
  }
  for (CLI::Option* of_liver : {shapes, outside}) of_liver->excludes(tubes);
  command->callback([&chosen, options, ways, with, structure, tubes, shapes, outside] {
    if (with->count() > 0) {
      chosen = [options](const Progress& progress) { return outline(*options, progress); };
      return;
    }
    if (structure->count() == 0) throw CLI::RequiredError("--structure");
    if (shapes->count() > 0 && options->structure != "liver") {
      throw CLI::ValidationError("--shapes", "says what livers are like: give --structure liver");
    }
    if (outside->count() > 0 && options->structure != "liver") {
      throw CLI::ValidationError("--not", "says what is not liver: give --structure liver");
    }
    if (options->structure != "liver" && tubes->count() == 0 &&
        std::none_of(ways.begin(), ways.end(), [](const CLI::Option* way) { return way->count() > 0; })) {
      throw CLI::RequiredError("--seed, --tubes, --labels, --range, --unite, --intersect, --subtract or --with");
    }
    if (options->range.size() == 2 && !(options->range[0] <= options->range[1])) {
      throw CLI::ValidationError("--range", "the lower value comes first");
    }
    chosen = [options](const Progress& progress) { return segment(*options, progress); };
  });
}

}  // namespace glisson::cli
