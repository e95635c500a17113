#include "vision/picture_check.h"

#include <fmt/format.h>
#include <algorithm>
#include <opencv2/core.hpp>

#include "vision/internal/stereo_features.h"

namespace glisson::vision {

Result<PictureCheck> check_against_pictures(const StereoCalibration& calibration, const Frame& left,
                                            const Frame& right) {
  constexpr int features = 1500, fewest = 20;
  constexpr double ratio = 0.75, on_line_px = 3;
  PictureCheck check;
  try {
    const Features in_left = find_features(left, features), in_right = find_features(right, features);
    std::vector<Eigen::Vector2d> left_px, right_px;
    for (const auto& [a, b] :
         mutual_pairs(in_left.descriptors, in_right.descriptors, ratio, [](int, int) { return true; })) {
      left_px.push_back(in_left.pixels[static_cast<std::size_t>(a)]);
      right_px.push_back(in_right.pixels[static_cast<std::size_t>(b)]);
    }
    check.matches = static_cast<int>(left_px.size());
    if (left_px.empty()) return check;
    std::vector<double> off_px;
    int on_line = 0, in_front = 0;
    for (const Sighting& sighting : Triangulator(calibration)(left_px, right_px)) {
      off_px.push_back(sighting.epipolar_px);
      if (sighting.epipolar_px > on_line_px) continue;
      ++on_line;
      if (sighting.position_mm.z() > 0 && (calibration.left_to_right * sighting.position_mm).z() > 0) ++in_front;
    }
    const auto middle = off_px.begin() + static_cast<std::ptrdiff_t>(off_px.size() / 2);
    std::nth_element(off_px.begin(), middle, off_px.end());
    check.epipolar_px = *middle;
    check.in_front = on_line > 0 ? static_cast<double>(in_front) / on_line : 0;
  } catch (const cv::Exception& problem) {
    return failure("stereo-failed", GLISSON_TEXT("The pair could not be matched: {0}."), {problem.err});
  }
  if (check.matches < fewest) return check;
  if (check.epipolar_px > left.height / 50.0) {
    return failure(
        Error{"calibration-not-of-pictures",
              GLISSON_TEXT("The calibration is not of these pictures: half of the {0} features that both "
                           "show miss their epipolar lines by {1} pixels or more."),
              {std::to_string(check.matches), fmt::format("{:.1f}", check.epipolar_px)},
              GLISSON_TEXT("Check that the calibration is this camera's, at this size of picture, and that left and "
                           "right are not exchanged."),
              {}});
  }
  if (check.in_front < 0.5) {
    return failure(
        Error{"stereo-eyes-exchanged",
              GLISSON_TEXT("By the calibration, {0} % of what both pictures show would lie behind the "
                           "camera."),
              {fmt::format("{:.0f}", 100 * (1 - check.in_front))},
              GLISSON_TEXT("Left and right pictures are exchanged, or the calibration is of another camera."),
              {}});
  }
  return check;
}

}  // namespace glisson::vision
