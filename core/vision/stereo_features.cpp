#include "vision/internal/stereo_features.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/features2d.hpp>

#include "vision/internal/opencv.h"

namespace glisson::vision {

Features find_features(const Frame& frame, int maximum) {
  cv::Mat grey;
  cv::cvtColor(to_opencv(frame), grey, cv::COLOR_BGR2GRAY);
  // Tissue is smooth: a lower threshold of contrast than Lowe's 0.04.
  const auto sift = cv::SIFT::create(maximum, 3, 0.01, 15);
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
  sift->detectAndCompute(grey, {}, points, descriptors);
  Features features;
  features.descriptors.resize(static_cast<Eigen::Index>(points.size()), 128);
  for (std::size_t i = 0; i < points.size(); ++i) {
    features.pixels.emplace_back(points[i].pt.x, points[i].pt.y);
    const auto row = static_cast<Eigen::Index>(i);
    features.descriptors.row(row) =
        Eigen::Map<const Eigen::Matrix<float, 1, 128>>(descriptors.ptr<float>(static_cast<int>(i)));
    features.descriptors.row(row) =
        (features.descriptors.row(row) / std::max(1e-6F, features.descriptors.row(row).sum())).cwiseSqrt();
  }
  return features;
}

Triangulator::Triangulator(const StereoCalibration& calibration) : calibration_(calibration) {
  const Eigen::Vector3d& t = calibration_.left_to_right.translation();
  Eigen::Matrix3d cross;
  cross << 0, -t.z(), t.y(), t.z(), 0, -t.x(), -t.y(), t.x(), 0;
  essential_ = cross * calibration_.left_to_right.linear();
}

namespace {

// Pixels to directions (x, y, 1) without distortion.
std::vector<Eigen::Vector3d> directions(const Camera& camera, const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<Eigen::Vector3d> rays;
  if (pixels.empty()) return rays;
  std::vector<cv::Point2d> seen, straight;
  for (const Eigen::Vector2d& pixel : pixels) seen.emplace_back(pixel.x(), pixel.y());
  cv::Mat matrix;
  cv::eigen2cv(camera.matrix, matrix);
  cv::undistortPoints(seen, straight, matrix, cv::Mat(camera.distortion, true));
  for (const cv::Point2d& point : straight) rays.emplace_back(point.x, point.y, 1);
  return rays;
}

}  // namespace

std::vector<Sighting> Triangulator::operator()(const std::vector<Eigen::Vector2d>& left_px,
                                               const std::vector<Eigen::Vector2d>& right_px) const {
  const auto left = directions(calibration_.left, left_px);
  const auto right = directions(calibration_.right, right_px);
  const double focal_px = 0.25 * (calibration_.left.matrix(0, 0) + calibration_.left.matrix(1, 1) +
                                  calibration_.right.matrix(0, 0) + calibration_.right.matrix(1, 1));
  const Eigen::Isometry3d right_to_left = calibration_.left_to_right.inverse();
  const Eigen::Vector3d right_eye_mm = right_to_left.translation();
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Eigen::Vector3d line = essential_ * left[i], back_line = essential_.transpose() * right[i];
    const double slope = line.head<2>().squaredNorm() + back_line.head<2>().squaredNorm();
    Sighting sighting;
    sighting.epipolar_px = slope > 0 ? focal_px * std::abs(right[i].dot(line)) / std::sqrt(slope) : 0;
    // The rays' nearest points: a * left[i] and right_eye + b * direction.
    const Eigen::Vector3d direction = right_to_left.linear() * right[i];
    Eigen::Matrix<double, 3, 2> rays;
    rays << left[i], -direction;
    const Eigen::Vector2d along = (rays.transpose() * rays).ldlt().solve(rays.transpose() * right_eye_mm);
    sighting.position_mm = 0.5 * (along.x() * left[i] + right_eye_mm + along.y() * direction);
    sightings.push_back(sighting);
  }
  return sightings;
}

}  // namespace glisson::vision
