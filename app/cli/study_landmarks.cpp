// glisson-cli study landmarks FOLDER --out DIR: how far an atlas, or one stiffness, misplaces landmarks over a cohort,
// or over real livers whose stiffness is drawn (--livers).

#include <fmt/format.h>

#include "cohort_options.h"
#include "studies/dissertation/cohort.h"
#include "studies/dissertation/landmarks.h"
#include "studies/dissertation/real_livers.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyLandmarksCommand {
  CohortChoice patients;
  std::string livers, law = "linear";
  std::optional<int> meshfree_nodes;
  studies::LandmarksOptions landmarks;
};

std::string described(const std::string& title, const std::vector<studies::LandmarksSpread>& spreads) {
  if (spreads.empty()) return {};
  std::string text = fmt::format("{:28} {:>8} {:>8} {:>8} {:>8} {:>13}\n", title + " (mm)", "patients", "mean",
                                 "median", "largest", "5 mm or more");
  for (const studies::LandmarksSpread& spread : spreads) {
    text += fmt::format("  {:26} {:8} {:8.1f} {:8.1f} {:8.1f} {:4.0f} % ({:.0f} to {:.0f})\n", spread.says,
                        spread.mm.voxels, spread.mm.mean, spread.mm.median, spread.mm.max,
                        100 * spread.significant.fraction, 100 * spread.significant.low, 100 * spread.significant.high);
  }
  return text;
}

Outcome describe_landmarks(const studies::LandmarksSummary& summary) {
  Outcome outcome{
      studies::summary_json(summary),
      fmt::format("{} patients ({} from an earlier run), {} could not be used; {:.1f} s at most a patient\n",
                  summary.patients, summary.reused, summary.failed, summary.slowest_s) +
          described("Between patients", summary.between) + described("Landmarks", summary.groups) +
          described("What moves landmarks", summary.sensitivity) + described("Meshfree", summary.engines) +
          described("Within a liver", summary.within) +
          fmt::format("In {:.0f} % of the patients one of the three regions at least is 5 mm off\n",
                      100 * summary.any_region_fraction)};
  outcome.document["reused"] = summary.reused;
  outcome.document["slowest_patient_s"] = summary.slowest_s;
  add_rows(summary.rows, outcome);
  return outcome;
}

studies::LandmarksOptions landmarks_options(const StudyLandmarksCommand& options) {
  studies::LandmarksOptions chosen = options.landmarks;
  if (options.law == "by-strain") chosen.retraction.law = studies::RetractionLaw::by_strain;
  if (options.meshfree_nodes) chosen.retraction.meshfree = {.nodes = *options.meshfree_nodes};
  return chosen;
}

Result<Outcome> run_on_livers(const StudyLandmarksCommand& options, const Progress& progress) {
  if (options.patients.list) {
    return studies::find_livers(options.livers, options.patients.seed).map([](const auto& livers) {
      Outcome outcome{{{"ids", Json::array()}}, {}};
      for (const studies::Subject& liver : livers) {
        outcome.document["ids"].push_back(liver.id);
        outcome.text += liver.id + "\n";
      }
      return outcome;
    });
  }
  studies::LandmarksOptions chosen = landmarks_options(options);
  chosen.livers_seed = options.patients.seed;
  chosen.retraction.law = studies::RetractionLaw::by_strain;
  chosen.part = options.patients.part;
  chosen.warning = studies::drawn_stiffness_warning;
  return studies::run_landmarks(options.livers, options.patients.out, chosen, progress).map(describe_landmarks);
}

Result<Outcome> run(const StudyLandmarksCommand& options, const Progress& progress) {
  if (!options.livers.empty()) return run_on_livers(options, progress);
  return run_over_cohort(
      options.patients, landmarks_options(options), [&](const std::string& folder, const auto& chosen) {
        return studies::run_landmarks(folder, options.patients.out, chosen, progress).map(describe_landmarks);
      });
}

}  // namespace

void add_study_landmarks(CLI::App& study, Action& chosen) {
  CLI::App* command =
      study.add_subcommand("landmarks",
                           "How far an atlas misplaces a retracted liver, and one stiffness its softest, stiffest and "
                           "most uneven tissue (section 4.4); run again, it goes on");
  auto options = std::make_shared<StudyLandmarksCommand>();
  add_cohort_options(*command, options->patients);
  command
      ->add_option(
          "--livers", options->livers,
          "Instead of a folder: label maps of real livers, as study shapes takes them, with ID_vessels.* beside "
          "them where known; their stiffness is SIMULATED (--seed), their vessels' forks are the landmarks")
      ->excludes("folder")
      ->excludes("--simulated");
  studies::RetractionOptions& retraction = options->landmarks.retraction;
  command->add_option("--atlas-kPa", retraction.reference_kPa, "Mean shear stiffness of the atlas")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1000.0));
  command->add_option("--force-N", retraction.force_N, "Of the retractor")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 100.0));
  command->add_option("--target-cells", retraction.target_cells, "Of a liver's mesh")
      ->capture_default_str()
      ->check(CLI::Range(500, 200000));
  command
      ->add_option("--law", options->law,
                   "linear, or by-strain: neo-Hookean where the linear answer leaves small strain, as --livers always")
      ->capture_default_str()
      ->check(CLI::IsMember({"linear", "by-strain"}));
  command
      ->add_option("--meshfree", options->meshfree_nodes,
                   "Retract by the meshfree engine as well, with so many nodes (0: one for every 12 points of the "
                   "mesh), and say how far apart the engines are")
      ->check(CLI::Range(0, 20000));
  command->add_option("--beam-force-N", options->landmarks.beams.force_N, "That lifts a beam at its middle")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 100.0));
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
