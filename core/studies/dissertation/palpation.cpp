#include "studies/dissertation/palpation.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/files.h"
#include "base/parallel.h"
#include "studies/dissertation/internal/palpation_report.h"
#include "studies/dissertation/internal/palpation_trial.h"
#include "studies/dissertation/validate_stiffness.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

Result<std::vector<PalpationTrial>> trials_of(const PalpationOptions& options);
std::string fingerprint(const PalpationTrial& trial, const PalpationOptions& options);
const PalpationSpecimen& specimen_of(const PalpationTrial& trial);

// What is true of the trials' phantoms, and what elastography finds of them: once a phantom, for all its forces.
class Laboratory {
 public:
  Laboratory(const std::vector<PalpationTrial>& trials, const PalpationOptions& options, const Progress& progress);
  [[nodiscard]] Result<NamedNumbers> row_of(const PalpationTrial& trial, const PalpationOptions& options) const;

 private:
  // A gel and the forces that it is pressed with, ascending.
  struct Gel {
    std::string phantom;
    PalpationFault fault;
    std::vector<double> forces_N;
    Result<PressCurve> truth;
  };
  struct Map {
    std::string phantom;
    Result<elastography::CellStiffness> found;
  };
  // A wrong modulus is the model's alone.
  static PalpationFault fault_of_gel(const PalpationTrial& trial) {
    return trial.fault == PalpationFault::modulus ? PalpationFault::none : trial.fault;
  }

  std::vector<Gel> gels_;
  std::vector<Map> maps_;
};
Result<PalpationSummary> summed_up(std::vector<BatchRow> rows, std::vector<PalpationTrial> trials, bool simulated);

}  // namespace

std::string PalpationTrial::name() const {
  constexpr std::array<const char*, 4> faults{"", "-modulus", "-law", "-poisson"};
  return fmt::format("{}-{:.2f}N{}", phantom, force_N, faults[static_cast<std::size_t>(fault)]);
}

const std::vector<PalpationTrial>& dissertation_trials() {
  static const std::vector<PalpationTrial> trials{{"A", 1.69, 3.14},  {"A", 3.85, 3.24},  {"A", 7.81, 0.43},
                                                  {"B", 0.78, 2.33},  {"B", 4.02, 3.86},  {"B", 7.03, 1.48},
                                                  {"AB", 2.73, 1.66}, {"AB", 4.20, 3.10}, {"AB", 6.42, 0.98}};
  return trials;
}

const std::vector<PalpationTrial>& palpation_plan() {
  static const std::vector<PalpationTrial> plan = [] {
    std::vector<PalpationTrial> trials = dissertation_trials();
    for (const double force_N : {1.69, 3.85, 7.81}) trials.push_back({"A+b", force_N, {}});
    for (const double force_N : {0.78, 4.02, 7.03}) trials.push_back({"B+a", force_N, {}});
    for (const auto fault : {PalpationFault::modulus, PalpationFault::law, PalpationFault::poisson}) {
      trials.push_back({"A", 7.81, {}, fault});
    }
    return trials;
  }();
  return plan;
}

Result<PalpationSummary> run_palpation(const fs::path& out, const PalpationOptions& asked, const Progress& progress) {
  auto trials = trials_of(asked);
  if (!trials) return failure(trials.error());
  PalpationOptions options = asked;
  if (options.scans) {
    const auto by_mre = dissertation_regions();
    if (!options.soft_kPa) options.soft_kPa = by_mre[0].youngs_kPa;
    if (!options.stiff_kPa) options.stiff_kPa = by_mre[1].youngs_kPa;
  }
  std::vector<BatchPatient> jobs;
  for (const PalpationTrial& trial : *trials) jobs.push_back({trial.name(), fingerprint(trial, options)});
  std::optional<Laboratory> laboratory;
  if (!options.scans) laboratory.emplace(*trials, options, progress);
  const auto compute = [&](std::size_t n) -> Result<NamedNumbers> {
    const PalpationTrial& trial = (*trials)[n];
    if (laboratory) return laboratory->row_of(trial, options);
    const auto scans = scans_in(*options.scans, trial.phantom, trial.name());
    if (!scans) return failure(scans.error());
    return compared_trial(specimen_of(trial), trial, options, *scans);
  };
  auto rows = run_batch(out, jobs, compute, {}, progress);
  if (!rows) return failure(rows.error());
  auto summary = summed_up(std::move(*rows), std::move(*trials), !options.scans.has_value());
  if (!summary) return failure(summary.error());
  if (auto written = write_palpation(out, *summary, options); !written) return failure(written.error());
  return summary;
}

