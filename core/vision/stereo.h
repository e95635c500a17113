#pragma once
// A pair of pictures to points in left-camera mm: rectified, matched by semi-global matching (Hirschmueller 2008) both
// ways round, smoothed along edges, and only what both ways agree on is kept.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "vision/calibration.h"

namespace glisson::vision {

struct StereoOptions {
  double nearest_mm = 30;              // a laparoscope is not held closer
  double farthest_mm = 300;            // nor does it see organs farther away
  double largest_disagreement_px = 1;  // between left-to-right and right-to-left
  double least_confidence = 0.5;
  int highlight_brightness = 240;  // of 255, in all colours: a reflection, which shows nothing of the tissue
  int darkest = 10;                // below: the black border of the scope
  int step_px = 1;                 // one point every so many pixels
};

struct StereoCloud {
  std::vector<Eigen::Vector3d> points_mm;           // left camera
  std::vector<double> confidence;                   // 0..1, one a point
  std::vector<std::array<std::uint8_t, 3>> colour;  // red, green, blue
  std::vector<std::array<int, 3>> triangles;        // between neighbouring pixels, not across steps in depth
  double valid_fraction = 0;                        // of the pixels that are neither border nor highlight
};

// Failures: "image-not-readable", "stereo-image-sizes" (the two differ), "stereo-range" (depths that cannot be).
Result<StereoCloud> stereo_cloud(const std::filesystem::path& left, const std::filesystem::path& right,
                                 const StereoCalibration& calibration, const StereoOptions& options = {});

}  // namespace glisson::vision
