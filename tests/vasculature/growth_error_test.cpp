// How far the growth of a segment is off when both studies are parted by Glisson: real livers (livers_couinaud, the
// judging half; real_livers.h) with their left part drawn out by a known factor and seen on another grid. What the
// drawn segments, carried along, grew by is the truth.
//
// What docs/territories.md says of it is printed with GLISSON_JUDGE=growth.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "real_livers.h"
#include "support/data.h"
#include "support/drawn_out.h"
#include "vasculature/center_lines.h"

namespace glisson::test {
namespace {

constexpr double grown_by = 1.379;  // as remnants do on average (van Lienden et al. 2013)

double centroid_x_mm(const imaging::Mask& liver) {
  double sum = 0, voxels = 0;
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        if (liver.at(i, j, k) == 0) continue;
        sum += liver.grid.position_mm(i, j, k).x();
        ++voxels;
      }
    }
  }
  return sum / voxels;
}

// In another scan, which has slices thicker by a quarter.
RealLiver grown(const RealLiver& liver) {
  const DrawnOut growth{centroid_x_mm(liver.liver), grown_by};
  const imaging::Grid grid = growth.other_grid(liver.liver.grid, 1.25);
  RealLiver after{growth.carried(liver.segments, grid), growth.carried(liver.liver, grid), {}, {}};
  if (!liver.vessels.values.empty()) after.vessels = growth.carried(liver.vessels, grid);
  return after;
}

std::array<double, 9> volumes_ml(const imaging::LabelMap& map) {
  std::array<double, 9> ml{};
  for (const std::uint16_t value : map.values) {
    if (value >= 1 && value <= 8) ml.at(value) += map.grid.voxel_volume_mm3() / 1000;
  }
  return ml;
}

std::array<double, 9> found_ml(const RealLiver& liver) {
  if (liver.vessels.values.empty()) return volumes_ml(vasculature::couinaud_segments(liver.liver).value().segment);
  const auto graph = vasculature::center_lines(liver.vessels).value();
  return volumes_ml(vasculature::explain_vessels(graph, liver.liver).value().segments.segment);
}

// Percentage points by which the found change of these segments together is off.
double off(const std::array<std::array<double, 9>, 4>& ml, std::initializer_list<std::size_t> segments) {
  std::array<double, 4> sum{};
  for (std::size_t of = 0; of < 4; ++of) {
    for (const std::size_t s : segments) sum[of] += ml[of][s];
  }
  return std::abs(100 * (sum[1] / sum[0] - sum[3] / sum[2]));
}

double ninth_of_ten(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(std::ceil(0.9 * static_cast<double>(values.size()))) - 1);
}

struct Errors {
  std::vector<double> segment, remnant;
  void add(const RealLiver& liver) {
    const RealLiver after = grown(liver);
    // Found before and after, drawn before and after.
    const std::array<std::array<double, 9>, 4> ml{found_ml(liver), found_ml(after), volumes_ml(liver.segments),
                                                  volumes_ml(after.segments)};
    for (std::size_t s = 1; s <= 8; ++s) segment.push_back(off(ml, {s}));
    remnant.push_back(off(ml, {1, 2, 3, 4}));  // what a right hemihepatectomy leaves, and an extended one
    remnant.push_back(off(ml, {2, 3}));
  }
  void print(const char* what) const {
    fmt::print(
        "{}: livers {}, change of a segment off by {:.1f} points (median), {:.1f} in nine of ten; of a remnant "
        "{:.1f}, {:.1f}\n",
        what, remnant.size() / 2, median(segment), ninth_of_ten(segment), median(remnant), ninth_of_ten(remnant));
    std::fflush(stdout);
  }
};

TEST(RealLivers, GrowByWhatIsKnown) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const RealLiver liver = read_real_liver(real_livers(Kind::with_vessels, Half::judging).front());
  const auto before = volumes_ml(liver.segments), after = volumes_ml(grown(liver).segments);
  double sum_before = 0, sum_after = 0;
  for (std::size_t s = 1; s <= 8; ++s) sum_before += before[s], sum_after += after[s];
  // The segments on the left's far side grow by all of it, those on the right by nothing; to the voxels' size.
  EXPECT_NEAR(after[2] / before[2], grown_by, 0.03);
  EXPECT_NEAR(after[6] / before[6], 1, 0.03);
  EXPECT_GT(sum_after / sum_before, 1.1);
}

TEST(RealLivers, GrowthJudged) {
  const char* which = std::getenv("GLISSON_JUDGE");
  if (which == nullptr || std::string(which) != "growth") GTEST_SKIP() << "set GLISSON_JUDGE=growth: takes minutes";
  GLISSON_NEEDS_DATA("livers_couinaud");
  Errors shape, trees;
  for (const std::string& name : real_livers(Kind::without_vessels, Half::judging)) shape.add(read_real_liver(name));
  shape.print("shape");
  for (const std::string& name : real_livers(Kind::with_vessels, Half::judging)) trees.add(read_real_liver(name));
  trees.print("vessels");
  EXPECT_LT(median(shape.segment), 100);
}

}  // namespace
}  // namespace glisson::test
