#include "vision/stereo.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/disparity_filter.hpp>

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

struct Rectified {
  cv::Mat left, right;
  cv::Mat to_depth;         // Q of OpenCV: pixel and disparity to rectified left-camera mm
  Eigen::Matrix3d to_left;  // rectified left camera to left camera
};

struct Disparity {
  cv::Mat px;          // CV_32F, filtered; what does not hold is not finite
  cv::Mat confidence;  // CV_32F, 0..1
};

Result<cv::Mat> read_image(const fs::path& file);
Rectified rectify(const cv::Mat& left, const cv::Mat& right, const StereoCalibration& calibration);
Disparity match(const Rectified& pair, int disparities, double largest_disagreement_px);
cv::Mat usable_pixels(const cv::Mat& image, const StereoOptions& options);
StereoCloud cloud_of(const Rectified& pair, const Disparity& disparity, const cv::Mat& usable,
                     const StereoOptions& options);

}  // namespace

Result<StereoCloud> stereo_cloud(const fs::path& left, const fs::path& right, const StereoCalibration& calibration,
                                 const StereoOptions& options) {
  const auto left_image = read_image(left);
  if (!left_image) return failure(left_image.error());
  const auto right_image = read_image(right);
  if (!right_image) return failure(right_image.error());
  if (left_image->size() != right_image->size()) {
    return failure("stereo-image-sizes", GLISSON_TEXT("The left image is {0} x {1} pixels, the right one {2} x {3}."),
                   {std::to_string(left_image->cols), std::to_string(left_image->rows),
                    std::to_string(right_image->cols), std::to_string(right_image->rows)});
  }
  if (!(options.nearest_mm > 0) || !(options.farthest_mm > options.nearest_mm)) {
    return failure("stereo-range", GLISSON_TEXT("The nearest depth must be positive and less than the farthest."));
  }
  try {
    const Rectified pair = rectify(*left_image, *right_image, calibration);
    const double focal_px = pair.to_depth.at<double>(2, 3);
    const double most_px = focal_px * calibration.baseline_mm() / options.nearest_mm;
    const int most_disparities = std::max(16, pair.left.cols / 3 / 16 * 16);
    const int disparities = std::clamp(static_cast<int>(std::ceil(most_px / 16)) * 16, 16, most_disparities);
    const Disparity disparity = match(pair, disparities, options.largest_disagreement_px);
    return cloud_of(pair, disparity, usable_pixels(pair.left, options), options);
  } catch (const cv::Exception& problem) {
    return failure("stereo-failed", GLISSON_TEXT("The pair could not be matched: {0}."), {problem.err});
  }
}

