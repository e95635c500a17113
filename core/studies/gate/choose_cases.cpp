#include "studies/gate/choose_cases.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include "base/csv.h"
#include "base/files.h"
#include "base/json_reading.h"
#include "studies/gate/gate.h"
#include "studies/gate/paired_test.h"

namespace glisson::studies {
namespace {

constexpr double least_scatter = 1e-3;            // relative: what repeats to the bit is worth a lot, and not all
constexpr double runs_that_the_others_count = 2;  // how much a case's scatter leans on that of all cases
constexpr double robust_sd = 1.4826;              // of a median of absolute values, where they are normal

// Of one metric of one case, from each run to the next: by how much it got worse, relative.
struct Steps {
  std::vector<double> worse;
  int lost = 0;  // how often a number was lost
};
Steps steps_of(const std::string& metric, const std::vector<double>& values);

struct Known {
  CaseWorth worth;
  std::optional<double> minutes;
  std::optional<double> scatter;  // relative
  int steps = 0;
};
Known known_of(const CaseHistory& history);
double median_of(const std::vector<Known>& all, std::optional<double> Known::*value, double otherwise);

}  // namespace

Result<CaseChoice> choose_cases(const std::vector<CaseHistory>& histories, double budget_minutes) {
  std::vector<Known> all;
  for (const CaseHistory& history : histories) all.push_back(known_of(history));
  const double usual_minutes = median_of(all, &Known::minutes, 1),
               usual_scatter = median_of(all, &Known::scatter, 0.05);
  const double usual_worth = 1 / (usual_scatter * usual_scatter * usual_minutes);
  std::vector<CaseWorth> worths;
  for (Known& known : all) {
    CaseWorth worth = known.worth;
    worth.minutes = known.minutes.value_or(usual_minutes);
    const double own = known.scatter.value_or(usual_scatter);
    const double variance = (known.steps * own * own + runs_that_the_others_count * usual_scatter * usual_scatter) /
                            (known.steps + runs_that_the_others_count);
    worth.scatter_percent = 100 * std::sqrt(variance);
    const bool never_run = !known.minutes && known.steps == 0;
    worth.worth_per_minute = never_run ? std::numeric_limits<double>::max()
                                       : (1 + worth.got_worse) / (variance * worth.minutes) / usual_worth;
    worths.push_back(std::move(worth));
  }
  std::stable_sort(worths.begin(), worths.end(),
                   [](const CaseWorth& a, const CaseWorth& b) { return a.worth_per_minute > b.worth_per_minute; });
  CaseChoice choice;
  for (CaseWorth& worth : worths) {
    const bool fits = choice.minutes + worth.minutes <= budget_minutes;
    if (fits) choice.minutes += worth.minutes;
    (fits ? choice.chosen : choice.left_out).push_back(std::move(worth));
  }
  if (choice.chosen.empty()) {
    return failure(Error{"gate-budget",
                         GLISSON_TEXT("No case fits in {0} minutes."),
                         {fmt::format("{:g}", budget_minutes)},
                         GLISSON_TEXT("Give more minutes, or a history with shorter cases."),
                         {}});
  }
  return choice;
}

Result<std::vector<CaseHistory>> read_gate_history(const std::filesystem::path& file) {
  const auto text = read_text_file(file, std::uint64_t{64} << 20);
  if (!text) return failure(text.error());
  return reading("gate-history-invalid", file, [&] {
    const std::vector<CsvRow> rows = csv_rows(*text);
    if (rows.size() < 2 || rows.front().cells.size() < 2 || rows.front().cells[0] != "case" ||
        rows.front().cells[1] != "seconds") {
      refuse("", GLISSON_TEXT("{0} must begin with a line case,seconds,METRIC, ... and hold a row a case a run."),
             {file.string()});
    }
    const auto& names = rows.front().cells;
    if (std::set<std::string_view>(names.begin(), names.end()).size() != names.size()) {
      refuse("", GLISSON_TEXT("A column of {0} is there twice."), {file.string()});
    }
    std::vector<CaseHistory> histories;
    std::map<std::string, std::size_t, std::less<>> place;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const CsvRow& row = rows[r];
      if (row.cells.size() > names.size() || row.cells.front().empty()) {
        refuse("", GLISSON_TEXT("Line {0} of {1} names no case, or has more cells than the first."),
               {std::to_string(row.line), file.string()});
      }
      const auto [known, is_new] = place.try_emplace(std::string(row.cells.front()), histories.size());
      if (is_new) histories.push_back({std::string(row.cells.front()), {}, {}});
      CaseHistory& history = histories[known->second];
      history.seconds.push_back(row.number(1));
      for (std::size_t c = 2; c < names.size(); ++c) history.metrics[std::string(names[c])].push_back(row.number(c));
    }
    return histories;
  });
}

