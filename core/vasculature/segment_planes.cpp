#include "vasculature/internal/segment_planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson::vasculature {

using Eigen::Vector3d;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

}  // namespace

const PlaneParameters mean_planes = {40, 4,     0.09, 0.07, 131, 1,  180, -5, 97, -1, -9, -0.05,
                                     -9, -0.05, -17,  0.03, 2.6, 10, -10, 8,  30, 24, 52};
const PlaneParameters plane_spread = {7, 4,    0.08, 0.03, 8,   5, 2, 2,  9, 9, 5, 0.04,
                                      6, 0.03, 7,    0.1,  0.4, 5, 5, 12, 4, 2, 8};

SegmentPlanes::SegmentPlanes(const LiverFrame& liver, const PlaneParameters& parameters)
    : p_(parameters),
      base_mm_(liver.centroid_mm.x(), liver.at({0, 0.6, 0}).y(), liver.centroid_mm.z()),
      left_normal_(Vector3d(p_[left_normal_x], 1, p_[left_normal_z]).normalized()),
      scale_(liver.scale()) {}

SegmentPlanes::Place SegmentPlanes::place(const Vector3d& patient_mm) const {
  Place place;
  place.from_base = (patient_mm - base_mm_) / scale_;
  const double z = place.from_base.z();
  place.x = place.from_base.x() - p_[cava_x] - p_[cava_lean_x] * z;
  place.y = place.from_base.y() - p_[cava_y] - p_[cava_lean_y] * z;
  place.azimuth_deg = std::atan2(-place.y, place.x) * degrees;
  if (place.azimuth_deg < -90) place.azimuth_deg += 360;
  place.away = std::hypot(place.x, place.y);
  place.in_caudate = {(place.x - p_[caudate_x]) / p_[caudate_width], (place.y - p_[caudate_y]) / p_[caudate_depth],
                      (z - p_[caudate_z]) / p_[caudate_height]};
  return place;
}

int segment_at(const SurfaceLevels& levels_mm) {
  if (levels_mm[caudate_border] < 0) return 1;
  if (levels_mm[middle_vein] > 0) {
    if (levels_mm[right_vein] > 0) return levels_mm[posterior_level] > 0 ? 7 : 6;
    return levels_mm[anterior_level] > 0 ? 8 : 5;
  }
  if (levels_mm[umbilical_fissure] > 0) return 4;
  return levels_mm[left_vein] > 0 ? 2 : 3;
}

int SegmentPlanes::at(const Vector3d& patient_mm) const {
  const Place place = this->place(patient_mm);
  if (place.in_caudate.squaredNorm() < 1) return 1;
  const double z = place.from_base.z(), up = z / 100;
  if (place.azimuth_deg > p_[middle_deg] + p_[middle_tilt] * up) {
    if (place.azimuth_deg > p_[right_deg] + p_[right_tilt] * up) {
      return z > p_[posterior_height] + p_[posterior_slope] * place.away ? 7 : 6;
    }
    return z > p_[anterior_height] + p_[anterior_slope] * place.away ? 8 : 5;
  }
  if (place.azimuth_deg > p_[left_deg] + p_[left_tilt] * up) return 4;
  return place.from_base.dot(left_normal_) > p_[left_offset] ? 2 : 3;
}

SurfaceLevels SegmentPlanes::levels_mm(const Vector3d& patient_mm) const {
  const Place place = this->place(patient_mm);
  const double z = place.from_base.z(), up = z / 100;
  const auto from = [&](double azimuth) {
    const double angle = std::clamp((place.azimuth_deg - azimuth) / degrees, -1.5, 1.5);
    return scale_ * place.away * std::sin(angle);
  };
  // Along the ray from the caudate's centre.
  const double axes = place.in_caudate.norm();
  const double from_center =
      place.in_caudate.cwiseProduct(Vector3d(p_[caudate_width], p_[caudate_depth], p_[caudate_height])).norm();
  const double from_caudate = axes > 1e-6 ? from_center * (1 - 1 / axes) : -p_[caudate_depth];
  return {from(p_[middle_deg] + p_[middle_tilt] * up),
          from(p_[right_deg] + p_[right_tilt] * up),
          from(p_[left_deg] + p_[left_tilt] * up),
          scale_ * (place.from_base.dot(left_normal_) - p_[left_offset]),
          scale_ * (z - p_[anterior_height] - p_[anterior_slope] * place.away),
          scale_ * (z - p_[posterior_height] - p_[posterior_slope] * place.away),
          scale_ * from_caudate};
}

Vector3d SegmentPlanes::on_axis_mm(double height) const {
  return base_mm_ +
         scale_ * Vector3d(p_[cava_x] + p_[cava_lean_x] * height, p_[cava_y] + p_[cava_lean_y] * height, height);
}

}  // namespace glisson::vasculature
