#include "vision/internal/subpixel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/parallel.h"

namespace glisson::vision {
namespace {

constexpr int half_px = 7;   // of the window
constexpr double sd_px = 4;  // of its weights
constexpr int most_rounds = 8;
constexpr double done_px = 1e-3, farthest_px = 1.5, steepest = 0.5;  // from where it begins, at most; a pixel

// Disparity at the middle, its slopes, gain less one, offset.
using Fit = Eigen::Matrix<double, 5, 1>;

// One window's terms; false where it leaves the right picture.
bool add_window(const cv::Mat& left, const cv::Mat& right, int x, int y, const Fit& fit,
                Eigen::Matrix<double, 5, 5>& normal, Fit& rest) {
  static const auto weights = [] {
    std::array<double, 2 * half_px + 1> one{};
    for (int i = -half_px; i <= half_px; ++i) {
      one[static_cast<std::size_t>(i + half_px)] = std::exp(-i * i / (2 * sd_px * sd_px));
    }
    return one;
  }();
  for (int j = -half_px; j <= half_px; ++j) {
    const auto* seen = left.ptr<std::uint8_t>(y + j);
    const auto* row = right.ptr<std::uint8_t>(y + j);
    for (int i = -half_px; i <= half_px; ++i) {
      const double at = x + i - (fit[0] + fit[1] * i + fit[2] * j);
      const int whole = static_cast<int>(std::floor(at));
      if (whole < 1 || whole + 2 >= right.cols) return false;
      const double part = at - whole;
      const double value = (1 - part) * row[whole] + part * row[whole + 1];
      const double slope =
          0.5 * ((1 - part) * (row[whole + 1] - row[whole - 1]) + part * (row[whole + 2] - row[whole]));
      const Fit change{-slope, -slope * i, -slope * j, value, 1};
      const double weight =
          weights[static_cast<std::size_t>(i + half_px)] * weights[static_cast<std::size_t>(j + half_px)];
      rest += weight * (seen[x + i] - (1 + fit[3]) * value - fit[4]) * change;
      normal.selfadjointView<Eigen::Lower>().rankUpdate(change, weight);
    }
  }
  return true;
}

float refined(const cv::Mat& left, const cv::Mat& right, int x, int y, float begin_px) {
  // Priors' standard deviations, against a noise of one grey level.
  static const Fit stiffness = Fit(0.5, 0.2, 0.2, 0.1, 10).array().square().inverse();
  if (x < half_px || y < half_px || x + half_px >= left.cols || y + half_px >= left.rows) return begin_px;
  const Fit begin{begin_px, 0, 0, 0, 0};
  Fit fit = begin;
  for (int round = 0; round < most_rounds; ++round) {
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    normal.diagonal() = stiffness;
    Fit rest = stiffness.cwiseProduct(begin - fit);
    if (!add_window(left, right, x, y, fit, normal, rest)) return begin_px;
    const Fit change = normal.selfadjointView<Eigen::Lower>().llt().solve(rest);
    fit += change;
    const bool strays = !(std::abs(fit[0] - begin_px) < farthest_px) || !(std::abs(fit[1]) < steepest) ||
                        !(std::abs(fit[2]) < steepest);
    if (strays) return begin_px;
    if (std::abs(change[0]) < done_px) break;
  }
  return fit[0] > 0 ? static_cast<float>(fit[0]) : begin_px;
}

}  // namespace

void refine_disparity(const cv::Mat& left, const cv::Mat& right, const std::vector<std::uint8_t>& usable, int step_px,
                      cv::Mat& disparity_px) {
  const auto rows = static_cast<std::size_t>((left.rows + step_px - 1) / step_px);
  parallel_for(rows, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row) * step_px;
      for (int x = 0; x < left.cols; x += step_px) {
        float& px = disparity_px.at<float>(y, x);
        const auto pixel =
            static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * static_cast<std::size_t>(left.cols);
        if (usable[pixel] != 0 && std::isfinite(px) && px > 0) px = refined(left, right, x, y, px);
      }
    }
  });
}

}  // namespace glisson::vision
