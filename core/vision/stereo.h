#pragma once
// A pair of pictures to points in left-camera mm. They are rectified, matched both ways round by semi-global matching
// (Hirschmueller 2008), and smoothed along edges (weighted least squares, Min et al. 2014). Only what both ways agree
// on is kept.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "vision/calibration.h"
#include "vision/frame.h"
#include "vision/masks.h"

namespace glisson::vision {

// At which size the pictures are matched. Half the size takes a fifth of the time; the disparities are then brought to
// full size along the picture's edges.
enum class MatchingSize {
  automatic,  // half for pictures wider than 640 pixels
  full,
  half
};

struct StereoOptions {
  double nearest_mm = 30;              // a laparoscope is not held closer
  double farthest_mm = 300;            // nor does it see organs farther away
  double largest_disagreement_px = 1;  // between left-to-right and right-to-left, at the size that was matched
  double minimum_confidence = 0.5;
  MatchingSize size = MatchingSize::automatic;
  MaskOptions masks;
  // One point every so many pixels. Where that is more than one, each point's disparity is refined to a tenth of a
  // pixel or so (internal/subpixel.h); of all pixels it would take seconds.
  int step_px = 1;
};

struct StereoCloud {
  std::vector<Eigen::Vector3d> points_mm;           // left camera
  std::vector<double> confidence;                   // 0..1, one a point
  std::vector<std::array<std::uint8_t, 3>> colour;  // red, green, blue
  std::vector<std::array<int, 3>> triangles;        // between neighbouring pixels, not across steps in depth
  std::vector<std::array<int, 2>> pixels;           // x and y in `picture`, one a point
  Frame picture;                                    // the rectified left picture
  MaskedShares masked;                              // of the picture
  double valid_fraction = 0;                        // of the pixels that are not masked
};

// The function for many pairs of one camera: what depends on the camera alone is worked out once.
class StereoMatcher {
 public:
  // Failures: "stereo-range" (depths that cannot be), "stereo-calibration-size" (the calibration says another size, or
  // its principal point lies outside pictures of this size), "stereo-failed".
  static Result<StereoMatcher> prepare(const StereoCalibration& calibration, int width, int height,
                                       const StereoOptions& options = {});

  StereoMatcher(StereoMatcher&&) noexcept;
  StereoMatcher& operator=(StereoMatcher&&) noexcept;
  ~StereoMatcher();

  // Failures: "stereo-image-sizes" (not the size that was prepared for, or the two differ), "stereo-failed". Not to be
  // called from two threads at once.
  Result<StereoCloud> cloud(const Frame& left, const Frame& right);

 private:
  struct Inside;
  explicit StereoMatcher(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

// One pair, from files. Failures: those of read_frame, prepare and cloud.
Result<StereoCloud> stereo_cloud(const std::filesystem::path& left, const std::filesystem::path& right,
                                 const StereoCalibration& calibration, const StereoOptions& options = {});

}  // namespace glisson::vision
