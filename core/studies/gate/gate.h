#pragma once
// Two versions' results case by case: what got worse, by how much, and whether chance would do as much.
//
// A metric got worse where its paired change (paired_test.h) passes its tolerance. Besides, corrected for all metrics
// (Holm), chance would show as much in fewer than `false_alarms` of all runs. Where there are too few cases for that,
// and where the tolerances ask for it, each case is held to the tolerance by itself. Where all values are above zero
// the change is that of their ratio. A registration that is 5 % worse is so for easy cases and for hard ones.
//
// What has no number (none beyond 1e100 either) is never averaged: cases that had one and lost it are counted, and
// count as worse.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "studies/gate/results.h"

namespace glisson::studies {

struct MetricTolerance {
  enum class Better { lower, higher, same } better = Better::lower;  // same: a change either way is for the worse
  double percent = 2;                                                // of the base's value
  std::optional<double> absolute;                                    // in the metric's unit, in place of the percentage
  bool each_case = false;                                            // no statistics: no case may pass the tolerance
};

struct GateOptions {
  double false_alarms = 0.05;  // over all metrics together
  std::map<std::string, MetricTolerance> metrics;
  double similarity = 0.9;  // that no sixteenth of a picture may fall below (vision/similarity.h)
  std::map<std::string, std::filesystem::path> masks;  // by a picture's NAME.png
};

// `metrics` by name: {"better": "lower" | "higher" | "same", "percent": 2, "absolute": 0.1, "each_case": true}; beside
// it "false_alarms", "similarity" and "masks". Failure: "tolerances-invalid".
Result<GateOptions> read_tolerances(const std::filesystem::path& file);

// Lower is better but for names that are measures of agreement (dice, correlation, ...).
MetricTolerance usual_tolerance(const std::string& metric);

enum class GateVerdict { same, better, worse, undecided };
const char* name_of(GateVerdict verdict);

struct MetricChange {
  std::string name;
  int cases = 0;                         // with a number in both
  double base = 0, now = 0;              // medians over these
  double difference = 0;                 // of the metric, in its unit
  std::array<double, 2> interval{0, 0};  // of 95 %
  double p = 1;                          // of so much worse by chance, corrected; 1 where each case was judged
  bool each_case = false;
  GateVerdict verdict = GateVerdict::same;
  std::vector<std::string> lost;    // cases that had a number
  std::vector<std::string> gained;  // that have one now
  int without = 0;                  // that have none in either
};

struct PictureChange {
  std::string name;  // CASE/NAME.png
  double similarity = 1;
  GateVerdict verdict = GateVerdict::same;
  std::string problem;  // why it could not be compared
};

// A case whose metric got worse the most, by its tolerance.
struct WorstCase {
  std::string id, metric;
  double base = 0, now = 0;
};

struct Gate {
  std::vector<MetricChange> metrics;
  std::vector<PictureChange> pictures;
  std::vector<WorstCase> worst;                  // at most one a metric that got worse, the worst first
  std::vector<std::string> only_base, only_now;  // cases that the other has not
  std::vector<std::string> notes;                // what a person should know before trusting it: whose results they are
  GateVerdict verdict = GateVerdict::same;
};

// Failures: "results-no-common-case", "results-other-data", "tolerance-without-metric" (neither has what it names),
// "cancelled".
Result<Gate> compare_results(const Results& base, const Results& now, const GateOptions& options = {},
                             const Progress& progress = {});

// Writes gate.html for people, gate.json, and junit.xml for CI. Pictures stand beside each other with their difference:
// those that differ the most, then those of the worst cases.
Result<void> write_gate(const Gate& gate, const Results& base, const Results& now, const GateOptions& options,
                        const std::filesystem::path& folder);

// The same as the command's answer, and one metric's as a line.
Json json_of(const Gate& gate);
std::string sentence_of(const MetricChange& change);

}  // namespace glisson::studies