Result<std::vector<std::string>> read_chosen_cases(const std::filesystem::path& file) {
  const auto text = read_text_file(file, std::uint64_t{16} << 20);
  if (!text) return failure(text.error());
  std::vector<std::string> cases;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
    if (!line.empty()) cases.push_back(line);
  }
  if (cases.empty()) {
    return failure(Error{"gate-cases-empty",
                         GLISSON_TEXT("{0} names no case."),
                         {file.string()},
                         GLISSON_TEXT("Make it with glisson-cli gate-cases."),
                         file});
  }
  return cases;
}

Results only(const Results& results, const std::vector<std::string>& cases) {
  const std::set<std::string> wanted(cases.begin(), cases.end());
  Results chosen = results;
  chosen.cases.clear();
  for (auto& [name, values] : chosen.metrics) values.clear();
  for (std::size_t k = 0; k < results.cases.size(); ++k) {
    if (!wanted.contains(results.cases[k])) continue;
    chosen.cases.push_back(results.cases[k]);
    for (auto& [name, values] : chosen.metrics) values.push_back(results.metrics.at(name)[k]);
  }
  std::erase_if(chosen.pictures, [&](const auto& picture) {
    return !wanted.contains(picture.first.substr(0, picture.first.find('/')));
  });
  return chosen;
}

namespace {

Steps steps_of(const std::string& metric, const std::vector<double>& values) {
  const bool higher_is_better = usual_tolerance(metric).better == MetricTolerance::Better::higher;
  std::vector<double> sizes;
  for (const double value : values) {
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  }
  const double usual = median(sizes);
  Steps steps;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) {
      steps.lost += std::isfinite(before) ? 1 : 0;
    } else if (std::isfinite(before) && usual > 0) {
      steps.worse.push_back((higher_is_better ? before - value : value - before) / usual);
    }
    before = value;
  }
  return steps;
}

Known known_of(const CaseHistory& history) {
  Known known;
  known.worth.id = history.id;
  std::vector<double> minutes;
  for (const double seconds : history.seconds) {
    if (std::isfinite(seconds) && seconds > 0) minutes.push_back(seconds / 60);
  }
  if (!minutes.empty()) known.minutes = median(minutes);
  double variances = 0;
  int metrics = 0;
  for (const auto& [metric, values] : history.metrics) {
    const Steps steps = steps_of(metric, values);
    known.worth.got_worse += steps.lost;
    if (steps.worse.empty()) continue;
    std::vector<double> sizes;
    for (const double step : steps.worse) sizes.push_back(std::abs(step));
    // A step is the difference of two runs.
    const double step_sd = std::max(least_scatter, robust_sd * median(sizes));
    for (const double step : steps.worse) known.worth.got_worse += step > std::max(3 * step_sd, 0.02) ? 1 : 0;
    variances += step_sd * step_sd / 2;
    known.steps = std::max(known.steps, static_cast<int>(steps.worse.size()));
    ++metrics;
  }
  if (metrics > 0) known.scatter = std::sqrt(variances / metrics);
  return known;
}

double median_of(const std::vector<Known>& all, std::optional<double> Known::*value, double otherwise) {
  std::vector<double> values;
  for (const Known& known : all) {
    if (known.*value) values.push_back(*(known.*value));
  }
  return values.empty() ? otherwise : median(values);
}

}  // namespace
}  // namespace glisson::studies
