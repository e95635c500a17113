#pragma once
// How a planned cut is led through the liver while it is rehearsed. Its front goes straight along the plane, or along
// that which fits a sheet best, from the liver's lower front edge towards the upper back. A way of ours that suits most resections from the front and below;
// nothing is computed with it but where each advance begins and ends.

#include <Eigen/Core>

#include "base/result.h"
#include "geometry/cut_surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/cutting/opening.h"

namespace glisson::rehearsal {

struct CutCourse {
  geometry::CutSurface surface;
  Eigen::Vector3d begin_mm{0, 0, 0};  // on the plane, where the front first meets the liver
  Eigen::Vector3d forward{0, 0, 1};   // unit, within the plane
  double length_mm = 0;               // until it leaves the liver

  // From one distance along the way to another.
  [[nodiscard]] mechanics::CutStrip strip(double from_mm, double to_mm) const {
    return {surface, begin_mm + from_mm * forward, begin_mm + to_mm * forward};
  }
};

// At rest, patient LPS. Failure: "cut-misses" where the surface passes the liver by.
Result<CutCourse> course_of(const geometry::TetMesh& liver, const geometry::CutSurface& surface);

}  // namespace glisson::rehearsal
