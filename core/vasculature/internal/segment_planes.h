#pragma once
// Couinaud's segments as what parts them. Surfaces through the vena cava's axis stand for the right and middle hepatic
// veins and the umbilical fissure. Planes lie at the height of the portal branches, and one along the left hepatic
// vein. The caudate lies around the vena cava's front (Couinaud 1957; Strasberg 2000, HPB 2:333, for the names).
//
// All is counted from a base point, in units of the liver's scale. From right to left and in height it is level with
// the centroid. A long left lobe moves the liver's box more than its veins. From front to back it is at 0.6 of the box.
// There are 23 numbers, each with the mean and the spread that drawn segments of real livers have.

#include <array>
#include <Eigen/Core>

#include "vasculature/internal/liver_frame.h"

namespace glisson::vasculature {

enum Parameter : std::size_t {
  cava_x,  // the vena cava's axis from the base point, mm
  cava_y,
  cava_lean_x,  // mm a mm of height
  cava_lean_y,
  middle_deg,   // azimuth around the axis: 0 left, 90 front, 180 right
  middle_tilt,  // degrees on 100 mm of height
  right_deg,
  right_tilt,
  left_deg,
  left_tilt,
  anterior_height,   // of the border of V and VIII, mm
  anterior_slope,    // mm a mm away from the axis
  posterior_height,  // of VI and VII
  posterior_slope,
  left_offset,  // of the border of II and III along its normal, mm
  left_normal_x,
  left_normal_z,
  caudate_x,  // its centre from the axis at the base point's height
  caudate_y,
  caudate_z,
  caudate_width,  // half axes, mm
  caudate_depth,
  caudate_height,
  parameter_count
};

using PlaneParameters = std::array<double, parameter_count>;

// Mean and standard deviation of each number by itself, rounded, over the 35 livers of the tuning half. The model was
// fitted to their drawn segments (docs/territories.md). These are statistics of the kind that anatomists publish, no
// outline of anybody.
extern const PlaneParameters mean_planes, plane_spread;

// What parts segments: the middle and the right vein, the umbilical fissure, II and III, V and VIII, VI and VII, and I
// from the rest.
enum Surface : std::size_t {
  middle_vein,
  right_vein,
  umbilical_fissure,
  left_vein,
  anterior_level,
  posterior_level,
  caudate_border,
  surface_count
};

// How far a place is from each surface, roughly in mm, signed: above 0 it lies to the right of the first three, in II,
// VIII, VII, and outside of I.
using SurfaceLevels = std::array<double, surface_count>;

[[nodiscard]] int segment_at(const SurfaceLevels& levels_mm);  // 1 to 8

class SegmentPlanes {
 public:
  SegmentPlanes(const LiverFrame& liver, const PlaneParameters& parameters);

  [[nodiscard]] int at(const Eigen::Vector3d& patient_mm) const;  // segment_at(levels_mm()), in less time
  [[nodiscard]] SurfaceLevels levels_mm(const Eigen::Vector3d& patient_mm) const;
  // The vena cava's axis at a height above the base point, in mm at scale 1.
  [[nodiscard]] Eigen::Vector3d on_axis_mm(double height) const;

 private:
  struct Place {
    Eigen::Vector3d from_base;  // scaled
    double x, y;                // from the axis
    double azimuth_deg, away;
    Eigen::Vector3d in_caudate;  // in units of its half axes
  };
  [[nodiscard]] Place place(const Eigen::Vector3d& patient_mm) const;

  PlaneParameters p_;
  Eigen::Vector3d base_mm_, left_normal_;
  double scale_;
};

}  // namespace glisson::vasculature
