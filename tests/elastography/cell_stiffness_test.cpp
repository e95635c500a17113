#include "elastography/cell_stiffness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <random>

namespace glisson::elastography {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;
using imaging::Volume;
using testing::HasSubstr;

constexpr double poisson_ratio = 0.45;

Grid slanted_grid() {
  Grid grid;
  grid.size = {17, 14, 6};
  grid.spacing_mm = {1.64, 1.64, 10};  // the dissertation's MRE scans
  grid.origin_mm = {-20, 35, 12};
  grid.direction = Eigen::AngleAxisd(0.6, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  return grid;
}

// Every voxel another stiffness, so that a value tells its voxel.
Volume numbered_map(const Grid& grid) {
  Volume map{{grid, std::vector<float>(grid.voxels())}, "kPa"};
  for (std::size_t voxel = 0; voxel < map.values.size(); ++voxel) map.values[voxel] = 1.0F + static_cast<float>(voxel);
  return map;
}

Mask mask_of(const Grid& grid, std::uint8_t value) { return {grid, std::vector<std::uint8_t>(grid.voxels(), value)}; }

std::vector<Vector3d> random_points_mm(const Grid& grid, std::size_t count, double margin_voxels) {
  std::mt19937 random(7);
  std::vector<Vector3d> points_mm;
  for (std::size_t n = 0; n < count; ++n) {
    Vector3d index;
    for (int axis = 0; axis < 3; ++axis) {
      std::uniform_real_distribution<double> place(-0.5 - margin_voxels,
                                                   grid.size[static_cast<std::size_t>(axis)] - 0.5 + margin_voxels);
      index[axis] = place(random);
    }
    points_mm.push_back(grid.position_mm(index));
  }
  return points_mm;
}

TEST(CellStiffness, IsThatOfTheNearestVoxelAsTryingAllOfThemFinds) {
  const Volume map = numbered_map(slanted_grid());
  const std::vector<Vector3d> points_mm = random_points_mm(map.grid, 2000, 0.0);
  const auto found = cell_stiffness(points_mm, map);
  ASSERT_TRUE(found) << found.error().message();
  for (std::size_t n = 0; n < points_mm.size(); ++n) {
    double smallest_mm2 = INFINITY;
    double expected_kPa = 0;
    for (int k = 0; k < map.grid.size[2]; ++k)
      for (int j = 0; j < map.grid.size[1]; ++j)
        for (int i = 0; i < map.grid.size[0]; ++i) {
          const double squared_mm2 = (map.grid.position_mm(i, j, k) - points_mm[n]).squaredNorm();
          if (squared_mm2 >= smallest_mm2) continue;
          smallest_mm2 = squared_mm2;
          expected_kPa = 2 * static_cast<double>(map.at(i, j, k)) * (1 + poisson_ratio);
        }
    ASSERT_EQ(found->youngs_kPa[n], expected_kPa) << n;  // exactly: the same voxel, the same product
    ASSERT_EQ(found->source[n], StiffnessSource::measured);
  }
  EXPECT_EQ(found->cells_without_data, 0U);
}

TEST(CellStiffness, OutsideTheMapIsFilledFromItsEdgeAndCounted) {
  Volume map = numbered_map(slanted_grid());
  for (float& value : map.values) value = 2.1F;
  const std::vector<Vector3d> points_mm = random_points_mm(map.grid, 2000, 1.0);
  const auto found = cell_stiffness(points_mm, map);
  ASSERT_TRUE(found);
  std::size_t outside = 0;
  for (const Vector3d& point_mm : points_mm) {
    const Vector3d index = map.grid.index_of(point_mm);
    const Vector3d last(map.grid.size[0] - 0.5, map.grid.size[1] - 0.5, map.grid.size[2] - 0.5);
    outside += (index.array() < -0.5).any() || (index.array() > last.array()).any() ? 1U : 0U;
  }
  EXPECT_GT(outside, 100U);
  EXPECT_EQ(found->cells_outside_map, outside);
  EXPECT_EQ(found->cells_without_data, outside);
  // 2.1 kPa, blurred and divided in single precision.
  EXPECT_NEAR(found->min_kPa, 6.09, 1e-5);
  EXPECT_NEAR(found->max_kPa, 6.09, 1e-5);
}

// An organ of 2 kPa in a map whose outer 5 mm and all around it reads 9 kPa, as waves at a border make it.
TEST(CellStiffness, BorderIsFilledFromInside) {
  Grid grid;
  grid.size = {40, 40, 12};
  grid.spacing_mm = {2, 2, 5};
  grid.direction = slanted_grid().direction;
  grid.origin_mm = {5, 6, 7};
  Grid anatomy = grid;  // the organ is drawn on a finer grid than the map's
  anatomy.size = {80, 80, 24};
  anatomy.spacing_mm = {1, 1, 2.5};
  anatomy.origin_mm = grid.position_mm(Vector3d(-0.25, -0.25, -0.25));
  const Vector3d center_mm = grid.position_mm(Vector3d(19.5, 19.5, 5.5));
  const double radius_mm = 25;

  Volume map{{grid, std::vector<float>(grid.voxels(), 9.0F)}, "kPa"};
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        if ((grid.position_mm(i, j, k) - center_mm).norm() < radius_mm - 5) map.at(i, j, k) = 2.0F;
  Reliability reliability;
  reliability.organ = mask_of(anatomy, 0);
  std::vector<Vector3d> points_mm;
  std::size_t safely_inside = 0;
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 80; ++j)
      for (int i = 0; i < 80; ++i) {
        const double distance_mm = (anatomy.position_mm(i, j, k) - center_mm).norm();
        if (distance_mm > radius_mm) continue;
        reliability.organ->at(i, j, k) = 1;
        points_mm.push_back(anatomy.position_mm(i, j, k));
        // Half a diagonal of the map's voxel is 2.9 mm, one of the mask's 1.4 mm.
        safely_inside += distance_mm < radius_mm - 5 - 5 ? 1U : 0U;
      }

  // Of the border's 5 mm, voxels of the mask blur one: 7 mm is safe.
  for (const Filling filling : {Filling::nearest_reliable, Filling::local_average}) {
    StiffnessOptions options;
    options.filling = filling;
    options.unreliable_border_mm = 7;
    const auto found = cell_stiffness(points_mm, map, reliability, options);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_NEAR(found->min_kPa, 5.8, 1e-5);
    EXPECT_NEAR(found->max_kPa, 5.8, 1e-5);
    EXPECT_GT(found->cells_at_border, 0U);
    EXPECT_EQ(found->cells_without_data, found->cells_at_border);
    EXPECT_NEAR(found->filled_fraction,
                static_cast<double>(found->cells_at_border) / static_cast<double>(points_mm.size()), 1e-12);
  }
  StiffnessOptions trusting;
  trusting.unreliable_border_mm = 0;
  EXPECT_GT(cell_stiffness(points_mm, map, reliability, trusting)->max_kPa, 20);
  EXPECT_GT(safely_inside, 1000U);
}

TEST(CellStiffness, VoxelsWithoutValueOrConfidenceAreFilledAndCounted) {
  Volume map = numbered_map(slanted_grid());
  Reliability reliability;
  reliability.confident = mask_of(map.grid, 1);
  map.at(3, 3, 3) = 0;
  map.at(4, 3, 3) = -1;
  map.at(5, 3, 3) = std::numeric_limits<float>::quiet_NaN();
  reliability.confident->at(6, 3, 3) = 0;
  std::vector<Vector3d> points_mm;
  for (int i = 2; i < 8; ++i) points_mm.push_back(map.grid.position_mm(i, 3, 3));
  StiffnessOptions options;
  options.filling = Filling::nearest_reliable;
  const auto found = cell_stiffness(points_mm, map, reliability, options);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cells_without_value, 3U);
  EXPECT_EQ(found->cells_not_confident, 1U);
  EXPECT_EQ(found->cells_without_data, 4U);
  EXPECT_EQ(found->source.front(), StiffnessSource::measured);
  for (const double youngs_kPa : found->youngs_kPa) EXPECT_TRUE(std::isfinite(youngs_kPa) && youngs_kPa > 0);
}

