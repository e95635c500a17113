// Means of what counts near by, against sums over every voxel.

#include "segmentation/internal/half_step.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace glisson::segmentation {

TEST(LocalMean, IsThatOfTheGaussianSurroundingsAlsoInSmallVoxels) {
  constexpr double sd_mm = 4;
  for (const double spacing_mm : {0.7, 3.0}) {  // in blocks, and voxel by voxel
    const int along = static_cast<int>(30 / spacing_mm);
    imaging::Image<float> image{{{along, along, along}, Eigen::Vector3d::Constant(spacing_mm), {0, 0, 0}}, {}};
    std::mt19937 random(4);
    std::normal_distribution<float> noise(0, 5);
    std::vector<float> counts;
    for (int k = 0; k < along; ++k) {
      for (int j = 0; j < along; ++j) {
        for (int i = 0; i < along; ++i) {
          const Eigen::Vector3d at_mm = image.grid.position_mm(i, j, k);
          image.values.push_back(static_cast<float>(50 + 2 * at_mm.x() - at_mm.z()) + noise(random));
          counts.push_back(at_mm.x() + at_mm.y() < 30 ? 1.0F : 0.0F);  // one side of a slanted border
        }
      }
    }
    const std::vector<float> found = local_mean(image, counts, sd_mm);
    for (const Eigen::Vector3d& at_mm : {Eigen::Vector3d(15, 15, 15), {10, 18, 12}, {18, 10, 20}}) {
      const Eigen::Vector3i at = (at_mm / spacing_mm).array().round().cast<int>();
      const Eigen::Vector3d here_mm = image.grid.position_mm(at.x(), at.y(), at.z());
      double sum = 0, weight = 0;
      for (int k = 0; k < along; ++k) {
        for (int j = 0; j < along; ++j) {
          for (int i = 0; i < along; ++i) {
            const std::size_t voxel = image.grid.offset(i, j, k);
            const double far_mm2 = (image.grid.position_mm(i, j, k) - here_mm).squaredNorm();
            const double share = static_cast<double>(counts[voxel]) * std::exp(-far_mm2 / (2 * sd_mm * sd_mm));
            sum += share * static_cast<double>(image.values[voxel]);
            weight += share;
          }
        }
      }
      // The recursive blur is off by 1 % of its height, and goes on beyond the grid: a fraction of the noise.
      EXPECT_NEAR(found[image.grid.offset(at.x(), at.y(), at.z())], sum / weight, 1.0) << spacing_mm;
    }
  }
}

}  // namespace glisson::segmentation
