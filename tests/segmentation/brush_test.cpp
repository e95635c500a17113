// Drawing in place, judged voxel by voxel by the slow, obvious question.

#include "segmentation/brush.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "segmentation/edit.h"
#include "segmentation/structures.h"
#include "slanted_grid.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

imaging::Volume two_tissues() {
  imaging::Volume image;
  image.grid = slanted_grid();
  for (int k = 0; k < 18; ++k)
    for (int j = 0; j < 26; ++j)
      for (int i = 0; i < 30; ++i)
        image.values.push_back((i < 15 ? 40.0F : 100.0F) + static_cast<float>((i * 7 + j * 3 + k) % 5));
  return image;
}

// The way from a to b walked in small steps: within the radius of any of them.
bool near_way(const Vector3d& at, const Vector3d& a, const Vector3d& b, double radius) {
  for (int step = 0; step <= 4000; ++step) {
    if ((at - a - (b - a) * step / 4000.0).norm() <= radius) return true;
  }
  return false;
}

TEST(Brush, DrawsABallAlongItsWayAndNamesTheBoxItMayHaveChanged) {
  const Grid grid = slanted_grid();
  const Dab dab{grid.position_mm(Vector3d(8.2, 9.1, 6.3)), grid.position_mm(Vector3d(19.4, 14.8, 9.9)), 4.05, {}};
  Mask mask = empty_mask();
  const IndexBox box = draw(mask, dab, Paint::add);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const bool expected = near_way(grid.position_mm(i, j, k), dab.from_mm, dab.to_mm, dab.radius_mm);
        ASSERT_EQ(mask.at(i, j, k) != 0, expected) << i << " " << j << " " << k;
        if (!expected) continue;
        ASSERT_TRUE(box.first[0] <= i && i <= box.last[0] && box.first[1] <= j && j <= box.last[1] &&
                    box.first[2] <= k && k <= box.last[2]);
      }
  draw(mask, dab, Paint::take_away);
  EXPECT_EQ(voxel_count(mask), 0u);
}

// In a slice that is tilted against the grid: the voxels that its plane goes through, round as it is looked at.
TEST(Brush, ADiscInATiltedPlaneIsRoundThereAndOneVoxelThick) {
  const Grid grid = slanted_grid();
  const Vector3d normal = (grid.direction * Vector3d(0.3, 0.5, 0.8)).normalized();
  const Vector3d middle = grid.position_mm(Vector3d(14.2, 12.1, 8.6));
  const Vector3d along = normal.unitOrthogonal();
  const Dab dab{middle - 3 * along, middle + 3 * along, 5.05, {}, normal};
  Mask mask = empty_mask();
  const IndexBox box = draw(mask, dab, Paint::add);
  std::size_t drawn = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        // The plane goes through a voxel whose corners lie on both of its sides.
        bool above = false, below = false;
        for (int corner = 0; corner < 8; ++corner) {
          const Vector3d at(i + (corner & 1) - 0.5, j + ((corner >> 1) & 1) - 0.5, k + (corner >> 2) - 0.5);
          const double height = normal.dot(grid.position_mm(at) - middle);
          above = above || height >= 0;
          below = below || height <= 0;
        }
        const Vector3d center = grid.position_mm(i, j, k);
        const Vector3d in_plane = center - normal * normal.dot(center - middle);
        const bool expected = above && below && near_way(in_plane, dab.from_mm, dab.to_mm, dab.radius_mm);
        ASSERT_EQ(mask.at(i, j, k) != 0, expected) << i << " " << j << " " << k;
        if (!expected) continue;
        ++drawn;
        ASSERT_TRUE(box.first[0] <= i && i <= box.last[0] && box.first[1] <= j && j <= box.last[1] &&
                    box.first[2] <= k && k <= box.last[2]);
      }
  EXPECT_GT(drawn, 30u);
}

