// The cut of a live body in a step: walls that do not pass through each other, and what is seen of the jumps.

#include <algorithm>

#include "mechanics/contact/internal/live_step.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

// What opened since presses as if it had never been one.
Result<void> LiveStep::take_cut(const LiveState& from) {
  adjoints_ = parts_.adjoints;
  if (cut_ == nullptr) return {};
  auto weighed = cut_->adjoints(parts_);
  if (!weighed) return failure(std::move(weighed.error()));
  adjoints_ = std::move(*weighed);
  state_.advances = cut_->advances;
  for (int jump = 0; jump < cut_->open.jumps(); ++jump) {
    const auto j = static_cast<std::size_t>(jump);
    walls_.push_back({j < from.wall_mN.size() ? from.wall_mN[j] : 0.0});
  }
  return {};
}

void LiveStep::face_walls() {
  if (cut_ == nullptr) return;
  const std::vector<Vector3d> normals = cut_->open.normals(state_.u_mm);
  for (std::size_t w = 0; w < walls_.size(); ++w) walls_[w].normal = normals[w];
}

void LiveStep::look_at_walls(const VectorXd& u_mm) {
  constexpr double margin_mm = 1.0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const double gap = gap_mm(w, u_mm);
    if (gap > margin_mm && walls_[w].multiplier_mN == 0) continue;
    StiffRow row;
    row.on.emplace_back(parts_.body.layout.nodes() + static_cast<int>(w), walls_[w].normal);
    row.stiffness = parts_.k_wall_mN_mm;
    row.gap_mm = gap - walls_[w].multiplier_mN / parts_.k_wall_mN_mm;
    rows_.push_back(std::move(row));
  }
}

double LiveStep::overlap_mm() const {
  double deepest = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) deepest = std::max(deepest, -gap_mm(w, state_.u_mm));
  return deepest;
}

void LiveStep::show_cut() {
  for (std::size_t w = 0; w < cut_->of_watched.size(); ++w) {
    for (const auto& [jump, value] : cut_->of_watched[w]) {
      state_.watched_mm[w] += value * state_.u_mm.segment<3>(parts_.unknowns() + 3 * Index{jump});
    }
  }
  for (const Facing& wall : walls_) state_.wall_mN.push_back(wall.multiplier_mN);
  state_.report.overlap_mm = overlap_mm();
  state_.report.largest_strain = std::max(state_.report.largest_strain, cut_->open.largest_strain(state_.u_mm));
}

}  // namespace glisson::mechanics
