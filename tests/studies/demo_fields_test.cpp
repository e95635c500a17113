// What the demo patient is made of: noise of known spread, waves of known speed.

#include <gtest/gtest.h>
#include <cmath>

#include "base/noise.h"
#include "studies/demo/elastography.h"

namespace glisson::studies {
namespace {

using imaging::Mask;
using imaging::Volume;

TEST(DemoNoise, HasTheSpreadThatItsHeaderSays) {
  double sum = 0, squares = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d position(7.3 * i, 0.37 * i, -3.1 * i);
    const double value = smooth_noise(5, position, 10);
    ASSERT_LE(std::abs(value), 1);
    sum += value;
    squares += value * value;
  }
  // The standard error of the mean is 0.3 / sqrt(20000) = 0.002.
  EXPECT_NEAR(sum / count, 0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.05);
}

// One front through uniform tissue: the wave's length must be c / f = sqrt(G / rho) / f, which is 28.9 mm at 3 kPa
// and 60 Hz. From a plane the first-order scheme is exact; from a point it is a few percent late.
TEST(DemoWaves, TravelAtTheSpeedThatTheStiffnessGives) {
  Volume shear;
  shear.grid.size = {60, 40, 20};
  shear.grid.spacing_mm = {2, 2, 5};
  shear.values.assign(shear.grid.voxels(), 3.0f);
  const double speed_mm_s = std::sqrt(3.0) * 1000;

  Mask plane{shear.grid, std::vector<std::uint8_t>(shear.grid.voxels())};
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 40; ++j) plane.at(0, j, k) = 1;
  }
  EXPECT_NEAR(arrival_time_s(shear, 1000, plane).at(59, 20, 10), 118 / speed_mm_s, 1e-9);

  Mask point{shear.grid, std::vector<std::uint8_t>(shear.grid.voxels())};
  point.at(0, 0, 0) = 1;
  const double distance_mm = (shear.grid.position_mm(50, 30, 15) - shear.grid.position_mm(0, 0, 0)).norm();
  EXPECT_NEAR(arrival_time_s(shear, 1000, point).at(50, 30, 15) * speed_mm_s, distance_mm, 0.06 * distance_mm);
}

}  // namespace
}  // namespace glisson::studies
