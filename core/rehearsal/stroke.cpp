#include "rehearsal/stroke.h"

#include <algorithm>
#include <cmath>

namespace glisson::rehearsal {

using Eigen::Vector3d;

Stroke::Stroke(const Vector3d& begin_mm, const Vector3d& into_mm)
    : into_mm_(into_mm), line_mm_{begin_mm}, along_mm_{0.0} {}

Stroke Stroke::going_on(const mechanics::CutStrip& last) {
  const std::vector<Vector3d>& line_mm = last.surface.through_mm();
  Stroke stroke(line_mm.front(), last.surface.into_mm());
  for (std::size_t p = 1; p < line_mm.size(); ++p) {
    stroke.along_mm_.push_back(stroke.along_mm_.back() + stroke.across(line_mm[p] - line_mm[p - 1]).norm());
    stroke.line_mm_.push_back(line_mm[p]);
  }
  stroke.cut_mm_ = std::clamp(last.surface.on_line(last.to_mm).along_mm, 0.0, stroke.length_mm());
  return stroke;
}

Result<void> Stroke::draw_to(const Vector3d& place_mm) {
  const Vector3d way_mm = place_mm - line_mm_.back();
  const double step_mm = across(way_mm).norm();
  const double drop_mm = std::abs(way_mm.dot(into_mm_)) / into_mm_.norm();
  constexpr double steepest = 4, bump_mm = 10;  // a surface seen at less than 14 degrees is not under the hand
  if (drop_mm > std::max(bump_mm, steepest * step_mm)) {
    return failure(Error{"stroke-leaves",
                         GLISSON_TEXT("The line leaves the surface that it was drawn on."),
                         {},
                         GLISSON_TEXT("Turn the liver until you look onto it, and go on from there."),
                         {}});
  }
  if (step_mm < apart_mm) return {};
  if (line_mm_.size() > 1) {
    constexpr double sharpest = 0.5;  // cosine
    const Vector3d before_mm = across(line_mm_.back() - line_mm_[line_mm_.size() - 2]);
    if (across(way_mm).dot(before_mm) < sharpest * step_mm * before_mm.norm()) {
      return failure(Error{"stroke-turns",
                           GLISSON_TEXT("The line turns back on itself."),
                           {},
                           GLISSON_TEXT("Lift, and begin a new cut farther away."),
                           {}});
    }
  }
  line_mm_.push_back(place_mm);
  along_mm_.push_back(along_mm_.back() + step_mm);
  return {};
}

std::optional<mechanics::CutStrip> Stroke::next_advance(Hand hand) {
  if (line_mm_.size() < 2) return {};
  const bool lifted = hand == Hand::lifted;
  const double until_mm = lifted ? length_mm() : length_mm() - behind_mm;
  constexpr double something_mm = 1e-6;
  if (until_mm - cut_mm_ < (lifted ? something_mm : shortest_advance_mm)) return {};
  auto surface = geometry::CutSurface::swept(line_mm_, into_mm_);
  if (!surface) return {};  // the line was checked as it grew
  // What is left after a lift goes in equal parts, so that none is a crumb.
  const double parts = std::ceil((until_mm - cut_mm_) / longest_advance_mm);
  const double to_mm =
      lifted ? cut_mm_ + (until_mm - cut_mm_) / parts : std::min(until_mm, cut_mm_ + longest_advance_mm);
  mechanics::CutStrip strip{std::move(*surface), at(cut_mm_), at(to_mm)};
  cut_mm_ = parts == 1 ? until_mm : to_mm;
  return strip;
}

Vector3d Stroke::across(const Vector3d& way_mm) const {
  return way_mm - way_mm.dot(into_mm_) / into_mm_.squaredNorm() * into_mm_;
}

Vector3d Stroke::at(double along_mm) const {
  const auto next = std::upper_bound(along_mm_.begin() + 1, along_mm_.end() - 1, along_mm);
  const auto n = static_cast<std::size_t>(next - along_mm_.begin());
  const double share = (along_mm - along_mm_[n - 1]) / (along_mm_[n] - along_mm_[n - 1]);
  return line_mm_[n - 1] + share * (line_mm_[n] - line_mm_[n - 1]);
}

}  // namespace glisson::rehearsal
