#pragma once
// Which cases to run where there is time for some: those that told the most a minute in earlier runs.
//
// Each case tells of a change of all cases alike as exactly as its own figures repeat from run to run. That is 1 /
// variance of their relative scatter, which adds up over cases. A change of few cases shows in those that got worse
// before. So a case is worth
//
//   (1 + runs in which it got worse) / (variance of its scatter x minutes)
//
// and cases are taken by that, the best first, as long as they fit: the greedy rule for a knapsack (Dantzig, Operations
// Research 5, 1957). Information a cost is how samples are shared out among strata (Neyman 1934; Cochran, Sampling
// Techniques, 3rd edition 1977, section 5.5). Past faults a cost is how tests are put in order (Elbaum, Malishevsky and
// Rothermel, International Conference on Software Engineering 2001). A case that was never run comes first: nothing is
// known of it.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "studies/gate/results.h"

namespace glisson::studies {

// What earlier runs found of a case, in their order.
struct CaseHistory {
  std::string id;
  std::vector<double> seconds;                         // NaN: not known
  std::map<std::string, std::vector<double>> metrics;  // NaN: no number
};

// A CSV with the columns case and seconds, and a column a metric; a row a case a run, earlier runs first. Failure:
// "gate-history-invalid".
Result<std::vector<CaseHistory>> read_gate_history(const std::filesystem::path& file);

struct CaseWorth {
  std::string id;
  double minutes = 0;          // the median of its runs; of all cases' where it has none
  double scatter_percent = 0;  // from run to run, those in which it got worse left out
  int got_worse = 0;           // runs in which a metric got worse by more than three times its scatter and 2 %, or lost
                               // its number
  double worth_per_minute = 0;  // relative to the median case's
};

struct CaseChoice {
  std::vector<CaseWorth> chosen, left_out;  // the most worth first
  double minutes = 0;                       // of those chosen
};

// Failures: "gate-budget" (not positive, or less than any case takes).
Result<CaseChoice> choose_cases(const std::vector<CaseHistory>& histories, double budget_minutes);

// A case a line; empty lines are passed over. Failures: "file-not-readable", "gate-cases-empty".
Result<std::vector<std::string>> read_chosen_cases(const std::filesystem::path& file);

// These cases and their pictures alone, in the results' order.
[[nodiscard]] Results only(const Results& results, const std::vector<std::string>& cases);

}  // namespace glisson::studies
