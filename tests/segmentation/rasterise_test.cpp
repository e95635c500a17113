#include "segmentation/rasterise.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "base/parallel.h"
#include "geometry/mesh_file.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

constexpr double pi = std::numbers::pi;

// A ball's surface: an octahedron whose triangles are split `times` and pushed out onto the sphere.
Surface sphere(const Vector3d& center_mm, double radius_mm, int times) {
  Surface surface;
  surface.points_mm = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  surface.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int split = 0; split < times; ++split) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(surface.points_mm.size()));
      if (is_new) {
        surface.points_mm.push_back(
            (surface.points_mm[static_cast<std::size_t>(a)] + surface.points_mm[static_cast<std::size_t>(b)])
                .normalized());
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : surface.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    surface.triangles = std::move(finer);
  }
  for (Vector3d& point : surface.points_mm) point = center_mm + radius_mm * point;
  return surface;
}

imaging::Grid rotated_grid() {
  imaging::Grid grid;
  grid.size = {70, 60, 50};
  grid.spacing_mm = {0.9, 1.1, 1.7};
  grid.direction = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  grid.origin_mm = -grid.direction * grid.spacing_mm.cwiseProduct(Vector3d(34.5, 29.5, 24.5));
  return grid;
}

double volume_mm3(const imaging::Mask& mask) {
  std::size_t voxels = 0;
  for (const auto value : mask.values) voxels += value;
  return static_cast<double>(voxels) * mask.grid.voxel_volume_mm3();
}

TEST(Rasterise, FillsExactlyTheVoxelsWhoseCentreLiesInTheBall) {
  const imaging::Grid grid = rotated_grid();
  const double radius_mm = 20;
  const imaging::Mask mask = rasterise(sphere({1, -2, 3}, radius_mm, 6), grid);
  // 32,768 triangles lie within 0.01 mm (sagitta: edge^2 / 8r) inside the sphere: a centre nearer than that to it may
  // fall on either side, every other one is decided.
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double distance_mm = (grid.position_mm(i, j, k) - Vector3d(1, -2, 3)).norm();
        if (std::abs(distance_mm - radius_mm) < 0.01) continue;
        ASSERT_EQ(mask.at(i, j, k) == 1, distance_mm < radius_mm) << i << " " << j << " " << k;
      }
  // Random rounding of about 3,000 surface voxels: well under 1 %.
  EXPECT_NEAR(volume_mm3(mask), 4.0 / 3.0 * pi * std::pow(radius_mm, 3), 0.005 * 33510);
}

// The octahedron's vertices, edges and faces fall exactly on voxel centres: each row through a vertex or an edge must
// still be crossed an even number of times.
TEST(Rasterise, DoesNotLeakWhereRowsMeetVerticesAndEdges) {
  imaging::Grid grid;
  grid.size = {25, 25, 25};
  grid.origin_mm = {-12, -12, -12};
  const imaging::Mask mask = rasterise(sphere({0, 0, 0}, 8, 0), grid);
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i) {
        const int distance = std::abs(i - 12) + std::abs(j - 12) + std::abs(k - 12);
        if (distance != 8) {
          ASSERT_EQ(mask.at(i, j, k) == 1, distance < 8) << i << " " << j << " " << k;
        }
      }
}

TEST(Rasterise, CutsWhatReachesOutOfTheGrid) {
  imaging::Grid grid;
  grid.size = {20, 20, 20};
  grid.origin_mm = {0, 0, 0};
  const imaging::Mask mask = rasterise(sphere({0, 0, 0}, 12, 5), grid);
  EXPECT_EQ(mask.at(0, 0, 0), 1);
  EXPECT_EQ(mask.at(19, 0, 0), 0);
  EXPECT_EQ(mask.at(11, 0, 0), 1);
  const imaging::Mask far_away = rasterise(sphere({1e9, -1e9, 0}, 12, 2), grid);
  EXPECT_EQ(volume_mm3(far_away), 0.0);
}

TEST(Rasterise, DecidesRowsThroughAHoleByTheOtherAxes) {
  const imaging::Grid grid = rotated_grid();
  Surface surface = sphere({0, 0, 0}, 18, 4);
  const imaging::Mask whole = rasterise(surface, grid);
  surface.triangles.erase(surface.triangles.begin() + 400, surface.triangles.begin() + 420);
  const imaging::Mask holed = rasterise(surface, grid);
  std::size_t different = 0;
  for (std::size_t voxel = 0; voxel < whole.values.size(); ++voxel) {
    different += whole.values[voxel] != holed.values[voxel] ? 1U : 0U;
  }
  // Some forty rows lead through the hole of 40 mm2; a leak would turn about twenty voxels of each.
  EXPECT_LT(different, 40U);
}

TEST(Rasterise, IsTheSameWhateverTheNumberOfThreads) {
  const imaging::Grid grid = rotated_grid();
  const Surface surface = sphere({1, 2, 3}, 19, 5);
  set_thread_count(1);
  const imaging::Mask alone = rasterise(surface, grid);
  set_thread_count(0);
  EXPECT_EQ(alone.values, rasterise(surface, grid).values);
}

// The volume of the voxels against the divergence theorem on the triangles, which knows nothing of voxels.
TEST(Rasterise, KeepsTheVolumeOfARealLiver) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const auto liver = geometry::read_surface(test::shared_data() / "liver_patient_models_ucl/models/Liver/liver.vtk");
  ASSERT_TRUE(liver) << liver.error().message();
  const geometry::Box box = geometry::bounding_box(liver->points_mm);
  imaging::Grid grid;
  grid.spacing_mm = {1.5, 1.5, 3};
  grid.direction = Eigen::AngleAxisd(0.2, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  grid.size = {260, 260, 130};
  grid.origin_mm = box.center_mm() - grid.direction * grid.spacing_mm.cwiseProduct(Vector3d(129.5, 129.5, 64.5));
  const imaging::Mask mask = rasterise(*liver, grid);
  const double truth_mm3 = std::abs(geometry::volume_mm3(*liver));
  // Each of some 40,000 surface voxels of 6.75 mm3 is off by half a voxel at random: far below 0.1 %.
  EXPECT_NEAR(volume_mm3(mask), truth_mm3, 1e-3 * truth_mm3);
}

}  // namespace
}  // namespace glisson::segmentation