TEST(Brush, ADiscStaysInItsLayerOnEachAxis) {
  const Grid grid = slanted_grid();
  for (const int axis : {0, 1, 2}) {
    const Vector3d index(12.3, 11.6, 8.4);
    Mask mask = empty_mask();
    draw(mask, {grid.position_mm(index), grid.position_mm(index), 4.1, axis}, Paint::add);
    Vector3d center = index;
    center[axis] = std::round(center[axis]);
    std::size_t drawn = 0;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          const Vector3d at(i, j, k);
          const bool expected =
              at[axis] == center[axis] && (grid.position_mm(at) - grid.position_mm(center)).norm() <= 4.1;
          ASSERT_EQ(mask.at(i, j, k) != 0, expected);
          drawn += expected ? 1U : 0U;
        }
    EXPECT_GT(drawn, 10u);
  }
}

TEST(Brush, OutsideOfTheImageOrWithoutSizeNothingHappens) {
  for (const Dab& dab : {Dab{{1e6, 0, 0}, {1e6, 0, 0}, 5, {}}, Dab{{1e6, 0, 0}, {1e6, 0, 0}, 5, 1},
                         Dab{{10, -20, 30}, {10, -20, 30}, 0, {}}, Dab{{NAN, 0, 0}, {0, 0, 0}, 5, {}}}) {
    Mask mask = empty_mask();
    EXPECT_TRUE(draw(mask, dab, Paint::add).empty());
    EXPECT_EQ(voxel_count(mask), 0u);
  }
}

TEST(Brush, TheSmartBrushKeepsToTheTissueUnderTheClick) {
  const imaging::Volume image = two_tissues();
  const Vector3d click = image.grid.position_mm(Vector3d(13, 12, 8));
  const auto range = grey_range_at(image, click);
  ASSERT_TRUE(range);
  EXPECT_GT(range->low, 30);
  EXPECT_LT(range->high, 60);
  Mask mask = empty_mask(), all = empty_mask();
  const Dab dab{click, image.grid.position_mm(Vector3d(17, 12, 8)), 5, {}};
  draw(mask, dab, Paint::add, Only{image, *range});
  draw(all, dab, Paint::add);
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    const auto grey = static_cast<double>(image.values[voxel]);
    ASSERT_EQ(mask.values[voxel] != 0, all.values[voxel] != 0 && grey >= range->low && grey <= range->high);
  }
  EXPECT_GT(voxel_count(mask), 20u);
  EXPECT_LT(voxel_count(mask), voxel_count(all));
  EXPECT_FALSE(grey_range_at(image, {1e4, 0, 0}));
}

// Distances by trying every pair of cells.
double slow_signed_distance_mm(const Mask& mask, int axis, int layer, const Eigen::Vector3i& at) {
  const Grid& grid = mask.grid;
  const bool inside = mask.at(at[0], at[1], at[2]) != 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if ((axis == 0 ? i : axis == 1 ? j : k) != layer || (mask.at(i, j, k) != 0) == inside) continue;
        const double far = (grid.position_mm(i, j, k) - grid.position_mm(at.cast<double>())).norm();
        nearest = std::min(nearest, far);
      }
  return inside ? -nearest : nearest;
}

TEST(Edit, FillsBetweenLayersAsMixedDistancesSay) {
  Grid grid = slanted_grid();
  grid.size = {14, 12, 11};
  for (const int axis : {0, 1, 2}) {
    Mask drawn = empty_mask(grid);
    const auto place = [&](double along, double across) {
      Vector3d index(5 + across, 5, 5);
      index[axis] = along;
      if (axis == 0) index[1] = 5 + across;
      return grid.position_mm(index);
    };
    draw(drawn, {place(2, -1), place(2, -1), 3.2, axis}, Paint::add);
    draw(drawn, {place(7, 1), place(7, 1), 4.4, axis}, Paint::add);
    const Mask filled = fill_between_layers(drawn, axis);
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          Eigen::Vector3i at(i, j, k);
          const int layer = at[axis];
          bool expected = drawn.at(i, j, k) != 0;
          if (layer > 2 && layer < 7) {
            Eigen::Vector3i before = at, after = at;
            before[axis] = 2;
            after[axis] = 7;
            const double share = (layer - 2) / 5.0;
            const double mixed = (1 - share) * slow_signed_distance_mm(drawn, axis, 2, before) +
                                 share * slow_signed_distance_mm(drawn, axis, 7, after);
            if (std::abs(mixed) < 1e-5) continue;  // single precision decides there
            expected = mixed <= 0;
          }
          ASSERT_EQ(filled.at(i, j, k) != 0, expected) << axis << ": " << i << " " << j << " " << k;
        }
    EXPECT_GT(voxel_count(filled), 2 * voxel_count(drawn));
  }
}

