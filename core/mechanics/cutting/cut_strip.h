#pragma once
// One advance of a cut: what of its surface opens. Patient LPS, mm, at rest.

#include <Eigen/Core>

#include "geometry/cut_surface.h"
#include "geometry/surface.h"

namespace glisson::mechanics {

// The strip of a surface between two fronts, both straight across the way from one to the other.
struct CutStrip {
  geometry::CutSurface surface;
  Eigen::Vector3d from_mm{0, 0, 0};  // on the front where the strip begins
  Eigen::Vector3d to_mm{0, 0, 0};    // on the front where it ends
};

[[nodiscard]] bool lies_within(const CutStrip& strip, const Eigen::Vector3d& place_mm);  // between the fronts
// Whether an edge of the surface (at rest) passes through the strip.
[[nodiscard]] bool crosses(const CutStrip& strip, const geometry::Surface& surface);

}  // namespace glisson::mechanics
