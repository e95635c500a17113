#pragma once
// A plane as a hand sets it: how far from the middle of the liver, and the two angles of its normal.
//
// All in patient coordinates (LPS, mm). `turn_deg` goes about the axis from feet to head: at 0 the normal points to the
// patient's left, at 90 to the back. `tilt_deg` raises it: at 90 it points to the head.

#include <array>
#include <Eigen/Core>

#include "geometry/surface.h"

namespace glisson::widgets {

struct CutPlane {
  Eigen::Vector3d middle_mm{0, 0, 0};  // of the liver
  double shift_mm = 0;                 // along the normal, from there
  double turn_deg = 0;
  double tilt_deg = 0;

  [[nodiscard]] Eigen::Vector3d normal() const;
  [[nodiscard]] Eigen::Vector3d point_mm() const { return middle_mm + shift_mm * normal(); }

  // Through that point, across that direction (of any length but zero).
  void put(const Eigen::Vector3d& through_mm, const Eigen::Vector3d& normal);
};

// Where a plane meets a slice: the point of their line nearest to the plane's own, and the way the line runs. The
// line's length is zero where they are nearly parallel.
struct LineInSlice {
  Eigen::Vector3d at_mm{0, 0, 0};
  Eigen::Vector3d along{0, 0, 0};  // unit, or zero
};
[[nodiscard]] LineInSlice line_in_slice(const CutPlane& plane, const Eigen::Vector3d& slice_point_mm,
                                        const Eigen::Vector3d& slice_normal);

// What of the plane lies within a box, to be drawn. Its middle comes first, then six corners around it, so that it
// stays the same triangles wherever it moves. Where it passes the box by: a small square about its point.
[[nodiscard]] std::array<Eigen::Vector3d, 7> points_within(const CutPlane& plane, const geometry::Box& box);
[[nodiscard]] geometry::Surface part_within(const CutPlane& plane, const geometry::Box& box);

}  // namespace glisson::widgets
