#pragma once
// A cut drawn freehand: a line over the liver as it is seen from somewhere. The sheet parts the liver under it,
// straight away from the eye.
//
// Frame: patient coordinates, LPS, mm.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "planning/cut.h"

namespace glisson::planning {

// From the eye through one place of the line.
struct SightLine {
  Eigen::Vector3d through_mm{0, 0, 0};
  Eigen::Vector3d towards{0, 0, -1};  // away from the eye, any length but zero
};

// The sheet goes through where the lines of sight enter the liver first and leave it last, and half-way between. It
// does so at 4 to 10 places evenly along the drawn line. Of a line that begins or ends beside the liver, what lies over
// it counts. Failures: "line-misses" (less than 10 mm of it lie over the liver), "line-turns-back" (no sheet has two
// heights at one place), and those of geometry::CutSurface::through.
[[nodiscard]] Result<SheetCut> sheet_under(const geometry::Surface& liver, const std::vector<SightLine>& line);

}  // namespace glisson::planning
