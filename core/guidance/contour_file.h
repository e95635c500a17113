#pragma once
// Pictures of an organ without depth, on disk, and what they tell. The format "glisson-contours/1":
//
//   {"format": "glisson-contours/1", "title": "...", "model": {"surface": "liver.obj"},
//    "camera": {"matrix": [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], "distortion": [k1, k2, p1, p2, k3]},
//    "features": [{"id": "falciform", "points": "falciform.csv"}],
//    "frames": [{"id": "f0", "pose_guess": [16 numbers, row-major, scan to camera],
//                "contours": [{"id": "falciform", "pixels": "f0_falciform.csv"}, {"id": "silhouette", ...}]}],
//    "targets": "targets.csv"}
//
// Files are named from the folder of the JSON. Curves are tables x_mm,y_mm,z_mm in the scan's frame; contours x_px,y_px
// as the camera took them, in any order; "silhouette" is the organ's outline. "pose_guess", "title" and "targets" may
// be absent. The answer, guidance.json:
//
//   {"format": "glisson-contours-answer/1", "frames": [{"id", "converged", "seconds", "pose": [16 numbers],
//    "contours": [{"id", "off_px", "off_mm", "left_out_px", "left_out_mm"}], "targets": [{"id", "position_mm"}],
//    "note"}]}
//
// `off`: mean distance of what was seen from where the pose puts it; null where the lens's distortion tells no
// direction, as in a corner: such pixels are not used. `left_out`: the same of a pose found without this contour, from
// the answer on; null where the others tell none. No picture says how far off a target is in depth: targets have no
// standard deviation.

#include <filesystem>

#include "base/json_forward.h"
#include "base/progress.h"
#include "guidance/contour_pose.h"
#include "guidance/guidance_file.h"

namespace glisson::guidance {

struct ContourFrame {
  std::string id;
  std::optional<Eigen::Isometry3d> pose_guess;
  std::vector<SeenContour> contours;
};

struct ContourCase {
  std::string title;
  geometry::Surface organ;
  vision::Camera camera;
  std::vector<ContourFrame> frames;
  std::vector<Target> targets;
};

// Whether a document says that it is one.
[[nodiscard]] bool holds_contours(const std::filesystem::path& file);

// Failures: "contours-invalid" (what, where), those of reading surfaces and tables.
Result<ContourCase> read_contours(const std::filesystem::path& file);

struct ContourAnswer {
  std::string id;
  double seconds = 0;
  Result<ContourPose> found;
  std::vector<std::optional<ContourError>> left_out;  // one a contour
};

// Failure: "cancelled".
Result<std::vector<ContourAnswer>> answer(const ContourCase& asked, const Progress& progress = {});

[[nodiscard]] Json answer_json(const ContourCase& asked, const std::vector<ContourAnswer>& answers);

}  // namespace glisson::guidance
