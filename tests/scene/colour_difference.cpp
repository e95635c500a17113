#include "colour_difference.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace glisson::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double linear(double part) { return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4); }

double for_screen(double part) { return part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1 / 2.4) - 0.055; }

Vector3d linear(const scene::Colour& colour) { return {linear(colour.red), linear(colour.green), linear(colour.blue)}; }

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// 0 to 360.
double hue_deg(double a, double b) {
  const double angle = std::atan2(b, a) * 180 / std::numbers::pi;
  return angle < 0 ? angle + 360 : angle;
}

// The part of it that counts grey as less saturated: 1 for 0, 0 for very saturated colours.
double rotated_share(double chroma) {
  const double seventh = std::pow(chroma, 7);
  return std::sqrt(seventh / (seventh + std::pow(25.0, 7)));
}

}  // namespace

Vector3d cielab(const scene::Colour& colour) {
  Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vector3d of_white = to_xyz * linear(colour);
  const auto bent = [](double share) {
    return share > 216.0 / 24389 ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
  };
  const double x = bent(of_white.x() / 0.95047), y = bent(of_white.y()), z = bent(of_white.z() / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double ciede2000(const Vector3d& one, const Vector3d& other) {
  const double mean_chroma = (std::hypot(one.y(), one.z()) + std::hypot(other.y(), other.z())) / 2;
  const double stretch = 1 + 0.5 * (1 - rotated_share(mean_chroma));
  const double a1 = stretch * one.y(), a2 = stretch * other.y();
  const double chroma1 = std::hypot(a1, one.z()), chroma2 = std::hypot(a2, other.z());
  const bool both_have_hues = chroma1 * chroma2 > 0;
  const double hue1 = hue_deg(a1, one.z()), hue2 = hue_deg(a2, other.z());
  double hues_apart = both_have_hues ? hue2 - hue1 : 0;
  if (hues_apart > 180) hues_apart -= 360;
  if (hues_apart < -180) hues_apart += 360;
  double hue = (hue1 + hue2) / 2;
  if (!both_have_hues) {
    hue = hue1 + hue2;
  } else if (std::abs(hue1 - hue2) > 180) {
    hue += hue1 + hue2 < 360 ? 180 : -180;
  }
  const double chroma = (chroma1 + chroma2) / 2, from_middle = std::pow((one.x() + other.x()) / 2 - 50, 2);
  const double t = 1 - 0.17 * std::cos(radians(hue - 30)) + 0.24 * std::cos(radians(2 * hue)) +
                   0.32 * std::cos(radians(3 * hue + 6)) - 0.20 * std::cos(radians(4 * hue - 63));
  const double lightness_apart = (other.x() - one.x()) / (1 + 0.015 * from_middle / std::sqrt(20 + from_middle));
  const double chroma_apart = (chroma2 - chroma1) / (1 + 0.045 * chroma);
  const double hue_apart =
      2 * std::sqrt(chroma1 * chroma2) * std::sin(radians(hues_apart / 2)) / (1 + 0.015 * chroma * t);
  const double rotation = -2 * rotated_share(chroma) * std::sin(radians(60 * std::exp(-std::pow((hue - 275) / 25, 2))));
  return std::sqrt(lightness_apart * lightness_apart + chroma_apart * chroma_apart + hue_apart * hue_apart +
                   rotation * chroma_apart * hue_apart);
}

scene::Colour seen_without(const scene::Colour& colour, Lacks cones) {
  Matrix3d seen;
  switch (cones) {
    case Lacks::long_waves:
      seen << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
      break;
    case Lacks::middle_waves:
      seen << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
      break;
    case Lacks::short_waves:
      seen << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
      break;
  }
  const Vector3d light = (seen * linear(colour)).cwiseMax(0).cwiseMin(1);
  return {for_screen(light.x()), for_screen(light.y()), for_screen(light.z())};
}

}  // namespace glisson::test
