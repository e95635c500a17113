// glisson-cli study cohort FOLDER --out DIR: how stiffness varies between and within the patients of a cohort.

#include <fmt/format.h>

#include "cohort_options.h"
#include "studies/dissertation/cohort.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyCohortCommand {
  CohortChoice patients;
  studies::CohortOptions cohort;
};

Outcome describe_cohort(const studies::CohortSummary& summary) {
  std::string text = fmt::format(
      "{} patients ({} from an earlier run), {} could not be used\n"
      "Mean shear stiffness {:.2f} kPa (median {:.2f}, sd {:.2f}); 95 % lie between {:.2f} and {:.2f} kPa\n"
      "{:.0f} % lie within the atlas's width of the median, {:.0f} % in the atlas's own interval; the upper limit is "
      "{:.1f} times the atlas's\n"
      "Rank correlation of the spread within a patient with the mean: {:.2f}\n",
      summary.patients, summary.reused, summary.failed, summary.mean_kPa, summary.median_kPa, summary.sd_kPa,
      summary.low_kPa, summary.high_kPa, 100 * summary.like_reference_fraction, 100 * summary.in_reference_fraction,
      summary.upper_limit_ratio, summary.rank_correlation);
  Outcome outcome{studies::summary_json(summary), std::move(text)};
  outcome.document["reused"] = summary.reused;
  add_rows(summary.rows, outcome);
  return outcome;
}

Result<Outcome> run(const StudyCohortCommand& options, const Progress& progress) {
  return run_over_cohort(options.patients, options.cohort, [&](const std::string& folder, const auto& chosen) {
    return studies::run_cohort(folder, options.patients.out, chosen, progress).map(describe_cohort);
  });
}

}  // namespace

void add_study_cohort(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "cohort", "Stiffness between and within patients, against the atlas (section 4.3); run again, it goes on");
  auto options = std::make_shared<StudyCohortCommand>();
  add_cohort_options(*command, options->patients);
  command->add_option("--atlas-kPa", options->cohort.reference_kPa, "Mean shear stiffness of the atlas")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1000.0));
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