TEST(Edit, KeepsThePickedPieceOrDropsTheSmallOnes) {
  const Grid grid = slanted_grid();
  Mask mask = empty_mask();
  const Vector3d big = grid.position_mm(Vector3d(8, 8, 8)), small = grid.position_mm(Vector3d(24, 20, 8));
  draw(mask, {big, big, 6, {}}, Paint::add);
  const std::size_t of_big = voxel_count(mask);
  draw(mask, {small, small, 2.5, {}}, Paint::add);
  const std::size_t of_small = voxel_count(mask) - of_big;
  ASSERT_GT(of_small, 5u);
  EXPECT_EQ(voxel_count(keep_piece_at(mask, small).value()), of_small);
  EXPECT_EQ(voxel_count(keep_piece_at(mask, big).value()), of_big);
  EXPECT_EQ(keep_piece_at(mask, grid.position_mm(Vector3d(0, 25, 0))).error().code, "edit-no-piece-there");
  EXPECT_EQ(keep_piece_at(mask, {1e6, 0, 0}).error().code, "edit-no-piece-there");
  EXPECT_EQ(voxel_count(without_small_pieces(mask, 0.2)), of_big);
  EXPECT_EQ(voxel_count(without_small_pieces(mask, 0.0)), of_big + of_small);
}

// Straight along the layers it takes as many of them as it is deep; at a slant, what has its centre that deep.
TEST(Edit, ACutGoesAsDeepAsItIsTold) {
  const Grid grid = slanted_grid();
  Mask mask = empty_mask();
  const Vector3d middle = grid.position_mm(Vector3d(14, 12, 8));
  draw(mask, {middle, middle, 9, {}}, Paint::add);
  Outline square;
  for (const auto& [i, j] : {std::pair(5, 5), std::pair(14, 5), std::pair(14, 20), std::pair(5, 20)}) {
    square.points_mm.push_back(grid.position_mm(Vector3d(i + 0.5, j + 0.5, 8)));
  }
  square.direction = grid.direction.col(2);
  const Mask through = cut(mask, square, CutSide::inside);
  EXPECT_LT(voxel_count(through), voxel_count(mask));
  const double layer_mm = grid.spacing_mm.z();
  const auto is_cut_where = [&](const Outline& outline, const auto& deep_enough) {
    const Mask whole = cut(mask, {outline.points_mm, outline.direction}, CutSide::inside);
    const Mask part = cut(mask, outline, CutSide::inside);
    std::size_t left = 0;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          if (part.at(i, j, k) != (deep_enough(i, j, k) ? whole.at(i, j, k) : mask.at(i, j, k))) return false;
          left += part.at(i, j, k) != whole.at(i, j, k) ? 1U : 0U;
        }
    return left > 0;
  };
  square.from_mm = -0.5 * layer_mm;
  square.to_mm = 0.5 * layer_mm;
  EXPECT_TRUE(is_cut_where(square, [](int, int, int k) { return k == 8; }));
  square.to_mm = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_cut_where(square, [](int, int, int k) { return k >= 8; }));
  square.from_mm = -std::numeric_limits<double>::infinity();
  square.to_mm = 1.5 * layer_mm;
  EXPECT_TRUE(is_cut_where(square, [](int, int, int k) { return k <= 9; }));

  const Vector3d slant = (grid.direction.col(2) + 0.4 * grid.direction.col(0)).normalized();
  for (Vector3d& corner_mm : square.points_mm) corner_mm -= slant * slant.dot(corner_mm - middle);
  square.direction = slant;
  square.from_mm = -2;
  square.to_mm = 3;
  EXPECT_TRUE(is_cut_where(square, [&](int i, int j, int k) {
    const double along_mm = slant.dot(grid.position_mm(i, j, k) - middle);
    return along_mm >= -2 && along_mm <= 3;
  }));
}

}  // namespace
}  // namespace glisson::segmentation