TEST(CellStiffness, FillingByAveragesStaysWithinWhatWasMeasured) {
  Volume map = numbered_map(slanted_grid());
  Reliability reliability;
  reliability.confident = mask_of(map.grid, 0);
  reliability.confident->at(2, 2, 0) = 1;
  reliability.confident->at(14, 12, 5) = 1;
  const auto found = cell_stiffness(random_points_mm(map.grid, 500, 0.5), map, reliability);
  ASSERT_TRUE(found);
  EXPECT_GE(found->min_kPa, 2.9 * static_cast<double>(map.at(2, 2, 0)) * (1 - 1e-5));
  EXPECT_LE(found->max_kPa, 2.9 * static_cast<double>(map.at(14, 12, 5)) * (1 + 1e-5));
}

TEST(CellStiffness, RefusesAnotherFrameOfReferenceAndSaysHowFarItIs) {
  Grid grid;
  grid.size = {10, 10, 10};
  const Volume map = numbered_map(grid);  // from -0.5 to 9.5 mm
  const auto found = cell_stiffness({Vector3d(5, 5, 112.5), Vector3d(5, 5, 120)}, map);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "stiffness-no-overlap");
  EXPECT_THAT(found.error().message(), HasSubstr("103.0 mm"));  // 112.5 - 9.5
  EXPECT_THAT(found.error().advice(), HasSubstr("frames of reference"));
}

