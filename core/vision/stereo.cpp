#include "vision/stereo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/ximgproc/disparity_filter.hpp>

#include "vision/internal/opencv.h"
#include "vision/internal/subpixel.h"

namespace glisson::vision {
namespace {

namespace fs = std::filesystem;

// How the camera's pictures become rectified ones.
struct Rectification {
  std::array<cv::Mat, 2> left_map, right_map;
  cv::Mat to_depth;         // Q of OpenCV: pixel and disparity to rectified left-camera mm
  Eigen::Matrix3d to_left;  // rectified left camera to left camera
};

// Semi-global matching both ways round, and the filter that smooths its answer.
struct Matchers {
  int shrink = 1;  // pictures are matched at this part of their size
  cv::Ptr<cv::StereoMatcher> there, back;
  cv::Ptr<cv::ximgproc::DisparityWLSFilter> filter;
};

struct Disparity {
  cv::Mat px;          // CV_32F, filtered; what does not hold is not finite
  cv::Mat confidence;  // CV_32F, 0..1
};

Rectification rectification(const StereoCalibration& calibration, int width, int height);
Matchers matchers(int disparities, int shrink);
Disparity match(const Matchers& matchers, const cv::Mat& left, const cv::Mat& right, double largest_disagreement_px);
void place_points(const Rectification& rectified, const cv::Mat& left, const Disparity& disparity,
                  const std::vector<std::uint8_t>& usable, const StereoOptions& options, StereoCloud& cloud);

}  // namespace

struct StereoMatcher::Inside {
  int width = 0, height = 0;
  StereoOptions options;
  Rectification rectified;
  Matchers matchers;
};

StereoMatcher::StereoMatcher(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
StereoMatcher::StereoMatcher(StereoMatcher&&) noexcept = default;
StereoMatcher& StereoMatcher::operator=(StereoMatcher&&) noexcept = default;
StereoMatcher::~StereoMatcher() = default;

Result<StereoMatcher> StereoMatcher::prepare(const StereoCalibration& calibration, int width, int height,
                                             const StereoOptions& options) {
  constexpr int wide = 640;  // pixels: above it, half the size keeps depths as good (subpixel) and ten pairs a second
  if (!(options.nearest_mm > 0) || !(options.farthest_mm > options.nearest_mm)) {
    return failure("stereo-range", GLISSON_TEXT("The nearest depth must be positive and less than the farthest."));
  }
  if (calibration.width > 0 && (calibration.width != width || calibration.height != height)) {
    return failure(Error{"stereo-calibration-size",
                         GLISSON_TEXT("The calibration is of pictures of {0} x {1} pixels; these have {2} x {3}."),
                         {std::to_string(calibration.width), std::to_string(calibration.height), std::to_string(width),
                          std::to_string(height)},
                         GLISSON_TEXT("Calibrate at the size of the video, or scale the calibration's matrices."),
                         {}});
  }
  for (const Camera* camera : {&calibration.left, &calibration.right}) {
    const double x = camera->matrix(0, 2), y = camera->matrix(1, 2);
    if (x > 0 && x < width && y > 0 && y < height) continue;
    return failure(Error{
        "stereo-calibration-size",
        GLISSON_TEXT("The calibration is of pictures of another size: its principal point {0}, {1} lies outside "
                     "{2} x {3} pixels."),
        {std::to_string(std::lround(x)), std::to_string(std::lround(y)), std::to_string(width), std::to_string(height)},
        GLISSON_TEXT("Calibrate at the size of the video, or scale the calibration's matrices."),
        {}});
  }
  try {
    auto inside = std::make_unique<Inside>();
    inside->width = width;
    inside->height = height;
    inside->options = options;
    inside->rectified = rectification(calibration, width, height);
    const bool half = options.size == MatchingSize::half || (options.size == MatchingSize::automatic && width > wide);
    const int shrink = half ? 2 : 1;
    const double focal_px = inside->rectified.to_depth.at<double>(2, 3);
    const double maximum_px = focal_px * calibration.baseline_mm() / options.nearest_mm / shrink;
    const int maximum_disparities = std::max(16, width / shrink / 3 / 16 * 16);
    inside->matchers =
        matchers(std::clamp(static_cast<int>(std::ceil(maximum_px / 16)) * 16, 16, maximum_disparities), shrink);
    return StereoMatcher(std::move(inside));
  } catch (const cv::Exception& problem) {
    return failure("stereo-failed", GLISSON_TEXT("The pair could not be matched: {0}."), {problem.err});
  }
}

Result<StereoCloud> StereoMatcher::cloud(const Frame& left, const Frame& right) {
  if (left.width != right.width || left.height != right.height) {
    return failure("stereo-image-sizes", GLISSON_TEXT("The left image is {0} x {1} pixels, the right one {2} x {3}."),
                   {std::to_string(left.width), std::to_string(left.height), std::to_string(right.width),
                    std::to_string(right.height)});
  }
  if (left.width != inside_->width || left.height != inside_->height) {
    return failure("stereo-image-sizes", GLISSON_TEXT("The images are {0} x {1} pixels; {2} x {3} were expected."),
                   {std::to_string(left.width), std::to_string(left.height), std::to_string(inside_->width),
                    std::to_string(inside_->height)});
  }
  try {
    const auto& [to_left_eye, to_right_eye, to_depth, to_left] = inside_->rectified;
    cv::Mat left_rectified, right_rectified;
    cv::remap(to_opencv(left), left_rectified, to_left_eye[0], to_left_eye[1], cv::INTER_LINEAR);
    cv::remap(to_opencv(right), right_rectified, to_right_eye[0], to_right_eye[1], cv::INTER_LINEAR);
    StereoCloud cloud;
    cloud.picture = from_opencv(left_rectified);
    const UsablePixels pixels = usable_pixels(cloud.picture, inside_->options.masks);
    cloud.masked = pixels.shares;
    Disparity disparity =
        match(inside_->matchers, left_rectified, right_rectified, inside_->options.largest_disagreement_px);
    if (inside_->options.step_px > 1) {
      cv::Mat left_grey, right_grey;
      cv::cvtColor(left_rectified, left_grey, cv::COLOR_BGR2GRAY);
      cv::cvtColor(right_rectified, right_grey, cv::COLOR_BGR2GRAY);
      refine_disparity(left_grey, right_grey, pixels.usable, inside_->options.step_px, disparity.px);
    }
    place_points(inside_->rectified, left_rectified, disparity, pixels.usable, inside_->options, cloud);
    return cloud;
  } catch (const cv::Exception& problem) {
    return failure("stereo-failed", GLISSON_TEXT("The pair could not be matched: {0}."), {problem.err});
  }
}

Result<StereoCloud> stereo_cloud(const fs::path& left, const fs::path& right, const StereoCalibration& calibration,
                                 const StereoOptions& options) {
  const auto left_frame = read_frame(left);
  if (!left_frame) return failure(left_frame.error());
  const auto right_frame = read_frame(right);
  if (!right_frame) return failure(right_frame.error());
  auto matcher = StereoMatcher::prepare(calibration, left_frame->width, left_frame->height, options);
  if (!matcher) return failure(matcher.error());
  return matcher->cloud(*left_frame, *right_frame);
}

namespace {

Rectification rectification(const StereoCalibration& calibration, int width, int height) {
  const cv::Size size(width, height);
  cv::Mat left_matrix, right_matrix, rotation, translation;
  cv::eigen2cv(calibration.left.matrix, left_matrix);
  cv::eigen2cv(calibration.right.matrix, right_matrix);
  cv::eigen2cv(Eigen::Matrix3d(calibration.left_to_right.linear()), rotation);
  cv::eigen2cv(Eigen::Vector3d(calibration.left_to_right.translation()), translation);
  const cv::Mat left_distortion(calibration.left.distortion, true),
      right_distortion(calibration.right.distortion, true);

  Rectification rectified;
  cv::Mat turn_left, turn_right, project_left, project_right;
  cv::stereoRectify(left_matrix, left_distortion, right_matrix, right_distortion, size, rotation, translation,
                    turn_left, turn_right, project_left, project_right, rectified.to_depth, cv::CALIB_ZERO_DISPARITY,
                    -1);
  cv::initUndistortRectifyMap(left_matrix, left_distortion, turn_left, project_left, size, CV_16SC2,
                              rectified.left_map[0], rectified.left_map[1]);
  cv::initUndistortRectifyMap(right_matrix, right_distortion, turn_right, project_right, size, CV_16SC2,
                              rectified.right_map[0], rectified.right_map[1]);
  cv::cv2eigen(turn_left, rectified.to_left);
  rectified.to_left.transposeInPlace();
  return rectified;
}

Matchers matchers(int disparities, int shrink) {
  constexpr int block = 5;
  Matchers made;
  made.shrink = shrink;
  // Smoothness penalties as OpenCV's documentation sets them for one channel.
  const auto there = cv::StereoSGBM::create(0, disparities, block, 8 * block * block, 32 * block * block, 1, 31, 10,
                                            100, 2, cv::StereoSGBM::MODE_SGBM_3WAY);
  made.there = there;
  made.back = cv::ximgproc::createRightMatcher(there);
  made.filter = cv::ximgproc::createDisparityWLSFilter(there);
  made.filter->setLambda(8000);
  made.filter->setSigmaColor(1.5);
  return made;
}

Disparity match(const Matchers& matchers, const cv::Mat& left, const cv::Mat& right, double largest_disagreement_px) {
  constexpr double subpixel = 16;  // OpenCV counts disparities in sixteenths
  cv::Mat left_grey, right_grey, there, back, filtered;
  cv::cvtColor(left, left_grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(right, right_grey, cv::COLOR_BGR2GRAY);
  if (matchers.shrink > 1) {
    const cv::Size small(left.cols / matchers.shrink, left.rows / matchers.shrink);
    cv::resize(left_grey, left_grey, small, 0, 0, cv::INTER_AREA);
    cv::resize(right_grey, right_grey, small, 0, 0, cv::INTER_AREA);
  }
  matchers.there->compute(left_grey, right_grey, there);
  matchers.back->compute(right_grey, left_grey, back);
  matchers.filter->filter(there, left, filtered, back);

  cv::Mat agrees = cv::Mat::zeros(there.size(), CV_8U);
  for (int y = 0; y < there.rows; ++y) {
    for (int x = 0; x < there.cols; ++x) {
      const double to_right_px = there.at<short>(y, x) / subpixel;
      const int in_right = x - static_cast<int>(std::lround(to_right_px));
      if (!(to_right_px > 0) || in_right < 0 || in_right >= back.cols) continue;
      const double to_left_px = back.at<short>(y, in_right) / subpixel;
      if (std::abs(to_right_px + to_left_px) <= largest_disagreement_px) agrees.at<std::uint8_t>(y, x) = 255;
    }
  }
  Disparity disparity;
  // The filter answers in pixels of the full size, or scaled as OpenCV's version does it: told from the shapes.
  filtered.convertTo(disparity.px, CV_32F, 1.0 / subpixel);
  matchers.filter->getConfidenceMap().convertTo(disparity.confidence, CV_32F, 1.0 / 255);
  if (agrees.size() != disparity.px.size()) {
    cv::resize(agrees, agrees, disparity.px.size(), 0, 0, cv::INTER_NEAREST);
  }
  disparity.px.setTo(std::numeric_limits<float>::quiet_NaN(), agrees == 0);
  return disparity;
}

void place_points(const Rectification& rectified, const cv::Mat& left, const Disparity& disparity,
                  const std::vector<std::uint8_t>& usable, const StereoOptions& options, StereoCloud& cloud) {
  const double center_x = -rectified.to_depth.at<double>(0, 3), center_y = -rectified.to_depth.at<double>(1, 3);
  const double focal_px = rectified.to_depth.at<double>(2, 3),
               depth_of_px = focal_px / rectified.to_depth.at<double>(3, 2);
  const int step = std::max(1, options.step_px);
  const int columns = (left.cols + step - 1) / step;
  std::vector<int> above(static_cast<std::size_t>(columns), -1), row(above);
  std::size_t looked_at = 0;
  const auto join = [&](int a, int b, int c) {
    if (a < 0 || b < 0 || c < 0) return;
    const auto depth_mm = [&](int point) { return cloud.points_mm[static_cast<std::size_t>(point)].z(); };
    const auto [nearest, farthest] = std::minmax({depth_mm(a), depth_mm(b), depth_mm(c)});
    if (farthest - nearest < 0.05 * nearest) cloud.triangles.push_back({a, b, c});
  };
  for (int y = 0; y < left.rows; y += step, std::swap(above, row)) {
    for (int x = 0; x < left.cols; x += step) {
      const auto column = static_cast<std::size_t>(x / step);
      row[column] = -1;
      if (usable[static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * static_cast<std::size_t>(left.cols)] ==
          0) {
        continue;
      }
      ++looked_at;
      const double px = disparity.px.at<float>(y, x);
      const double confidence = disparity.confidence.at<float>(y, x);
      if (!std::isfinite(px) || px <= 0 || confidence < options.minimum_confidence) continue;
      const double depth_mm = std::abs(depth_of_px) / px;
      if (depth_mm < options.nearest_mm || depth_mm > options.farthest_mm) continue;
      row[column] = static_cast<int>(cloud.points_mm.size());
      const Eigen::Vector3d rectified_mm(depth_mm * (x - center_x) / focal_px, depth_mm * (y - center_y) / focal_px,
                                         depth_mm);
      cloud.points_mm.emplace_back(rectified.to_left * rectified_mm);
      cloud.confidence.push_back(confidence);
      cloud.pixels.push_back({x, y});
      const auto& blue_green_red = left.at<cv::Vec3b>(y, x);
      cloud.colour.push_back({blue_green_red[2], blue_green_red[1], blue_green_red[0]});
      if (column == 0) continue;
      // Seen from the camera, that is from outside the tissue, counter-clockwise.
      join(above[column - 1], row[column - 1], above[column]);
      join(above[column], row[column - 1], row[column]);
    }
  }
  cloud.valid_fraction =
      looked_at > 0 ? static_cast<double>(cloud.points_mm.size()) / static_cast<double>(looked_at) : 0;
}

}  // namespace
}  // namespace glisson::vision
