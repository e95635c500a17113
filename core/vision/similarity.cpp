#include "vision/similarity.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace glisson::vision {
namespace {

Result<void> check_sizes(const Frame& one, const Frame& other) {
  if (one.width == other.width && one.height == other.height && one.width > 0 && one.height > 0) return {};
  return failure("pictures-differ-in-size", GLISSON_TEXT("The pictures have different sizes: {0} x {1} and {2} x {3}."),
                 {std::to_string(one.width), std::to_string(one.height), std::to_string(other.width),
                  std::to_string(other.height)});
}

cv::Mat view_of(const Frame& frame) {
  return {frame.height, frame.width, CV_8UC3, const_cast<std::uint8_t*>(frame.rgb.data())};
}

// Brightness as 32-bit numbers, 0 to 255, reduced by `factor`.
cv::Mat luminance(const Frame& frame, int factor) {
  cv::Mat grey, small;
  cv::cvtColor(view_of(frame), grey, cv::COLOR_RGB2GRAY);
  grey.convertTo(grey, CV_32F);
  cv::resize(grey, small, {}, 1.0 / factor, 1.0 / factor, cv::INTER_AREA);
  return small;
}

cv::Mat smoothed(const cv::Mat& values) {
  cv::Mat smooth;
  cv::GaussianBlur(values, smooth, {11, 11}, 1.5, 1.5, cv::BORDER_REFLECT);
  return smooth;
}

// Equation 13 at each pixel.
cv::Mat structural_similarity(const cv::Mat& x, const cv::Mat& y) {
  constexpr double range = 255, c1 = (0.01 * range) * (0.01 * range), c2 = (0.03 * range) * (0.03 * range);
  const cv::Mat mean_x = smoothed(x), mean_y = smoothed(y);
  const cv::Mat mean_xx = mean_x.mul(mean_x), mean_yy = mean_y.mul(mean_y), mean_xy = mean_x.mul(mean_y);
  const cv::Mat variance_x = smoothed(x.mul(x)) - mean_xx, variance_y = smoothed(y.mul(y)) - mean_yy;
  const cv::Mat covariance = smoothed(x.mul(y)) - mean_xy;
  const cv::Mat above = (2 * mean_xy + c1).mul(2 * covariance + c2);
  const cv::Mat below = (mean_xx + mean_yy + c1).mul(variance_x + variance_y + c2);
  cv::Mat similarity;
  cv::divide(above, below, similarity);
  return similarity;
}

// The minimum of the means over 16 x 16 tiles.
double worst_tile(const cv::Mat& similarity, const cv::Mat& weight) {
  constexpr int tiles = 16;
  double worst = 1;
  for (int j = 0; j < tiles; ++j) {
    for (int i = 0; i < tiles; ++i) {
      const cv::Range rows(similarity.rows * j / tiles, similarity.rows * (j + 1) / tiles);
      const cv::Range columns(similarity.cols * i / tiles, similarity.cols * (i + 1) / tiles);
      if (rows.empty() || columns.empty()) continue;
      const cv::Mat tile = weight(rows, columns);
      if (cv::countNonZero(tile) == 0) continue;
      worst = std::min(worst, cv::mean(similarity(rows, columns), tile)[0]);
    }
  }
  return worst;
}

// The second picture in grey, red where the similarity falls.
Frame difference_picture(const Frame& other, const cv::Mat& similarity, const cv::Mat& weight) {
  cv::Mat grey, wide, judged;
  cv::cvtColor(view_of(other), grey, cv::COLOR_RGB2GRAY);
  cv::resize(similarity, wide, grey.size(), 0, 0, cv::INTER_LINEAR);
  cv::resize(weight, judged, grey.size(), 0, 0, cv::INTER_NEAREST);
  Frame difference{other.width, other.height, std::vector<std::uint8_t>(other.rgb.size())};
  for (int y = 0; y < other.height; ++y) {
    for (int x = 0; x < other.width; ++x) {
      const double unlike = judged.at<std::uint8_t>(y, x) == 0 ? 0 : std::clamp(1.0 - wide.at<float>(y, x), 0.0, 1.0);
      const double base = 96 + grey.at<std::uint8_t>(y, x) * 0.5;
      std::uint8_t* pixel = difference.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(base + (255 - base) * unlike);
      pixel[1] = pixel[2] = static_cast<std::uint8_t>(base * (1 - unlike));
    }
  }
  return difference;
}

}  // namespace

Result<Similarity> similarity_of(const Frame& one, const Frame& other, const std::optional<Frame>& mask) {
  if (auto same = check_sizes(one, other); !same) return failure(same.error());
  if (mask) {
    if (auto same = check_sizes(one, *mask); !same) return failure(same.error());
  }
  const int factor = std::max(1, static_cast<int>(std::lround(std::min(one.width, one.height) / 256.0)));
  const cv::Mat x = luminance(one, factor), y = luminance(other, factor);
  cv::Mat weight(x.size(), CV_8U, cv::Scalar(255));
  if (mask) cv::Mat(luminance(*mask, factor) > 127).copyTo(weight);
  if (cv::countNonZero(weight) == 0)
    return failure("mask-empty", GLISSON_TEXT("The mask of the pictures is black everywhere."));
  const cv::Mat map = structural_similarity(x, y);
  return Similarity{cv::mean(map, weight)[0], worst_tile(map, weight), difference_picture(other, map, weight)};
}

}  // namespace glisson::vision
