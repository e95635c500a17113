// Voronoi nodes of known shapes and of a real liver.

#include "mechanics/meshfree/voronoi_nodes.h"

#include <gtest/gtest.h>
#include <chrono>
#include <numeric>

#include "imaging/volume_file.h"
#include "meshing/labelled_shapes.h"
#include "support/data.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

imaging::Mask ball(double spacing_mm, double radius_mm) {
  imaging::LabelMap labels = glisson::test::empty_labels(spacing_mm, radius_mm + 2 * spacing_mm);
  glisson::test::paint_ball(labels, 1, Vector3d::Zero(), radius_mm);
  imaging::Mask mask;
  mask.grid = labels.grid;
  mask.values.assign(labels.values.begin(), labels.values.end());
  return mask;
}

double volume_mm3(const imaging::Mask& mask) {
  return static_cast<double>(std::accumulate(mask.values.begin(), mask.values.end(), 0L)) *
         mask.grid.voxel_volume_mm3();
}

TEST(VoronoiNodes, TheEnergyFallsInEveryRound) {
  const auto nodes = voronoi_nodes(ball(2, 40), {.nodes = 500, .maximum_rounds = 40, .minimum_gain = 0});
  ASSERT_TRUE(nodes);
  ASSERT_GT(nodes->energies_mm5.size(), 10U);
  for (std::size_t i = 1; i < nodes->energies_mm5.size(); ++i) {
    EXPECT_LE(nodes->energies_mm5[i], nodes->energies_mm5[i - 1]);
  }
}

TEST(VoronoiNodes, CellsTogetherAreTheBodyAndNoneIsEmpty) {
  const imaging::Mask mask = ball(2, 40);
  const auto nodes = voronoi_nodes(mask, {.nodes = 700});
  ASSERT_TRUE(nodes);
  ASSERT_EQ(nodes->positions_mm.size(), 700U);
  EXPECT_NEAR(std::accumulate(nodes->volumes_mm3.begin(), nodes->volumes_mm3.end(), 0.0), volume_mm3(mask), 1e-6);
  for (const double volume : nodes->volumes_mm3) EXPECT_GT(volume, 0);
  ASSERT_EQ(nodes->node_of_voxel.size(), mask.values.size());
  for (std::size_t i = 0; i < mask.values.size(); ++i) EXPECT_EQ(nodes->node_of_voxel[i] >= 0, mask.values[i] != 0);
}

TEST(VoronoiNodes, EachStandsAtTheCentroidOfTheVoxelsNearestToIt) {
  // Judged slowly: every voxel against every node. A settled decomposition moves no voxel worth mentioning.
  const imaging::Mask mask = ball(3, 30);
  const auto nodes = voronoi_nodes(mask, {.nodes = 60, .maximum_rounds = 500, .minimum_gain = 0});
  ASSERT_TRUE(nodes);
  EXPECT_EQ(nodes->stopped, VoronoiNodes::Stopped::settled);
  std::vector<Vector3d> sums(60, Vector3d::Zero());
  std::vector<int> counts(60, 0);
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (mask.at(i, j, k) == 0) continue;
        const Vector3d center = mask.grid.position_mm(i, j, k);
        std::size_t nearest = 0;
        for (std::size_t node = 1; node < 60; ++node) {
          if ((center - nodes->positions_mm[node]).norm() < (center - nodes->positions_mm[nearest]).norm()) {
            nearest = node;
          }
        }
        sums[nearest] += center;
        ++counts[nearest];
      }
    }
  }
  for (std::size_t node = 0; node < 60; ++node) {
    EXPECT_LT((sums[node] / counts[node] - nodes->positions_mm[node]).norm(), 0.05);
  }
}

TEST(VoronoiNodes, CellsComeOutNearlyEqual) {
  // Gersho's conjecture (1979): the best cells of an even density are all alike. Lloyd's iteration ends in a local
  // minimum near it, with a spread of volumes of a tenth or two.
  const imaging::Mask mask = ball(1.5, 40);
  const auto nodes = voronoi_nodes(mask, {.nodes = 1000});
  ASSERT_TRUE(nodes);
  const double mean = volume_mm3(mask) / 1000;
  double variance = 0;
  for (const double volume : nodes->volumes_mm3) variance += (volume - mean) * (volume - mean) / 1000;
  EXPECT_LT(std::sqrt(variance) / mean, 0.25);
}

TEST(VoronoiNodes, AsManyNodesAsVoxelsStandOnThem) {
  const imaging::Mask mask = ball(4, 14);
  const auto voxels = static_cast<int>(std::lround(volume_mm3(mask) / mask.grid.voxel_volume_mm3()));
  const auto nodes = voronoi_nodes(mask, {.nodes = voxels});
  ASSERT_TRUE(nodes);
  EXPECT_NEAR(nodes->energies_mm5.back(), 0, 1e-9);
  EXPECT_EQ(voronoi_nodes(mask, {.nodes = voxels + 1}).error().code, "voronoi-too-many-nodes");
}

TEST(VoronoiNodes, WhatCannotBeIsRefused) {
  EXPECT_EQ(voronoi_nodes(ball(2, 10), {.nodes = 0}).error().code, "voronoi-options");
  imaging::Mask nothing = ball(2, 10);
  std::fill(nothing.values.begin(), nothing.values.end(), std::uint8_t{0});
  EXPECT_EQ(voronoi_nodes(nothing, {}).error().code, "mask-empty");
}

TEST(VoronoiNodes, TenThousandInARealLiverTakeSeconds) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto labels = imaging::read_labels_file(glisson::test::shared_data() / "totalseg_abdomen_mr_ct" /
                                                "example_seg_fast_force_split.nii.gz");
  ASSERT_TRUE(labels) << labels.error().message();
  imaging::Mask liver;
  liver.grid = labels->grid;
  for (const std::uint16_t label : labels->values) liver.values.push_back(label == 5 ? 1 : 0);
  const auto start = std::chrono::steady_clock::now();
  const auto nodes = voronoi_nodes(liver, {.nodes = 10000});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(nodes);
  EXPECT_LT(seconds, 20);  // measured 0.3 s on two idle cores; the bound allows for a busy machine and sanitizers
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  for (const Vector3d& position : nodes->positions_mm) {
    const Vector3d index = liver.grid.index_of(position);
    EXPECT_TRUE(liver.grid.contains(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
                                    static_cast<int>(std::lround(index.z()))));
  }
}

}  // namespace
}  // namespace glisson::mechanics