namespace {

Result<cv::Mat> read_image(const fs::path& file) {
  cv::Mat image;
  try {
    if (fs::is_regular_file(file)) image = cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) {
    return failure(Error{"image-not-readable",
                         GLISSON_TEXT("The picture {0} cannot be read."),
                         {file.string()},
                         GLISSON_TEXT("PNG, JPEG, TIFF and BMP are read."),
                         file});
  }
  return image;
}

Rectified rectify(const cv::Mat& left, const cv::Mat& right, const StereoCalibration& calibration) {
  cv::Mat left_matrix, right_matrix, rotation, translation;
  cv::eigen2cv(calibration.left.matrix, left_matrix);
  cv::eigen2cv(calibration.right.matrix, right_matrix);
  cv::eigen2cv(Eigen::Matrix3d(calibration.left_to_right.linear()), rotation);
  cv::eigen2cv(Eigen::Vector3d(calibration.left_to_right.translation()), translation);
  const cv::Mat left_distortion(calibration.left.distortion, true),
      right_distortion(calibration.right.distortion, true);

  Rectified pair;
  cv::Mat turn_left, turn_right, project_left, project_right, map_x, map_y;
  cv::stereoRectify(left_matrix, left_distortion, right_matrix, right_distortion, left.size(), rotation, translation,
                    turn_left, turn_right, project_left, project_right, pair.to_depth, cv::CALIB_ZERO_DISPARITY, -1);
  cv::initUndistortRectifyMap(left_matrix, left_distortion, turn_left, project_left, left.size(), CV_32FC1, map_x,
                              map_y);
  cv::remap(left, pair.left, map_x, map_y, cv::INTER_LINEAR);
  cv::initUndistortRectifyMap(right_matrix, right_distortion, turn_right, project_right, left.size(), CV_32FC1, map_x,
                              map_y);
  cv::remap(right, pair.right, map_x, map_y, cv::INTER_LINEAR);
  cv::cv2eigen(turn_left, pair.to_left);
  pair.to_left.transposeInPlace();
  return pair;
}

Disparity match(const Rectified& pair, int disparities, double largest_disagreement_px) {
  constexpr int block = 5;
  constexpr int subpixel = 16;  // OpenCV counts disparities in sixteenths
  cv::Mat left, right;
  cv::cvtColor(pair.left, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(pair.right, right, cv::COLOR_BGR2GRAY);
  // Smoothness penalties as OpenCV's documentation sets them for one channel.
  const auto matcher = cv::StereoSGBM::create(0, disparities, block, 8 * block * block, 32 * block * block, 1, 31, 10,
                                              100, 2, cv::StereoSGBM::MODE_SGBM_3WAY);
  const auto back_matcher = cv::ximgproc::createRightMatcher(matcher);
  cv::Mat there, back, filtered;
  matcher->compute(left, right, there);
  back_matcher->compute(right, left, back);
  const auto filter = cv::ximgproc::createDisparityWLSFilter(matcher);
  filter->setLambda(8000);
  filter->setSigmaColor(1.5);
  filter->filter(there, pair.left, filtered, back);

  Disparity disparity;
  filtered.convertTo(disparity.px, CV_32F, 1.0 / subpixel);
  filter->getConfidenceMap().convertTo(disparity.confidence, CV_32F, 1.0 / 255);
  for (int y = 0; y < there.rows; ++y) {
    for (int x = 0; x < there.cols; ++x) {
      const double to_right_px = there.at<short>(y, x) / static_cast<double>(subpixel);
      const int in_right = x - static_cast<int>(std::lround(to_right_px));
      const bool inside = to_right_px > 0 && in_right >= 0 && in_right < back.cols;
      const double to_left_px = inside ? back.at<short>(y, in_right) / static_cast<double>(subpixel) : 0;
      if (!inside || std::abs(to_right_px + to_left_px) > largest_disagreement_px) {
        disparity.px.at<float>(y, x) = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return disparity;
}

// Neither the scope's black border nor a highlight with what it outshines.
cv::Mat usable_pixels(const cv::Mat& image, const StereoOptions& options) {
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  const cv::Mat darkest_channel = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  const cv::Mat brightest_channel = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  cv::Mat highlights;
  cv::dilate(darkest_channel >= options.highlight_brightness, highlights, cv::Mat(), {-1, -1}, 2);
  return (brightest_channel >= options.darkest) & ~highlights;
}

StereoCloud cloud_of(const Rectified& pair, const Disparity& disparity, const cv::Mat& usable,
                     const StereoOptions& options) {
  StereoCloud cloud;
  const double center_x = -pair.to_depth.at<double>(0, 3), center_y = -pair.to_depth.at<double>(1, 3);
  const double focal_px = pair.to_depth.at<double>(2, 3), depth_of_px = focal_px / pair.to_depth.at<double>(3, 2);
  const int step = std::max(1, options.step_px);
  const int columns = (pair.left.cols + step - 1) / step;
  std::vector<int> above(static_cast<std::size_t>(columns), -1), row(above);
  std::size_t looked_at = 0;
  const auto join = [&](int a, int b, int c) {
    if (a < 0 || b < 0 || c < 0) return;
    const auto depth_mm = [&](int point) { return cloud.points_mm[static_cast<std::size_t>(point)].z(); };
    const auto [nearest, farthest] = std::minmax({depth_mm(a), depth_mm(b), depth_mm(c)});
    if (farthest - nearest < 0.05 * nearest) cloud.triangles.push_back({a, b, c});
  };
  for (int y = 0; y < pair.left.rows; y += step, std::swap(above, row)) {
    for (int x = 0; x < pair.left.cols; x += step) {
      const auto column = static_cast<std::size_t>(x / step);
      row[column] = -1;
      if (usable.at<std::uint8_t>(y, x) == 0) continue;
      ++looked_at;
      const double px = disparity.px.at<float>(y, x);
      const double confidence = disparity.confidence.at<float>(y, x);
      if (!std::isfinite(px) || px <= 0 || confidence < options.least_confidence) continue;
      const double depth_mm = std::abs(depth_of_px) / px;
      if (depth_mm < options.nearest_mm || depth_mm > options.farthest_mm) continue;
      row[column] = static_cast<int>(cloud.points_mm.size());
      const Eigen::Vector3d rectified_mm(depth_mm * (x - center_x) / focal_px, depth_mm * (y - center_y) / focal_px,
                                         depth_mm);
      cloud.points_mm.emplace_back(pair.to_left * rectified_mm);
      cloud.confidence.push_back(confidence);
      const auto& blue_green_red = pair.left.at<cv::Vec3b>(y, x);
      cloud.colour.push_back({blue_green_red[2], blue_green_red[1], blue_green_red[0]});
      if (column == 0) continue;
      // Seen from the camera, that is from outside the tissue, counter-clockwise.
      join(above[column - 1], row[column - 1], above[column]);
      join(above[column], row[column - 1], row[column]);
    }
  }
  cloud.valid_fraction =
      looked_at > 0 ? static_cast<double>(cloud.points_mm.size()) / static_cast<double>(looked_at) : 0;
  return cloud;
}

}  // namespace
}  // namespace glisson::vision
