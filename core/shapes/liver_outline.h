#pragma once
// A liver's surface from its labels, with what makes it no shape to learn from or to fit said in a sentence.

#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::shapes {

struct OutlineOptions {
  double spacing_mm = 3;              // of the grid that the surface is taken from
  bool believe_unit_spacing = false;  // voxels of exactly 1 x 1 x 1 mm are what files that lost theirs say
};

struct LiverOutline {
  geometry::Surface surface;         // watertight, LPS, mm; where the image cuts the liver off, open
  geometry::Surface coarse;          // the same with twice the spacing, closed: to be matched
  double volume_ml = 0;              // of the voxels
  const char* cut_off_at = nullptr;  // the side of the patient ("the head") where the image ends before the liver does
};

// All labels but 0 together are the liver. Between voxels the signed distance is interpolated (Raya and Udupa, IEEE TMI
// 9:32, 1990), so that thick slices leave no stairs.
// Failures: "shapes-no-liver" (no voxel), "shapes-unit-spacing", "shapes-in-pieces" (a second piece of more than 1 %),
// "shapes-volume" (not 400 to 5000 ml, which no adult's liver is).
Result<LiverOutline> outline_of(const imaging::LabelMap& labels, const OutlineOptions& options = {});

// A closed surface without its flat ends. These are triangles within 1 mm of its highest or lowest place that face it.
// They count where together they are more than 3 % of the area. That is how a surface looks that an image cut off.
[[nodiscard]] geometry::Surface without_flat_ends(const geometry::Surface& surface);

}  // namespace glisson::shapes
