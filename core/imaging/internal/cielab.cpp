// CIE 15 (Lab), IEC 61966-2-1 (sRGB), and the white of D50 that sRGB is brought to by Bradford's transform.

#include "imaging/internal/cielab.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/LU>

namespace glisson::imaging {
namespace {

const Eigen::Array3d white_d50(0.96422, 1.0, 0.82521);

Eigen::Matrix3d xyz_from_linear_rgb() {
  Eigen::Matrix3d matrix;
  matrix << 0.4360747, 0.3850649, 0.1430804,  //
      0.2225045, 0.7168786, 0.0606169,        //
      0.0139322, 0.0971045, 0.7141733;
  return matrix;
}

constexpr double cube_root_from = 6.0 / 29.0;  // below it Lab is linear

double lab_curve(double t) {
  return t > std::pow(cube_root_from, 3) ? std::cbrt(t) : t / (3 * cube_root_from * cube_root_from) + 4.0 / 29.0;
}
double lab_curve_inverse(double f) {
  return f > cube_root_from ? f * f * f : 3 * cube_root_from * cube_root_from * (f - 4.0 / 29.0);
}
double linear_from_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double srgb_from_linear(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

std::uint16_t spread(double value, double low, double high) {
  return static_cast<std::uint16_t>(std::lround(std::clamp((value - low) / (high - low), 0.0, 1.0) * 65535));
}

}  // namespace

std::array<std::uint16_t, 3> cielab_from_srgb(const std::array<double, 3>& srgb) {
  Eigen::Vector3d linear;
  for (int i = 0; i < 3; ++i) linear[i] = linear_from_srgb(std::clamp(srgb[static_cast<std::size_t>(i)], 0.0, 1.0));
  const Eigen::Array3d f = ((xyz_from_linear_rgb() * linear).array() / white_d50).unaryExpr(&lab_curve);
  return {spread(116 * f[1] - 16, 0, 100), spread(500 * (f[0] - f[1]), -128, 127),
          spread(200 * (f[1] - f[2]), -128, 127)};
}

std::array<double, 3> srgb_from_cielab(const std::array<std::uint16_t, 3>& lab) {
  const double lightness = lab[0] / 65535.0 * 100;
  const double a = lab[1] / 65535.0 * 255 - 128, b = lab[2] / 65535.0 * 255 - 128;
  const double f = (lightness + 16) / 116;
  const Eigen::Array3d xyz = Eigen::Array3d(f + a / 500, f, f - b / 200).unaryExpr(&lab_curve_inverse) * white_d50;
  const Eigen::Vector3d linear = xyz_from_linear_rgb().inverse() * xyz.matrix();
  std::array<double, 3> srgb{};
  for (int i = 0; i < 3; ++i) {
    srgb[static_cast<std::size_t>(i)] = std::clamp(srgb_from_linear(std::clamp(linear[i], 0.0, 1.0)), 0.0, 1.0);
  }
  return srgb;
}

}  // namespace glisson::imaging
