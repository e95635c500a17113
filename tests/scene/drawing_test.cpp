// The outline of a mask in a layer: it parts what is inside from what is outside, and it is closed.

#include "scene/drawing.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace glisson::scene {
namespace {

using Eigen::Vector2d;

// How often the way from `a` to `b` crosses the pieces, in the plane of two axes.
int crossings(const std::vector<Vector2d>& ends, const Vector2d& a, const Vector2d& b) {
  const auto side = [](const Vector2d& from, const Vector2d& to, const Vector2d& at) {
    return (to.x() - from.x()) * (at.y() - from.y()) - (to.y() - from.y()) * (at.x() - from.x()) > 0;
  };
  int count = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    count +=
        side(a, b, ends[k]) != side(a, b, ends[k + 1]) && side(ends[k], ends[k + 1], a) != side(ends[k], ends[k + 1], b)
            ? 1
            : 0;
  }
  return count;
}

TEST(Drawing, TheOutlineOfALayerPartsInsideFromOutsideAndIsClosed) {
  std::mt19937 random(7);
  imaging::Mask mask;
  mask.grid.size = {11, 9, 8};
  mask.grid.spacing_mm = {1.5, 2, 3};
  mask.grid.origin_mm = {-4, 5, 60};
  for (std::size_t voxel = 0; voxel < mask.grid.voxels(); ++voxel) mask.values.push_back(random() % 3 == 0 ? 1 : 0);
  for (const int axis : {0, 1, 2}) {
    const int layer = 4;
    const int across = axis == 0 ? 1 : 0, along = axis == 2 ? 1 : 2;
    const auto ends_mm = outline_in_layer(mask, axis, layer);
    std::vector<Vector2d> ends;
    std::map<std::pair<long, long>, int> meeting;
    for (const Eigen::Vector3d& end : ends_mm) {
      const Eigen::Vector3d index = mask.grid.index_of(end);
      EXPECT_NEAR(index[axis], layer, 1e-9);
      ends.emplace_back(index[across], index[along]);
      ++meeting[{std::lround(2 * index[across]), std::lround(2 * index[along])}];
    }
    for (const auto& [place, count] : meeting) EXPECT_EQ(count % 2, 0);
    std::array<int, 3> voxel{};
    voxel[static_cast<std::size_t>(axis)] = layer;
    for (int b = 0; b < mask.grid.size[static_cast<std::size_t>(along)]; ++b) {
      for (int a = 0; a < mask.grid.size[static_cast<std::size_t>(across)]; ++a) {
        voxel[static_cast<std::size_t>(across)] = a;
        voxel[static_cast<std::size_t>(along)] = b;
        // Slanted, so that it meets no corner.
        const int crossed = crossings(ends, Vector2d(a, b), Vector2d(a + 41.234567, b + 17.7654321));
        ASSERT_EQ(crossed % 2 == 1, mask.at(voxel[0], voxel[1], voxel[2]) != 0) << axis << ": " << a << " " << b;
      }
    }
  }
  EXPECT_TRUE(outline_in_layer(mask, 2, -1).empty());
  EXPECT_TRUE(outline_in_layer(mask, 2, 8).empty());
}

}  // namespace
}  // namespace glisson::scene
