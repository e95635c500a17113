#include "registration_quality/internal/warp.h"

#include <algorithm>
#include <limits>

namespace glisson::registration_quality {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

SharedCentreWarps::SharedCentreWarps(std::vector<Vector3d> centres_mm, const Eigen::MatrixXd& displacements_mm,
                                     double stiffness_mm)
    : centres_mm_(std::move(centres_mm)), center_mm_(Vector3d::Zero()), size_mm_(0) {
  const auto count = static_cast<Eigen::Index>(centres_mm_.size());
  for (const Vector3d& centre : centres_mm_) center_mm_ += centre / static_cast<double>(count);
  for (const Vector3d& centre : centres_mm_) size_mm_ = std::max(size_mm_, (centre - center_mm_).norm());
  Eigen::MatrixXd system(count + 4, count + 4);
  system.topRows(count) = kernel_rows(centres_mm_);
  system.diagonal().head(count).array() -= stiffness_mm / size_mm_;
  system.bottomLeftCorner(4, count) = system.topRightCorner(count, 4).transpose();
  // Centres may lie in one plane, where the part across it is not determined: held near zero.
  system.bottomRightCorner(4, 4) = 1e-9 * Eigen::Matrix4d::Identity();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count + 4, displacements_mm.cols());
  right.topRows(count) = displacements_mm;
  coefficients_ = system.partialPivLu().solve(right);
}

Eigen::MatrixXd SharedCentreWarps::displacements_mm(const std::vector<Vector3d>& points_mm) const {
  return kernel_rows(points_mm) * coefficients_;
}

// Distances to the centres, then the affine part; in units of the centres' spread, which conditions the system.
Eigen::MatrixXd SharedCentreWarps::kernel_rows(const std::vector<Vector3d>& points_mm) const {
  const auto count = static_cast<Eigen::Index>(centres_mm_.size());
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points_mm.size()), count + 4);
  for (Eigen::Index centre = 0; centre < count; ++centre) {
    const Vector3d& at = centres_mm_[static_cast<std::size_t>(centre)];
    for (std::size_t point = 0; point < points_mm.size(); ++point) {
      rows(static_cast<Eigen::Index>(point), centre) = (points_mm[point] - at).norm() / size_mm_;
    }
  }
  for (std::size_t point = 0; point < points_mm.size(); ++point) {
    rows.row(static_cast<Eigen::Index>(point)).tail<4>() << 1, ((points_mm[point] - center_mm_) / size_mm_).transpose();
  }
  return rows;
}

std::vector<std::size_t> spread(const Points& candidates, int count) {
  std::vector<double> squared_mm2(candidates.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> chosen;
  std::size_t next = 0;
  while (static_cast<int>(chosen.size()) < count && next < candidates.size() && squared_mm2[next] > 0) {
    chosen.push_back(next);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      squared_mm2[i] = std::min(squared_mm2[i], (candidates[i] - candidates[chosen.back()]).squaredNorm());
    }
    next = static_cast<std::size_t>(std::max_element(squared_mm2.begin(), squared_mm2.end()) - squared_mm2.begin());
  }
  return chosen;
}

std::optional<BenchmarkWarps> benchmark_warps(const RegisteredSequence& sequence, const SirgnOptions& options) {
  if (!sequence.benchmark) return std::nullopt;
  const auto& [on_model, in_frames] = *sequence.benchmark;
  const std::size_t frames = sequence.frames.size();
  std::vector<bool> holds(frames, false);
  for (const auto& landmark : in_frames) {
    for (std::size_t t = 0; t < frames; ++t) holds[t] = holds[t] || landmark[t];
  }
  Points whole;  // landmarks that lie in every frame that the benchmark holds
  std::vector<std::size_t> landmark_of;
  for (std::size_t k = 0; k < on_model.size(); ++k) {
    bool everywhere = on_model[k].has_value();
    for (std::size_t t = 0; t < frames; ++t) everywhere = everywhere && (!holds[t] || in_frames[k][t]);
    if (!everywhere) continue;
    whole.push_back(*on_model[k]);
    landmark_of.push_back(k);
  }
  const std::vector<std::size_t> chosen = spread(whole, options.control_points);
  Points centres;
  Eigen::MatrixXd displacements =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(chosen.size()), static_cast<Eigen::Index>(3 * frames));
  for (const std::size_t place : chosen) {
    const auto row = static_cast<Eigen::Index>(centres.size());
    centres.push_back(whole[place]);
    for (std::size_t t = 0; t < frames; ++t) {
      if (!holds[t]) continue;
      displacements.block<1, 3>(row, static_cast<Eigen::Index>(3 * t)) =
          (*in_frames[landmark_of[place]][t] - whole[place]).transpose();
    }
  }
  return BenchmarkWarps{SharedCentreWarps(std::move(centres), displacements, 0), std::move(holds)};
}

}  // namespace glisson::registration_quality
