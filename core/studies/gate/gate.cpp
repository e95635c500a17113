#include "studies/gate/gate.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "studies/gate/internal/compared_pictures.h"
#include "studies/gate/paired_test.h"

namespace glisson::studies {
namespace {

using Better = MetricTolerance::Better;

constexpr double largest_number = 1e100;  // differences and ratios then stay finite

// A metric's numbers in the cases that both have.
struct Pairs {
  std::vector<std::string> cases;
  std::vector<double> base, now;
};

Result<void> check_comparable(const Results& base, const Results& now, const GateOptions& options);
std::vector<std::string> missing_from(const Results& one, const Results& other);
std::vector<std::string> notes_on(const Results& base, const Results& now);
std::vector<MetricChange> compare_metrics(const Results& base, const Results& now, const GateOptions& options);
std::vector<WorstCase> worst_cases(const std::vector<MetricChange>& metrics, const Results& base, const Results& now,
                                   const GateOptions& options);
GateVerdict verdict_of(const Gate& gate);
Pairs pairs_of(const std::string& metric, const Results& base, const Results& now, MetricChange& change);
PairedChange judge(const Pairs& pairs, const MetricTolerance& tolerance, MetricChange& change);
void judge_each(const Pairs& pairs, const MetricTolerance& tolerance, MetricChange& change);
void decide(const PairedChange& paired, const MetricTolerance& tolerance, double p_worse, double p_better,
            double false_alarms, MetricChange& change);
PictureChange compare_pictures(const std::string& name, const Results& base, const Results& now,
                               const GateOptions& options);

MetricTolerance tolerance_of(const std::string& metric, const GateOptions& options) {
  const auto found = options.metrics.find(metric);
  return found == options.metrics.end() ? usual_tolerance(metric) : found->second;
}

// By how many tolerances a case got worse.
double tolerances_worse(double base, double now, const MetricTolerance& tolerance) {
  const double worse = tolerance.better == Better::same     ? std::abs(now - base)
                       : tolerance.better == Better::higher ? base - now
                                                            : now - base;
  const double allowed = tolerance.absolute.value_or(tolerance.percent / 100 * std::abs(base));
  if (worse <= 0) return 0;
  return allowed > 0 ? worse / allowed : std::numeric_limits<double>::infinity();
}

// By how many it got better.
double tolerances_better(double base, double now, MetricTolerance tolerance) {
  if (tolerance.better == Better::same) return 0;
  tolerance.better = tolerance.better == Better::higher ? Better::lower : Better::higher;
  return tolerances_worse(base, now, tolerance);
}

// Of so much worse by chance, and of so much better.
std::pair<double, double> p_of(const PairedChange& paired, Better better) {
  if (better == Better::same) return {std::min(1.0, 2 * std::min(paired.p_less, paired.p_greater)), 1.0};
  return better == Better::higher ? std::pair(paired.p_less, paired.p_greater)
                                  : std::pair(paired.p_greater, paired.p_less);
}

}  // namespace

const char* name_of(GateVerdict verdict) {
  switch (verdict) {
    case GateVerdict::same: return "same";
    case GateVerdict::better: return "better";
    case GateVerdict::worse: return "worse";
    case GateVerdict::undecided: break;
  }
  return "undecided";
}

Result<Gate> compare_results(const Results& base, const Results& now, const GateOptions& options,
                             const Progress& progress) {
  if (auto comparable = check_comparable(base, now, options); !comparable) return failure(comparable.error());
  Gate gate;
  gate.only_base = missing_from(base, now);
  gate.only_now = missing_from(now, base);
  gate.notes = notes_on(base, now);
  gate.metrics = compare_metrics(base, now, options);
  gate.worst = worst_cases(gate.metrics, base, now, options);
  std::size_t done = 0;
  for (const auto& [name, file] : base.pictures) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(done++) / static_cast<double>(base.pictures.size()), GLISSON_TEXT("pictures"));
    gate.pictures.push_back(compare_pictures(name, base, now, options));
  }
  gate.verdict = verdict_of(gate);
  return gate;
}

