#pragma once
// Retraction as surgeons know it: which tool, where on the liver, which way it pulls.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::rehearsal {

struct ToolPreset {
  std::string id;        // "nathanson-retractor"
  std::string name;      // English
  double radius_mm = 0;  // of the disc of liver that the tool touches
  double usual_force_N = 0;
  double largest_force_N = 0;  // what a slider should end at
  std::string source;          // where the figures come from
};

// The Nathanson retractor, a grasper and a palpation probe; figures and sources in the .cpp.
[[nodiscard]] const std::vector<ToolPreset>& tool_presets();
[[nodiscard]] Result<ToolPreset> tool_preset(const std::string& id);

// A tool on the surface, ready to be given a force.
struct ToolPlacement {
  ToolPreset preset;
  Eigen::Vector3d center_mm{0, 0, 0};  // on the boundary, patient LPS
  Eigen::Vector3d direction{0, 0, 0};  // of the force, unit length
};

// The load of that placement for a force (N) along its direction.
[[nodiscard]] mechanics::ToolLoad tool_load(const ToolPlacement& placement, double force_N);

// Hoisting segment VI lifts the right, inferior, posterior part of the liver in Couinaud's numbering. It goes towards
// the front and the head, to bare the organ's rear (the retraction of section 4.4 of the dissertation). The rule, on
// the liver's boundary in LPS (x to the left, y to the back, z to the head; the patient supine):
//   1. each boundary triangle's centroid is placed in the liver's bounding box: r, p, i from 0 to 1 towards the
//      right, the back and the feet;
//   2. the triangles of the under-surface, whose normals point down or back, are scored r + p + i;
//   3. the centre is the area-weighted mean of the best-scored twentieth (by area), moved to its nearest triangle.
// The force points to the front and the head in equal parts. It is a rule of thumb on the shape alone, not a
// segmentation by the portal branches; the placement can be moved by hand.
Result<ToolPlacement> hoist_segment_vi(const geometry::TetMesh& liver);

}  // namespace glisson::rehearsal
