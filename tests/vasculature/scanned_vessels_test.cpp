// From a scan to trees: vessels found by their shape in scans of generated patients, and of their trees what is known.
// Tuned on patients 1 to 5; judged on others.
//
// What docs/territories.md says of it is printed with GLISSON_JUDGE=SEED, of patients SEED to SEED + 9.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cstdio>
#include <cstdlib>

#include "base/text.h"
#include "imaging/filters.h"
#include "known_scans.h"
#include "known_trees.h"
#include "segmentation/segment_vessels.h"
#include "segmentation/structures.h"
#include "vasculature/center_lines.h"

namespace glisson::test {
namespace {

struct ScanScore {
  double dice = 0;
  double volume = 0;  // found, as a share of the known
  double off = 0;     // share of what was found that lies 3 mm and more from every vessel of 1 mm radius
  TreeScore trees;
};

ScanScore score_of_scan(std::uint64_t seed, const Scanner& scanner) {
  const KnownScan scan = make_known_scan(seed, scanner);
  const auto found = segmentation::segment_vessels(scan.image, scan.liver).value();
  ScanScore score;
  score.dice = segmentation::dice(found.mask, scan.vessels).value();
  score.volume = found.volume_ml / segmentation::volume_ml(scan.vessels);
  const std::vector<float> away_mm2 = imaging::squared_distances_mm2(scan.vessels);
  double all = 0, off = 0;
  for (std::size_t n = 0; n < away_mm2.size(); ++n) {
    if (found.mask.values[n] == 0) continue;
    ++all;
    if (away_mm2[n] > 9) ++off;
  }
  score.off = off / all;
  const auto graph = vasculature::center_lines(found.mask).value();
  score.trees = score_of(vasculature::explain_vessels(graph, scan.liver).value().trees, scan.patient);
  return score;
}

TEST(ScannedVessels, BranchesAreFoundInACtWithoutAClick) {
  const ScanScore score = score_of_scan(12, portal_venous_ct());
  EXPECT_GT(score.trees.branches, 100);
  EXPECT_GT(score.trees.found, 0.9 * score.trees.branches);
  EXPECT_LT(score.off, 0.03);
  EXPECT_GT(score.dice, 0.75);
}

void print_judged(const char* what, const Scanner& scanner, int first) {
  ScanScore sum;
  constexpr int patients = 10;
  double worst_off = 0;
  for (int seed = first; seed < first + patients; ++seed) {
    const ScanScore score = score_of_scan(static_cast<std::uint64_t>(seed), scanner);
    fmt::print("{} {}: Dice {:.3f}, {:.0f} % of the volume, off {:.1f} %, branches {} of {}\n", what, seed, score.dice,
               100 * score.volume, 100 * score.off, score.trees.found, score.trees.branches);
    std::fflush(stdout);
    sum.dice += score.dice / patients, sum.volume += score.volume / patients, sum.off += score.off / patients;
    worst_off = std::max(worst_off, score.off);
    sum.trees.found += score.trees.found, sum.trees.branches += score.trees.branches;
    sum.trees.joins += score.trees.joins, sum.trees.wrong_joins += score.trees.wrong_joins;
    sum.trees.radius_error_mm += score.trees.radius_error_mm / patients;
    sum.trees.system_right += score.trees.system_right / patients;
  }
  fmt::print("{} of patients {} to {}: Dice {:.3f}, {:.0f} % of the volume, off {:.1f} % (worst {:.1f} %), ", what,
             first, first + patients - 1, sum.dice, 100 * sum.volume, 100 * sum.off, 100 * worst_off);
  fmt::print("{} branches, found {:.1f} %, wrong joins {:.1f} %, radius error {:.2f} mm, system right {:.1f} %\n",
             sum.trees.branches, 100.0 * sum.trees.found / sum.trees.branches,
             100.0 * sum.trees.wrong_joins / sum.trees.joins, sum.trees.radius_error_mm, 100 * sum.trees.system_right);
}

TEST(ScannedVessels, Judged) {
  const char* asked = std::getenv("GLISSON_JUDGE");
  const auto first = asked != nullptr ? read_whole_number<int>(asked) : std::nullopt;
  if (!first) GTEST_SKIP() << "set GLISSON_JUDGE=SEED, of the first of ten patients: takes minutes";
  print_judged("CT", portal_venous_ct(), *first);
  print_judged("MR", hepatobiliary_mr(), *first);
}

}  // namespace
}  // namespace glisson::test
