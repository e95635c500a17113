#pragma once
// A guidance case on disk: an organ, what was seen of it in each frame, and the targets inside that are to be found.
// The format "glisson-guidance/1":
//
//   {"format": "glisson-guidance/1", "title": "...",
//    "model": {"mesh": "liver.vtu", "youngs_modulus_kPa": 10 or "name of a cell array", "poisson_ratio": 0.45},
//    "supports": [...], "gravity_m_s2": [x,y,z],      supports as in a scenario, fixed in the scan's frame
//    "features": [{"id": "falciform", "points": "falciform.csv"}],
//    "frames": [{"id": "f0", "time_s": 0, "points": "f0.ply", "noise_mm": 0.7, "pose_guess": [16 numbers, row-major,
//    scan to camera],
//                "features": [{"id": "falciform", "points": "f0_falciform.csv", "noise_mm": 1.5}],
//                "tools": [{"id": "retractor", "contact_mm": [x,y,z], "radius_mm": 10, "force_N": [x,y,z]}]}],
//    "targets": "targets.csv"}
//
// A frame has a "pose_guess" or "features", or a "time_s" after a frame with one: it is then searched from where that
// left the organ. Files are named from the folder of the JSON. Curves are tables x_mm,y_mm,z_mm; targets
// id,x_mm,y_mm,z_mm.

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/tissue.h"
#include "geometry/tetrahedra.h"
#include "guidance/frame.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::guidance {

struct Target {
  std::string id;
  Eigen::Vector3d at_rest_mm{0, 0, 0};
};

struct GuidanceCase {
  std::string title;
  geometry::TetMesh mesh;
  std::vector<double> youngs_kPa;  // one a cell
  double poisson_ratio = usual_poisson_ratio;
  std::vector<mechanics::Support> supports;  // where they are known: the body is free where there are none
  Eigen::Vector3d gravity_mm_s2{0, 0, 0};    // in the scan's frame, beyond that of the scan itself
  std::vector<SeenFrame> frames;
  std::vector<Target> targets;
  std::vector<Eigen::Vector3d> further_mm;  // at rest: places without a name whose error is wanted too, as of outlines
  std::vector<std::string> notes;           // what the file says and this version leaves out
};

// 16 numbers, row by row, as a rigid motion; nothing where they are none (mirrored, stretched, another count).
std::optional<Eigen::Isometry3d> rigid_pose(const std::vector<double>& numbers);

// Failures: "guidance-invalid" (what, where), those of reading meshes, clouds and tables.
Result<GuidanceCase> read_guidance(const std::filesystem::path& file);

}  // namespace glisson::guidance
