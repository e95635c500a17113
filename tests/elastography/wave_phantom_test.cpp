// The layered phantom is what it says: the wave equation on both sides of the plane, and nothing torn at it.

#include "elastography/wave_phantom.h"

#include <gtest/gtest.h>
#include <numbers>

namespace glisson::elastography {
namespace {

LayeredPhantom layered(const Eigen::Vector3d& at_mm, double step_mm) {
  LayeredPhantom phantom;
  phantom.grid = cube_grid(3, 3, step_mm, step_mm);
  phantom.grid.origin_mm += at_mm;
  phantom.lower_kPa = {12, 1.2};
  phantom.upper_kPa = {6, 0.6};
  phantom.plane_z_mm = 13;
  return phantom;
}

// Laplacian by differences over 2 mm, a twentieth of the wavelength: 1 % of it, and of single precision less.
TEST(LayeredPhantom, BothSidesObeyTheirOwnWaveEquation) {
  for (const double z : {4.0, 22.0}) {
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(0.4, 0.5, -1), Eigen::Vector3d(-0.3, 0.8, 1)}) {
      const LayeredPhantom phantom = layered({7, -5, z}, 2);
      const ComplexField u = refracted_wave(phantom, way.normalized());
      const auto at = [&](int i, int j, int k) { return Complex(u[phantom.grid.offset(i, j, k)]); };
      const Complex laplacian =
          (at(0, 1, 1) + at(2, 1, 1) + at(1, 0, 1) + at(1, 2, 1) + at(1, 1, 0) + at(1, 1, 2) - 6.0 * at(1, 1, 1)) / 4.0;
      const Complex k = wavenumber(60, z < 13 ? phantom.lower_kPa : phantom.upper_kPa);
      EXPECT_LT(std::abs(laplacian + k * k * at(1, 1, 1)), 0.02 * std::abs(k * k * at(1, 1, 1))) << z;
    }
  }
}

TEST(LayeredPhantom, MotionAndTractionGoThroughThePlane) {
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0.4, 0.5, -1), Eigen::Vector3d(-0.3, 0.8, 1)}) {
    const auto column = [&](double z) {
      const LayeredPhantom phantom = layered({3, 2, z}, 0.1);
      const ComplexField u = refracted_wave(phantom, way.normalized());
      return std::pair{Complex(u[phantom.grid.offset(1, 1, 1)]),
                       (Complex(u[phantom.grid.offset(1, 1, 2)]) - Complex(u[phantom.grid.offset(1, 1, 0)])) / 0.2};
    };
    const auto [below, slope_below] = column(13 - 0.1001);
    const auto [above, slope_above] = column(13 + 0.1001);
    EXPECT_LT(std::abs(above - below), 0.05 * std::abs(below));
    const Complex traction_below = Complex(12, 1.2) * slope_below, traction_above = Complex(6, 0.6) * slope_above;
    EXPECT_LT(std::abs(traction_above - traction_below), 0.05 * std::abs(traction_below));
    // The slopes themselves jump.
    EXPECT_GT(std::abs(slope_above), 1.5 * std::abs(slope_below));
  }
}

TEST(LayeredPhantom, WithoutAJumpThePlaneIsNotThere) {
  LayeredPhantom phantom = layered({0, 0, 13}, 4);
  phantom.lower_kPa = phantom.upper_kPa;
  WavePhantom even;
  even.grid = phantom.grid;
  even.center_mm = {0, 0, 13};
  even.background_kPa = phantom.upper_kPa;
  const Eigen::Vector3d way = Eigen::Vector3d(0.4, 0.5, -1).normalized();
  const ComplexField u = refracted_wave(phantom, way), v = scattered_wave(even, way);
  for (std::size_t n = 0; n < u.size(); ++n) EXPECT_LT(std::abs(u[n] - v[n]), 1e-5F);
}

}  // namespace
}  // namespace glisson::elastography
