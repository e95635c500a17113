#include "anatomy/segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace glisson::anatomy {

using Eigen::Vector3d;

namespace {

// The value below which the given share of the others lies.
double quantile(std::vector<double> values, double share, double otherwise) {
  if (values.empty()) return otherwise;
  const auto rank = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

std::vector<Vector3d> voxels_inside(const Field& field) {
  std::vector<Vector3d> inside;
  const auto& size = field.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (field.at(i, j, k) < 0) inside.push_back(field.grid.position_mm(i, j, k));
      }
    }
  }
  return inside;
}

}  // namespace

Segments::Segments(std::shared_ptr<const LiverBody> body, const SegmentShares& shares)
    : liver_(std::move(body)),
      cava_(liver_->to_patient(liver_->shape.vena_cava())),
      left_normal_(Vector3d(-0.25, 0.8, 0.55).normalized()) {
  const LiverBody& liver = *liver_;
  const Vector3d fossa = liver.to_patient(liver.shape.gall_bladder().points_mm[15]);
  middle_azimuth_deg_ = azimuth_deg(fossa);

  std::vector<Vector3d> right, left;
  const std::vector<Vector3d> inside = voxels_inside(liver.distance_mm);
  for (const Vector3d& p : inside) {
    if (is_caudate(p)) continue;
    if (azimuth_deg(p) > middle_azimuth_deg_) {
      right.push_back(p);
    } else if (liver_->shape.umbilical_plane_mm(liver.to_shape(p)) > 0) {
      left.push_back(p);
    }
  }
  const auto measured = [](const std::vector<Vector3d>& places, auto measure) {
    std::vector<double> values;
    values.reserve(places.size());
    for (const Vector3d& p : places) values.push_back(measure(p));
    return values;
  };
  const auto azimuth = [&](const Vector3d& p) { return azimuth_deg(p); };
  const auto height = [](const Vector3d& p) { return p.z(); };
  right_azimuth_deg_ = quantile(measured(right, azimuth), 1 - shares.posterior_of_right, 180);
  const auto split = std::partition(right.begin(), right.end(),
                                    [&](const Vector3d& p) { return azimuth_deg(p) > right_azimuth_deg_; });
  posterior_height_mm_ = quantile(measured({right.begin(), split}, height), 1 - shares.seventh_of_posterior, fossa.z());
  anterior_height_mm_ = quantile(measured({split, right.end()}, height), 1 - shares.eighth_of_anterior, fossa.z());
  left_offset_mm_ = quantile(measured(left, [&](const Vector3d& p) { return p.dot(left_normal_); }),
                             1 - shares.second_of_left, fossa.dot(left_normal_));

  centroids_mm_.fill(Vector3d::Zero());
  for (const Vector3d& p : inside) {
    const auto s = static_cast<std::size_t>(at(p));
    centroids_mm_[s] += p;
    volumes_ml_[s] += 1;
  }
  const double voxel_ml = liver.distance_mm.grid.voxel_volume_mm3() / 1000;
  for (std::size_t s = 1; s <= 8; ++s) {
    if (volumes_ml_[s] > 0) centroids_mm_[s] /= volumes_ml_[s];
    volumes_ml_[s] *= voxel_ml;
  }
}

int Segments::at(const Vector3d& p) const {
  if (is_caudate(p)) return 1;
  if (azimuth_deg(p) > middle_azimuth_deg_) {
    if (azimuth_deg(p) > right_azimuth_deg_) return p.z() > posterior_height_mm_ ? 7 : 6;
    return p.z() > anterior_height_mm_ ? 8 : 5;
  }
  if (liver_->shape.umbilical_plane_mm(liver_->to_shape(p)) <= 0) return 4;
  return p.dot(left_normal_) > left_offset_mm_ ? 2 : 3;
}

Vector3d Segments::on_plane(Plane plane, double z_mm, double from_cava_mm) const {
  const double angle = (plane == Plane::right ? right_azimuth_deg_ : middle_azimuth_deg_) * std::numbers::pi / 180;
  Vector3d place = cava_at(z_mm) + from_cava_mm * Vector3d(std::cos(angle), -std::sin(angle), 0);
  place.z() = z_mm;
  return place;
}

Vector3d Segments::on_left_plane(const Vector3d& p) const {
  return p + (left_offset_mm_ - p.dot(left_normal_)) * left_normal_;
}

const Vector3d& Segments::centroid_mm(int segment) const { return centroids_mm_[static_cast<std::size_t>(segment)]; }
double Segments::volume_ml(int segment) const { return volumes_ml_[static_cast<std::size_t>(segment)]; }

// Around the vena cava, seen from above: 0 to the left, 90 to the front, 180 to the right, up to 270 behind.
double Segments::azimuth_deg(const Vector3d& p) const {
  const Vector3d from = p - cava_at(p.z());
  const double angle = std::atan2(-from.y(), from.x()) * 180 / std::numbers::pi;
  return angle < -90 ? angle + 360 : angle;
}

Vector3d Segments::cava_at(double z_mm) const {
  const auto& points = cava_.points_mm;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (z_mm > points[i].z() && i + 1 < points.size()) continue;
    const double t = std::clamp((z_mm - points[i - 1].z()) / (points[i].z() - points[i - 1].z()), 0.0, 1.0);
    return points[i - 1] + t * (points[i] - points[i - 1]);
  }
  return points.back();
}

// The lobe itself with its process, and what lies between porta, fissure and vena cava.
bool Segments::is_caudate(const Vector3d& patient_mm) const {
  const Vector3d p = liver_->to_shape(patient_mm);
  return liver_->shape.caudate().distance_mm(p) < 3 && p.y() > -20;
}

}  // namespace glisson::anatomy