namespace {

Result<void> check_comparable(const Results& base, const Results& now, const GateOptions& options) {
  if (!base.data.empty() && !now.data.empty() && base.data != now.data) {
    return failure("results-other-data", GLISSON_TEXT("{0} was made on the data \"{1}\", {2} on \"{3}\"."),
                   {base.folder.string(), base.data, now.folder.string(), now.data});
  }
  if (missing_from(base, now).size() == base.cases.size()) {
    return failure(Error{"results-no-common-case",
                         GLISSON_TEXT("{0} and {1} have no case in common."),
                         {base.folder.string(), now.folder.string()},
                         GLISSON_TEXT("Name the same cases in the first column of both metrics.csv."),
                         {}});
  }
  for (const auto& [name, tolerance] : options.metrics) {
    if (base.metrics.contains(name) || now.metrics.contains(name)) continue;
    return failure("tolerance-without-metric", GLISSON_TEXT("The tolerances name {0}, which neither {1} nor {2} has."),
                   {name, base.folder.string(), now.folder.string()});
  }
  return {};
}

std::vector<std::string> missing_from(const Results& one, const Results& other) {
  const std::set<std::string> there(other.cases.begin(), other.cases.end());
  std::vector<std::string> missing;
  for (const std::string& id : one.cases) {
    if (!there.contains(id)) missing.push_back(id);
  }
  return missing;
}

// Whether what about.json says of both goes together; other data is refused before.
std::vector<std::string> notes_on(const Results& base, const Results& now) {
  std::vector<std::string> notes;
  if (base.program != now.program)
    notes.push_back(
        fmt::format("The results are of two programs: base \"{}\", new \"{}\".", base.program, now.program));
  if (base.data.empty() != now.data.empty()) {
    notes.push_back(
        fmt::format("Only {} says on which data it was made; whether the other is of the same is not known.",
                    base.data.empty() ? "new" : "base"));
  }
  if (!base.version.empty() && base.version == now.version && base.program == now.program)
    notes.push_back(fmt::format("Base and new are of the same version, {}.", base.version));
  if (base.version.empty() != now.version.empty())
    notes.push_back(fmt::format("Only {} says its version.", base.version.empty() ? "new" : "base"));
  return notes;
}

std::vector<MetricChange> compare_metrics(const Results& base, const Results& now, const GateOptions& options) {
  std::set<std::string> names;
  for (const Results* results : {&base, &now}) {
    for (const auto& [name, values] : results->metrics) names.insert(name);
  }
  std::vector<MetricChange> metrics;
  std::vector<std::size_t> tested;  // by statistics
  std::vector<PairedChange> tests;
  std::vector<double> p_worse, p_better;
  for (const std::string& name : names) {
    MetricChange& change = metrics.emplace_back();
    change.name = name;
    const MetricTolerance tolerance = tolerance_of(name, options);
    const Pairs pairs = pairs_of(name, base, now, change);
    const PairedChange paired = judge(pairs, tolerance, change);
    // Each metric may have to be corrected for all of them.
    const int sides = tolerance.better == Better::same ? 2 : 1;
    const bool too_few = sides * smallest_p(paired.pairs) * static_cast<double>(names.size()) > options.false_alarms;
    change.each_case = tolerance.each_case || too_few;
    if (change.each_case) {
      judge_each(pairs, tolerance, change);
      continue;
    }
    tested.push_back(metrics.size() - 1);
    tests.push_back(paired);
    const auto [worse, better] = p_of(paired, tolerance.better);
    p_worse.push_back(worse);
    p_better.push_back(better);
  }
  p_worse = holm_corrected(p_worse);
  p_better = holm_corrected(p_better);
  for (std::size_t k = 0; k < tested.size(); ++k) {
    MetricChange& change = metrics[tested[k]];
    decide(tests[k], tolerance_of(change.name, options), p_worse[k], p_better[k], options.false_alarms, change);
  }
  for (MetricChange& change : metrics) {
    if (!change.lost.empty()) change.verdict = GateVerdict::worse;
  }
  return metrics;
}

std::vector<WorstCase> worst_cases(const std::vector<MetricChange>& metrics, const Results& base, const Results& now,
                                   const GateOptions& options) {
  std::vector<std::pair<double, WorstCase>> found;
  for (const MetricChange& change : metrics) {
    if (change.verdict != GateVerdict::worse) continue;
    MetricChange counted;
    const Pairs pairs = pairs_of(change.name, base, now, counted);
    const MetricTolerance tolerance = tolerance_of(change.name, options);
    double worst = 0;
    WorstCase one;
    for (std::size_t k = 0; k < pairs.cases.size(); ++k) {
      const double worse = tolerances_worse(pairs.base[k], pairs.now[k], tolerance);
      if (worse <= worst) continue;
      worst = worse;
      one = {pairs.cases[k], change.name, pairs.base[k], pairs.now[k]};
    }
    if (worst > 0) found.emplace_back(worst, std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<WorstCase> worst;
  for (auto& [by, one] : found) worst.push_back(std::move(one));
  return worst;
}

GateVerdict verdict_of(const Gate& gate) {
  const auto any = [&](GateVerdict verdict) {
    const auto is = [&](const auto& change) { return change.verdict == verdict; };
    return std::any_of(gate.metrics.begin(), gate.metrics.end(), is) ||
           std::any_of(gate.pictures.begin(), gate.pictures.end(), is);
  };
  if (!gate.only_base.empty()) return GateVerdict::worse;
  for (const GateVerdict verdict : {GateVerdict::worse, GateVerdict::undecided, GateVerdict::better}) {
    if (any(verdict)) return verdict;
  }
  return GateVerdict::same;
}

Pairs pairs_of(const std::string& metric, const Results& base, const Results& now, MetricChange& change) {
  std::map<std::string, double> values;
  if (const auto found = now.metrics.find(metric); found != now.metrics.end()) {
    for (std::size_t k = 0; k < now.cases.size(); ++k) values[now.cases[k]] = found->second[k];
  }
  const std::set<std::string> there(now.cases.begin(), now.cases.end());
  const auto before = base.metrics.find(metric);
  Pairs pairs;
  for (std::size_t k = 0; k < base.cases.size(); ++k) {
    const std::string& id = base.cases[k];
    if (!there.contains(id)) continue;  // counted as a whole, not once a metric
    const double one = before == base.metrics.end() ? std::nan("") : before->second[k];
    const auto other = values.find(id);
    const double two = other == values.end() ? std::nan("") : other->second;
    const auto is_number = [](double value) { return std::abs(value) <= largest_number; };
    if (is_number(one) && is_number(two)) {
      pairs.cases.push_back(id);
      pairs.base.push_back(one);
      pairs.now.push_back(two);
    } else if (is_number(one)) {
      change.lost.push_back(id);
    } else if (is_number(two)) {
      change.gained.push_back(id);
    } else {
      ++change.without;
    }
  }
  change.cases = static_cast<int>(pairs.cases.size());
  change.base = median(pairs.base);
  change.now = median(pairs.now);
  return pairs;
}

// Fills in the change in the metric's unit, and gives the test on the scale that it was made on.
PairedChange judge(const Pairs& pairs, const MetricTolerance& tolerance, MetricChange& change) {
  const auto positive = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return value > 1 / largest_number; });
  };
  const bool ratio = !tolerance.absolute && positive(pairs.base) && positive(pairs.now);
  std::vector<double> differences;
  for (std::size_t k = 0; k < pairs.cases.size(); ++k) {
    differences.push_back(ratio ? std::log(pairs.now[k] / pairs.base[k]) : pairs.now[k] - pairs.base[k]);
  }
  const PairedChange paired = paired_change(std::move(differences));
  const auto in_unit = [&](double value) { return ratio ? change.base * std::expm1(value) : value; };
  change.difference = in_unit(paired.change);
  change.interval = {in_unit(paired.interval[0]), in_unit(paired.interval[1])};
  return paired;
}

