#pragma once
// Surfaces as people make them, with a few triangles doubled or turned, made fit for what walks along them.

#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "geometry/surface.h"

namespace glisson::geometry {

// Distances along a surface need one piece; structures such as vessels may lie in several.
enum class Pieces { one, several };

struct Mended {
  Surface surface;                // a manifold with all triangles of a piece turned alike; fields follow
  std::vector<int> point_from;    // of the surface as it was given, for each point
  std::vector<Sentence> remarks;  // what was done; empty where nothing was
};

// Doubled and flat-cornered triangles are left out, and points at the same place are joined. Triangles are turned to
// fit their neighbours, as most of their piece are. Sheets that only touch are parted, and loose points left out. Where
// one piece is wanted, crumbs are left out too: pieces that have not a hundredth of the area together. Points keep
// their order; new ones stand at the end. Orientation and splitting: CGAL's orient_polygon_soup (after Gueziec et al.
// 2001, "Cutting and stitching"). Failures: those of check_surface; "surface-in-pieces" (how many, and what share the
// largest has); "surface-flat" (no triangle has an area).
Result<Mended> mended(const Surface& surface, Pieces pieces = Pieces::one);

// The given surface with its points where the mended one's were moved to; what was left out goes with the nearest point
// that was not. `moved_mm` has one place a point of the mended surface.
[[nodiscard]] Surface carried_back(const Surface& given, const Mended& mended,
                                   const std::vector<Eigen::Vector3d>& moved_mm);

}  // namespace glisson::geometry