namespace {

Result<std::vector<PalpationTrial>> trials_of(const PalpationOptions& options) {
  std::vector<PalpationTrial> trials = options.scans ? dissertation_trials() : palpation_plan();
  for (const std::string& name : options.only) {
    if (std::ranges::none_of(trials, [&](const PalpationTrial& trial) { return trial.name() == name; })) {
      return failure("palpation-no-trial", GLISSON_TEXT("There is no trial {0}; the first one is {1}."),
                     {name, trials.front().name()});
    }
  }
  if (!options.only.empty()) {
    std::erase_if(trials, [&](const PalpationTrial& trial) {
      return std::ranges::find(options.only, trial.name()) == options.only.end();
    });
  }
  if (!options.scans) return trials;
  std::erase_if(trials, [&](const PalpationTrial& trial) {
    std::error_code problem;
    return !fs::exists(*options.scans / (trial.name() + ".ply"), problem);
  });
  if (!trials.empty()) return trials;
  return failure(Error{"palpation-no-scans",
                       GLISSON_TEXT("{0} holds none of the scans, such as A-1.69N.ply."),
                       {options.scans->string()},
                       {},
                       *options.scans});
}

std::string fingerprint(const PalpationTrial& trial, const PalpationOptions& options) {
  std::string print =
      fmt::format("palpation/2 {:g} {:g} {:g} {:g} {} {}", options.soft_kPa.value_or(0), options.stiff_kPa.value_or(0),
                  options.poisson_ratio, options.ball_radius_mm, options.bricks_across, options.bricks_high);
  if (options.scans) {
    for (const std::string& scan : {trial.phantom + "-rest", trial.name()}) {
      print += " " + sha256_of_file(*options.scans / (scan + ".ply")).value_or("unreadable");
    }
  }
  return print;
}

Laboratory::Laboratory(const std::vector<PalpationTrial>& trials, const PalpationOptions& options,
                       const Progress& progress) {
  for (const PalpationTrial& trial : trials) {
    const PalpationFault fault = fault_of_gel(trial);
    const auto known =
        std::ranges::find_if(gels_, [&](const Gel& gel) { return gel.phantom == trial.phantom && gel.fault == fault; });
    Gel& gel = known != gels_.end() ? *known : gels_.emplace_back(Gel{trial.phantom, fault, {}, cancelled()});
    if (std::ranges::find(gel.forces_N, trial.force_N) == gel.forces_N.end()) gel.forces_N.push_back(trial.force_N);
    if (std::ranges::find(maps_, trial.phantom, &Map::phantom) == maps_.end()) {
      maps_.push_back({trial.phantom, cancelled()});
    }
  }
  parallel_for(gels_.size() + maps_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (n < gels_.size()) {
        Gel& gel = gels_[n];
        std::ranges::sort(gel.forces_N);
        gel.truth =
            truth_of(specimen_of({gel.phantom, 0, {}}), gel.fault, options.ball_radius_mm, gel.forces_N, {}, progress);
      } else {
        Map& map = maps_[n - gels_.size()];
        const PalpationSpecimen& specimen = specimen_of({map.phantom, 0, {}});
        map.found = elastography_of(specimen, palpation_mesh(specimen, {options.bricks_across, options.bricks_high}),
                                    {}, options.poisson_ratio);
      }
    }
  });
}

Result<NamedNumbers> Laboratory::row_of(const PalpationTrial& trial, const PalpationOptions& options) const {
  const Gel& gel = *std::ranges::find_if(
      gels_, [&](const Gel& known) { return known.phantom == trial.phantom && known.fault == fault_of_gel(trial); });
  const Map& map = *std::ranges::find(maps_, trial.phantom, &Map::phantom);
  if (!gel.truth) return failure(gel.truth.error());
  if (!map.found) return failure(map.found.error());
  const auto at = std::ranges::find(gel.forces_N, trial.force_N) - gel.forces_N.begin();
  const bool largest = trial.force_N == gel.forces_N.back() && trial.fault == PalpationFault::none;
  return judged_trial(
      specimen_of(trial), trial,
      {gel.truth->rest_profile_mm, gel.truth->at_force[static_cast<std::size_t>(at)], *map.found, largest}, options);
}

const PalpationSpecimen& specimen_of(const PalpationTrial& trial) {
  const auto found = std::ranges::find(palpation_specimens(), trial.phantom, &PalpationSpecimen::name);
  GLISSON_ASSERT(found != palpation_specimens().end());
  return *found;
}

double number_in(const BatchRow& row, const std::string& name) { return column_of({row}, name).front(); }

Result<PalpationSummary> summed_up(std::vector<BatchRow> rows, std::vector<PalpationTrial> trials, bool simulated) {
  PalpationSummary summary;
  summary.simulated_scans = simulated;
  double table_trials = 0;
  bool any = false;
  for (std::size_t n = 0; n < trials.size(); ++n) {
    const PalpationTrial& trial = trials[n];
    const bool answered = rows[n].error.empty(), honest = trial.fault == PalpationFault::none;
    any = any || answered;
    if (simulated) {
      const bool within = answered && std::abs(number_in(rows[n], "off_percent")) <= 100 * palpation_limit;
      (honest ? summary.honest : summary.faults) += 1;
      if (honest && within) summary.held += 1;
      if (!honest && answered && !within) summary.caught += 1;
      if (!honest && answered && number_in(rows[n], "mean_mm") <= clinical_limit_mm) {
        summary.faults_within_clinical_limit += 1;
      }
      const bool must_be_told = trial.fault == PalpationFault::modulus || trial.fault == PalpationFault::law;
      if (must_be_told && (within || !answered)) summary.moduli_and_law_are_told = false;
    }
    if (!answered || !trial.reported_mm) continue;
    table_trials += 1;
    summary.mean_mm += number_in(rows[n], "mean_mm");
    summary.reported_mean_mm += *trial.reported_mm;
    summary.worst_mm = std::max(summary.worst_mm, number_in(rows[n], "mean_mm"));
  }
  if (!any) {
    return failure("palpation-all-failed", GLISSON_TEXT("None of the trials could be compared; the first one: {0}"),
                   {rows.front().error});
  }
  if (table_trials > 0) {
    summary.mean_mm /= table_trials;
    summary.reported_mean_mm /= table_trials;
  }
  summary.rows = std::move(rows);
  summary.trials = std::move(trials);
  return summary;
}

}  // namespace
}  // namespace glisson::studies
