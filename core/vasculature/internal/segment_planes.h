#pragma once
// Couinaud's segments as what parts them: surfaces through the vena cava's axis for the right and middle hepatic veins
// and the umbilical fissure, planes at the height of the portal branches, a plane along the left hepatic vein, and the
// caudate around the vena cava's front (Couinaud 1957; Strasberg 2000, HPB 2:333, for the names).
//
// All is counted from a base point in the liver's box, in units of the liver's scale; 23 numbers, with the mean and the
// spread that generated livers have.

#include <array>
#include <Eigen/Core>

#include "vasculature/liver_frame.h"

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

// Of generated patients 1 to 10, fitted to their segments and rounded; the spread is chosen two to five times theirs,
// since real livers vary more.
extern const PlaneParameters mean_planes, plane_spread;

class SegmentPlanes {
 public:
  SegmentPlanes(const LiverFrame& liver, const PlaneParameters& parameters);

  [[nodiscard]] int at(const Eigen::Vector3d& patient_mm) const;  // 1 to 8

  // How far from the surface of the middle or right vein or of the umbilical fissure, or from that of II and III,
  // roughly in mm, signed.
  enum Surface : std::size_t { middle, right, umbilical, left_vein };
  [[nodiscard]] std::array<double, 4> distances_mm(const Eigen::Vector3d& patient_mm) const;
  // A place in one of the three surfaces through the axis, or in one turned from it, by height and distance (scale 1).
  [[nodiscard]] Eigen::Vector3d on_surface_mm(Surface surface, double turned_deg, double height, double away) const;
  // The vena cava's axis at a height above the base point, in mm at scale 1.
  [[nodiscard]] Eigen::Vector3d on_axis_mm(double height) const;

 private:
  struct Place {
    Eigen::Vector3d from_base;  // scaled
    double x, y;                // from the axis
    double azimuth_deg, away;
  };
  [[nodiscard]] Place place(const Eigen::Vector3d& patient_mm) const;

  PlaneParameters p_;
  Eigen::Vector3d base_mm_, left_normal_;
  double scale_;
};

}  // namespace glisson::vasculature