TEST(CellStiffness, RefusesWhatCannotBeUsed) {
  const Volume map = numbered_map(slanted_grid());
  const std::vector<Vector3d> points_mm = random_points_mm(map.grid, 5, 0.0);
  EXPECT_EQ(cell_stiffness({}, map).error().code, "stiffness-no-cells");
  EXPECT_EQ(cell_stiffness(points_mm, Volume{}).error().code, "stiffness-empty-map");
  EXPECT_EQ(cell_stiffness({Vector3d::Constant(std::nan(""))}, map).error().code, "stiffness-no-overlap");

  Volume sheared = map;
  sheared.grid.direction.col(2) = Vector3d(0.3, 0, 1).normalized();
  EXPECT_EQ(cell_stiffness(points_mm, sheared).error().code, "stiffness-bad-grid");

  StiffnessOptions options;
  options.poisson_ratio = 0.6;
  EXPECT_EQ(cell_stiffness(points_mm, map, {}, options).error().code, "stiffness-bad-options");

  Reliability none;
  none.confident = mask_of(map.grid, 0);
  EXPECT_EQ(cell_stiffness(points_mm, map, none).error().code, "stiffness-nothing-reliable");
}

TEST(CellStiffness, PopulationMeanAndUniformValues) {
  // E = 2 G (1 + nu): 2 * 2.1 * 1.45 and 2 * 2.6 * 1.45.
  EXPECT_NEAR(reference_youngs_kPa(PopulationMean::dissertation_cohort), 6.09, 1e-12);
  EXPECT_NEAR(reference_youngs_kPa(PopulationMean::published_cohort), 7.54, 1e-12);
  const CellStiffness uniform = uniform_stiffness(4, 5.0);
  EXPECT_EQ(uniform.youngs_kPa, std::vector<double>(4, 5.0));
  EXPECT_EQ(uniform.sd_kPa, 0.0);
  EXPECT_EQ(uniform.cells_without_data, 0U);
}

}  // namespace
}  // namespace glisson::elastography
