// Two studies of one liver, the second drawn out on one side by a known factor: every volume, share and rate against
// what the voxels of both say one by one.

#include "planning/growth.h"

#include <array>
#include <cmath>
#include <limits>

#include "parts_of_a_ball.h"
#include "support/drawn_out.h"

namespace glisson::planning {
namespace {

// Voxels of tissue without tumours, by octant (0: all) and with x above a place.
struct Counted {
  std::array<double, 9> segment_ml{};
  double above_ml = 0, tumour_ml = 0;
};

Counted counted(const LiverParts& parts, double x_mm) {
  Counted counted;
  const double ml = parts.liver.grid.voxel_volume_mm3() / 1000;
  for_each_voxel(parts.liver, [&](int i, int j, int k, const Eigen::Vector3d& at) {
    if (parts.tumours.front().mask.at(i, j, k) != 0) {
      counted.tumour_ml += ml;
      return;
    }
    counted.segment_ml[0] += ml;
    counted.segment_ml.at(parts.segments->at(i, j, k)) += ml;
    if (at.x() > x_mm) counted.above_ml += ml;
  });
  return counted;
}

LiverParts grown(const LiverParts& parts, double factor) {
  const test::DrawnOut growth{0.5, factor};  // between two voxels
  const imaging::Grid grid = growth.other_grid(parts.liver.grid);
  LiverParts after = parts;
  after.liver = growth.carried(parts.liver, grid);
  after.segments = growth.carried(*parts.segments, grid);
  after.tumours.front().mask = growth.carried(parts.tumours.front().mask, grid);
  after.trees = {};
  after.portal.reset();
  after.hepatic.reset();
  for (float& kPa : after.youngs_kPa->values) kPa *= kPa > 0 ? 1.5F : 1.0F;
  return after;
}

TEST(Growth, IsWhatTheVoxelsOfBothStudiesSay) {
  const LiverParts parts = parts_of_ball(), later = grown(parts, 1.4);
  const auto before = Planner::open(parts), after = Planner::open(later);
  ASSERT_TRUE(before && after);
  const std::vector<Cut> cuts{PlaneCut{{-5.5, 0, 0}, {1, 0, 0}, Removed::below}};
  GrowthOptions options;
  options.days = 21;
  options.segment_error_percent = 10;
  const auto growth = growth_between(*before, *after, RemnantCuts{cuts, cuts}, options);
  ASSERT_TRUE(growth) << growth.error().message();

  const Counted was = counted(parts, -5.5), is = counted(later, -5.5);
  EXPECT_NEAR(growth->tumours_before_ml, was.tumour_ml, 1e-9);
  EXPECT_NEAR(growth->tumours_after_ml, is.tumour_ml, 1e-9);
  EXPECT_NEAR(growth->liver.before.ml, was.segment_ml[0], 1e-9);
  EXPECT_NEAR(growth->liver.after.ml, is.segment_ml[0], 1e-9);
  EXPECT_NEAR(growth->liver.before_percent, 100, 1e-9);
  ASSERT_EQ(growth->segments.size(), 8u);
  for (const SegmentGrowth& segment : growth->segments) {
    const auto s = static_cast<std::size_t>(segment.number);
    EXPECT_NEAR(segment.part.before.ml, was.segment_ml[s], 1e-9) << s;
    EXPECT_NEAR(segment.part.after.ml, is.segment_ml[s], 1e-9) << s;
    EXPECT_NEAR(segment.part.before_percent, 100 * was.segment_ml[s] / was.segment_ml[0], 1e-9) << s;
    EXPECT_NEAR(segment.part.after_percent, 100 * is.segment_ml[s] / is.segment_ml[0], 1e-9) << s;
    // Octants of even number lie beyond x = 0, and grow by the factor, to a voxel's width at their border.
    ASSERT_TRUE(segment.part.change_percent());
    EXPECT_NEAR(*segment.part.change_percent(), s % 2 == 0 ? 40 : 0, 3) << s;
    EXPECT_EQ(segment.part.within_error, s % 2 != 0) << s;
    EXPECT_TRUE(segment.part.before.mean_kPa && segment.part.after.mean_kPa) << s;
  }
  ASSERT_TRUE(growth->remnant);
  EXPECT_FALSE(growth->remnant->part.within_error);  // nothing was said of its error
  const PartGrowth& remnant = growth->remnant->part;
  // The cut goes by the voxels' centres, so that they agree to the voxel.
  EXPECT_NEAR(remnant.before.ml, was.above_ml, 1e-9);
  EXPECT_NEAR(remnant.after.ml, is.above_ml, 1e-9);
  const double points = 100 * (is.above_ml / is.segment_ml[0] - was.above_ml / was.segment_ml[0]);
  EXPECT_GT(points, 3);
  EXPECT_NEAR(growth->remnant->hypertrophy_points(), points, 1e-9);
  EXPECT_NEAR(*growth->remnant->points_per_week, points / 3, 1e-9);
}

// As the papers have it: one whole for both studies, so that only the remnant's own growth counts.
TEST(Growth, IsOfAStandardVolumeWhereThatIsGiven) {
  const LiverParts parts = parts_of_ball(), later = grown(parts, 1.4);
  const auto before = Planner::open(parts), after = Planner::open(later);
  ASSERT_TRUE(before && after);
  GrowthOptions options;
  options.standard_liver_ml = 500;
  const RemnantCuts cuts{{SegmentsCut{{1, 3, 5, 7}}}, {SegmentsCut{{1, 3, 5, 7}}}};
  const auto growth = growth_between(*before, *after, cuts, options);
  ASSERT_TRUE(growth) << growth.error().message();
  const Counted was = counted(parts, 0), is = counted(later, 0);
  double points = 0;
  for (const std::size_t s : {2, 4, 6, 8}) points += 100 * (is.segment_ml[s] - was.segment_ml[s]) / 500;
  EXPECT_NEAR(growth->remnant->hypertrophy_points(), points, 1e-9);
  EXPECT_FALSE(growth->remnant->points_per_week);  // nobody said how many days
  EXPECT_NEAR(growth->liver.before_percent, was.segment_ml[0] / 5, 1e-9);
}

// A segment that only one study has keeps its row, and has no per cent.
TEST(Growth, KeepsASegmentThatOneStudyLacks) {
  LiverParts parts = parts_of_ball();
  const auto after = Planner::open(parts);
  for (std::uint16_t& segment : parts.segments->values) segment = segment == 3 ? std::uint16_t{1} : segment;
  const auto before = Planner::open(parts);
  ASSERT_TRUE(before && after);
  const auto growth = growth_between(*before, *after, std::nullopt);
  ASSERT_TRUE(growth);
  ASSERT_EQ(growth->segments.size(), 8u);
  EXPECT_EQ(growth->segments[2].part.before.ml, 0);
  EXPECT_GT(growth->segments[2].part.after.ml, 1);
  EXPECT_FALSE(growth->segments[2].part.change_percent());
  EXPECT_FALSE(growth->segments[2].part.within_error);
  EXPECT_FALSE(growth->remnant);
}

TEST(Growth, SaysWhatCannotBeAsked) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  const auto refused = [&](const GrowthOptions& options, const std::optional<RemnantCuts>& cuts = {}) {
    const auto growth = growth_between(*planner, *planner, cuts, options);
    return growth ? std::string() : growth.error().code;
  };
  GrowthOptions days, volume;
  for (const double bad : {0.0, -7.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    days.days = volume.standard_liver_ml = bad;
    EXPECT_EQ(refused(days), "growth-days") << bad;
    EXPECT_EQ(refused(volume), "growth-standard-volume") << bad;
  }
  EXPECT_EQ(refused({}, RemnantCuts{{SegmentsCut{{2}}}, {}}), "plan-empty");
  EXPECT_EQ(refused({}), "");
}

}  // namespace
}  // namespace glisson::planning
