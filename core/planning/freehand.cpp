#include "planning/freehand.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <optional>

#include "geometry/cut_surface.h"
#include "geometry/line_and_triangle.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;

struct Crossings {
  Vector3d first_mm, last_mm;
};

// Where the line meets the surface first and last; nothing where it passes by.
std::optional<Crossings> crossings(const geometry::Surface& surface, const SightLine& line);

// The part of the line over the liver, by the length of its course there.
struct Course {
  std::vector<SightLine> lines;
  std::vector<double> at_mm;  // along it, as seen: across the sight
};
Course course_over(const geometry::Surface& liver, const std::vector<SightLine>& line);

// Between two lines of the course, by how far each is.
SightLine line_at(const Course& course, double along_mm);

}  // namespace

Result<SheetCut> sheet_under(const geometry::Surface& liver, const std::vector<SightLine>& line) {
  constexpr double shortest_mm = 10, apart_mm = 10;
  const Error misses{"line-misses",
                     GLISSON_TEXT("Less than {0} mm of the line lie over the liver."),
                     {std::to_string(static_cast<int>(shortest_mm))},
                     GLISSON_TEXT("Draw it across the liver, from one side to the other."),
                     {}};
  const Course course = course_over(liver, line);
  if (course.lines.empty() || course.at_mm.back() < shortest_mm) return failure(misses);
  const int places = std::clamp(static_cast<int>(course.at_mm.back() / apart_mm) + 1, 4, 10);
  std::vector<Crossings> at;
  Vector3d sight = Vector3d::Zero();
  for (int n = 0; n < places; ++n) {
    const SightLine here = line_at(course, course.at_mm.back() * n / (places - 1));
    if (const auto found = crossings(liver, here)) {
      at.push_back(*found);
      sight += here.towards.normalized();
    }
  }
  if (at.size() < 3) return failure(misses);
  // Seen from the eye, each step goes on along the way from the first place to the last.
  sight.normalize();
  const auto seen = [&](const Vector3d& way_mm) -> Vector3d { return way_mm - sight * sight.dot(way_mm); };
  const Vector3d along = seen(at.back().first_mm - at.front().first_mm).normalized();
  for (std::size_t n = 1; n < at.size(); ++n) {
    const Vector3d step_mm = seen(at[n].first_mm - at[n - 1].first_mm);
    if (along.dot(step_mm) > 0.1 * step_mm.norm()) continue;
    return failure(Error{"line-turns-back",
                         GLISSON_TEXT("The line turns back on itself."),
                         {},
                         GLISSON_TEXT("Draw it from one side of the liver to the other without turning."),
                         {}});
  }
  constexpr double thin_mm = 1;  // at the liver's rim both places are one
  SheetCut cut;
  for (const Crossings& place : at) {
    cut.through_mm.push_back(place.first_mm);
    const Vector3d depth_mm = place.last_mm - place.first_mm;
    if (depth_mm.norm() <= thin_mm) continue;
    cut.through_mm.push_back(place.first_mm + 0.5 * depth_mm);  // else the sheet would bow in between
    cut.through_mm.push_back(place.last_mm);
  }
  return geometry::CutSurface::through(cut.through_mm).map([&](const geometry::CutSurface&) { return cut; });
}

namespace {

std::optional<Crossings> crossings(const geometry::Surface& surface, const SightLine& line) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto point = [&](int index) -> const Vector3d& { return surface.points_mm[static_cast<std::size_t>(index)]; };
    const auto met = geometry::line_meets_triangle(line.through_mm, line.towards, point(a), point(b), point(c));
    if (!met) continue;
    first = std::min(first, met->at);
    last = std::max(last, met->at);
  }
  if (first > last) return std::nullopt;
  return Crossings{line.through_mm + first * line.towards, line.through_mm + last * line.towards};
}

Course course_over(const geometry::Surface& liver, const std::vector<SightLine>& line) {
  Course course;
  std::optional<Vector3d> before_mm;
  for (const SightLine& here : line) {
    const auto found = crossings(liver, here);
    if (!found) continue;  // beside the liver, or over a notch of its rim
    double step_mm = 0;
    if (before_mm) {
      const Vector3d sight = here.towards.normalized(), way_mm = found->first_mm - *before_mm;
      step_mm = (way_mm - sight * sight.dot(way_mm)).norm();
      if (step_mm < 0.1) continue;  // the hand rests
    }
    course.at_mm.push_back(course.at_mm.empty() ? 0 : course.at_mm.back() + step_mm);
    course.lines.push_back(here);
    before_mm = found->first_mm;
  }
  return course;
}

SightLine line_at(const Course& course, double along_mm) {
  const auto next = std::lower_bound(course.at_mm.begin(), course.at_mm.end(), along_mm);
  const auto n = static_cast<std::size_t>(
      std::min<std::ptrdiff_t>(next - course.at_mm.begin(), static_cast<std::ptrdiff_t>(course.at_mm.size()) - 1));
  if (n == 0) return course.lines.front();
  const double share = (along_mm - course.at_mm[n - 1]) / (course.at_mm[n] - course.at_mm[n - 1]);
  const SightLine &from = course.lines[n - 1], &to = course.lines[n];
  return {from.through_mm + share * (to.through_mm - from.through_mm),
          (1 - share) * from.towards.normalized() + share * to.towards.normalized()};
}

}  // namespace
}  // namespace glisson::planning