void judge_each(const Pairs& pairs, const MetricTolerance& tolerance, MetricChange& change) {
  bool worse = false, better = false;
  for (std::size_t k = 0; k < pairs.cases.size(); ++k) {
    worse = worse || tolerances_worse(pairs.base[k], pairs.now[k], tolerance) > 1;
    better = better || tolerances_better(pairs.base[k], pairs.now[k], tolerance) > 1;
  }
  change.verdict = worse                 ? GateVerdict::worse
                   : better              ? GateVerdict::better
                   : pairs.cases.empty() ? GateVerdict::undecided
                                         : GateVerdict::same;
}

void decide(const PairedChange& paired, const MetricTolerance& tolerance, double p_worse, double p_better,
            double false_alarms, MetricChange& change) {
  change.p = p_worse;
  const double worse = tolerances_worse(change.base, change.base + change.difference, tolerance);
  const double better = tolerances_better(change.base, change.base + change.difference, tolerance);
  if (paired.pairs == 0) {
    change.verdict = GateVerdict::undecided;
  } else if (p_worse <= false_alarms && worse > 1) {
    change.verdict = GateVerdict::worse;
  } else if (p_better <= false_alarms && better > 1) {
    change.verdict = GateVerdict::better;
  }
}

PictureChange compare_pictures(const std::string& name, const Results& base, const Results& now,
                               const GateOptions& options) {
  PictureChange change;
  change.name = name;
  const auto refuse = [&](const std::string& problem) {
    change.similarity = 0;
    change.problem = problem;
    change.verdict = GateVerdict::worse;
    return change;
  };
  if (!now.pictures.contains(name)) return refuse("it is missing");
  const auto compared = compared_pictures(name, base, now, options);
  if (!compared) return refuse(compared.error().message());
  change.similarity = compared->similarity.worst;
  if (change.similarity < options.similarity) change.verdict = GateVerdict::worse;
  return change;
}

}  // namespace

Result<ComparedPictures> compared_pictures(const std::string& name, const Results& base, const Results& now,
                                           const GateOptions& options) {
  auto one = vision::read_frame(base.pictures.at(name)), other = vision::read_frame(now.pictures.at(name));
  if (!one) return failure(std::move(one.error()));
  if (!other) return failure(std::move(other.error()));
  std::optional<vision::Frame> mask;
  if (const auto found = options.masks.find(name.substr(name.find('/') + 1)); found != options.masks.end()) {
    auto read = vision::read_frame(found->second);
    if (!read) return failure(std::move(read.error()));
    mask = *std::move(read);
  }
  auto alike = vision::similarity_of(*one, *other, mask);
  if (!alike) return failure(std::move(alike.error()));
  return ComparedPictures{*std::move(one), *std::move(other), *std::move(alike)};
}

}  // namespace glisson::studies
