// glisson-cli study validate-stiffness --out DIR: the means of an MRE map's regions against mechanical tests.

#include <fmt/format.h>

#include "base/tissue.h"
#include "shared_options.h"
#include "studies/dissertation/validate_stiffness.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyValidateStiffnessCommand {
  std::string map, labels, tests, out;
  double poisson_ratio = usual_poisson_ratio;
};

Outcome describe_validate_stiffness(const studies::StiffnessValidation& validation) {
  Outcome outcome{{{"materials", Json::array()},
                   {"largest_difference_percent", validation.largest_difference_percent},
                   {"notes", validation.notes}},
                  fmt::format("{:10} {:>10} {:>14} {:>11} {:>13} {:>11}\n", "material", "MRE (kPa)", "machine (kPa)",
                              "difference", "stated (kPa)", "difference")};
  for (const studies::MaterialAgreement& m : validation.materials) {
    Json json{{"material", m.material},       {"mre_kPa", m.mre_kPa},
              {"machine_kPa", m.machine_kPa}, {"machine_range_kPa", {m.machine_low_kPa, m.machine_high_kPa}},
              {"samples", m.samples},         {"difference_percent", m.difference_percent}};
    outcome.text +=
        fmt::format("{:10} {:10.2f} {:14.2f} {:+10.1f}%", m.material, m.mre_kPa, m.machine_kPa, m.difference_percent);
    if (m.stated_kPa > 0) {
      json["stated_kPa"] = m.stated_kPa;
      json["stated_difference_percent"] = m.stated_difference_percent;
      outcome.text += fmt::format(" {:13.2f} {:+10.1f}%", m.stated_kPa, m.stated_difference_percent);
    }
    outcome.text += "\n";
    outcome.document["materials"].push_back(std::move(json));
  }
  outcome.text += bullet_list(validation.notes);
  return outcome;
}

Result<Outcome> run(const StudyValidateStiffnessCommand& options) {
  const auto samples = options.tests.empty() ? studies::dissertation_samples() : studies::read_samples(options.tests);
  if (!samples) return failure(samples.error());
  Result<std::vector<studies::MreRegion>> regions = studies::dissertation_regions();
  if (!options.map.empty()) regions = studies::regions_of(options.map, options.labels, options.poisson_ratio);
  if (!regions) return failure(regions.error());
  return studies::validate_stiffness(*regions, *samples, options.out).map(describe_validate_stiffness);
}

}  // namespace

void add_study_validate_stiffness(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "validate-stiffness",
      "Young's modulus by MRE against a testing machine (section 4.6); without files, the dissertation's own figures");
  auto options = std::make_shared<StudyValidateStiffnessCommand>();
  CLI::Option* map = command->add_option("--map", options->map, "Map of shear stiffness (NRRD, NIfTI, MHA)");
  CLI::Option* labels = command->add_option("--labels", options->labels, "Label map; label 1 is material 1, and so on");
  map->needs(labels);
  labels->needs(map);
  command->add_option("--tests", options->tests,
                      "CSV: material,diameter_mm,height_mm,displacement_mm,force_N and, optionally, stated_kPa, mean_kPa");
  command->add_option("--poisson-ratio", options->poisson_ratio, "Of the materials, for E = 2 G (1 + nu)")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 0.5));
  command->add_option("--out", options->out, "Folder for the table, the summary and the report")->required();
  command->callback([&chosen, options] { chosen = [options](const Progress&) { return run(*options); }; });
}

}  // namespace glisson::cli
