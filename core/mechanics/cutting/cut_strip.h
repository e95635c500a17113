#pragma once
// One advance of a cut: what of its surface opens. Patient LPS, mm, at rest.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "geometry/cut_surface.h"
#include "geometry/surface.h"

namespace glisson::mechanics {

// The strip of a surface between two fronts, both straight across the way from one to the other. Of a swept line the
// fronts go straight in at the places of it that are nearest, and the strip ends where the line's way in does.
struct CutStrip {
  geometry::CutSurface surface;
  Eigen::Vector3d from_mm{0, 0, 0};  // on the front where the strip begins
  Eigen::Vector3d to_mm{0, 0, 0};    // on the front where it ends
};

[[nodiscard]] bool lies_within(const CutStrip& strip, const Eigen::Vector3d& place_mm);  // between the fronts

// Strips along one surface, or along a swept line that grew: what all of them cover.
class CutSoFar {
 public:
  explicit CutSoFar(const std::vector<CutStrip>& strips);
  [[nodiscard]] bool covers(const Eigen::Vector3d& place_mm) const;

 private:
  std::vector<CutStrip> strips_;                     // of a swept line the last alone
  std::vector<std::pair<double, double>> along_mm_;  // of a swept line, ascending and apart
};

// Whether an edge of the surface (at rest) passes through the strip.
[[nodiscard]] bool crosses(const CutStrip& strip, const geometry::Surface& surface);

}  // namespace glisson::mechanics
