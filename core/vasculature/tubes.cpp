#include "vasculature/tubes.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

#include "geometry/clip_surface.h"
#include "geometry/nearest.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using geometry::Surface;
using Line = std::vector<CenterPoint>;

// A vessel's centre points in two heaps, what stays as it is outlined in the thick one, and its thin stretches as they
// are drawn.
struct Parted {
  Line thin, thick;
  std::vector<Line> stretches;
};
Parted parted(const imaging::Mask& mask, const VesselGraph& graph, double thin_mm);

// The triangles of the outline that belong to what is thick, with the points that they use.
Surface thick_part(const Surface& outline, const Parted& lines, double thin_mm);

Line smoothed(Line line);
void add_tube(const Line& line, int sides, Surface& surface);

}  // namespace

double thin_radius_mm(const Vector3d& spacing_mm) { return 1.5 * std::cbrt(spacing_mm.prod()); }

std::optional<Surface> with_tubes(const imaging::Mask& mask, const Surface& outline, const VesselGraph& graph,
                                  const TubeOptions& options) {
  const Parted lines = parted(mask, graph, options.thin_mm);
  if (lines.stretches.empty()) return {};
  Surface drawn = thick_part(outline, lines, options.thin_mm);
  for (const Line& stretch : lines.stretches) add_tube(smoothed(stretch), options.sides, drawn);
  return drawn;
}

namespace {

// Of each point, whether it is thin. A radius measured in voxels goes up and down: a few points that differ from both
// neighbours follow these. So does a line's end that is shorter than its vessel is wide: the depth under the wall of a
// round end.
std::vector<char> thin_points(const Line& line, double thin_mm) {
  constexpr std::size_t few = 3;
  std::vector<char> thin;
  for (const CenterPoint& point : line) thin.push_back(point.radius_mm < thin_mm ? 1 : 0);
  for (std::size_t begin = 0, end = 0; begin < thin.size(); begin = end) {
    for (end = begin; end < thin.size() && thin[end] == thin[begin];) ++end;
    if (begin == 0 && end == thin.size()) break;
    const bool between = begin > 0 && end < thin.size();
    const auto wider = [](const CenterPoint& a, const CenterPoint& b) { return a.radius_mm < b.radius_mm; };
    const double widest_mm = std::max_element(line.begin(), line.end(), wider)->radius_mm;
    const double length_mm = (line[begin].position_mm - line[end - 1].position_mm).norm();
    if (between ? end - begin <= few : thin[begin] != 0 && length_mm <= 2 * widest_mm)
      std::fill(thin.begin() + long(begin), thin.begin() + long(end), thin[begin] != 0 ? 0 : 1);
  }
  return thin;
}

// How wide the vessels are that meet at each vertex, some millimetres from it.
std::vector<double> width_at_vertices(const VesselGraph& graph) {
  constexpr std::size_t near = 5;  // points
  std::vector<double> widest_mm(graph.vertices_mm.size(), 0);
  for (const GraphBranch& branch : graph.branches) {
    const Line& line = branch.points;
    for (std::size_t i = 0; i < std::min(near, line.size()) && branch.joint == Joint::vessel; ++i) {
      double& from = widest_mm[static_cast<std::size_t>(branch.from)];
      double& to = widest_mm[static_cast<std::size_t>(branch.to)];
      from = std::max(from, line[i].radius_mm);
      to = std::max(to, line[line.size() - 1 - i].radius_mm);
    }
  }
  return widest_mm;
}

// Where a mask ends in the midst of a wide vessel it thins out to a sheet, and lines run up it like the ribs of a fan.
// Beside a vessel that is thin there is nothing; beside a rib, along the sheet, there is more of the mask. Of all
// places around the points from `begin` to `end`, two thin vessels' radii away, the share that lies in the mask.
double filled_around(const imaging::Mask& mask, const Line& line, std::size_t begin, std::size_t end, double thin_mm) {
  constexpr int directions = 16;
  int filled = 0, all = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Vector3d way = line[std::min(i + 1, line.size() - 1)].position_mm - line[i == 0 ? 0 : i - 1].position_mm;
    if (way.norm() == 0) continue;
    const Vector3d across = way.unitOrthogonal(), beside = way.normalized().cross(across);
    for (int d = 0; d < directions; ++d) {
      const double angle = 2 * std::numbers::pi * d / directions;
      const Eigen::Vector3i at =
          mask.grid.index_of(line[i].position_mm + 2 * thin_mm * (std::cos(angle) * across + std::sin(angle) * beside))
              .array()
              .round()
              .cast<int>();
      ++all;
      if (mask.grid.contains(at[0], at[1], at[2]) && mask.at(at[0], at[1], at[2]) != 0) ++filled;
    }
  }
  return all > 0 ? double(filled) / all : 0;
}

std::vector<Vector3d> places(const Line& line) {
  std::vector<Vector3d> places_mm;
  for (const CenterPoint& point : line) places_mm.push_back(point.position_mm);
  return places_mm;
}

// The middle of what is wide: three times as wide as what is thin, at least.
class WideVessels {
 public:
  WideVessels(const VesselGraph& graph, double thin_mm) {
    for (const GraphBranch& branch : graph.branches) {
      if (branch.joint != Joint::vessel) continue;
      for (const CenterPoint& point : branch.points) {
        if (point.radius_mm >= 3 * thin_mm) points_.push_back(point);
      }
    }
    for (const CenterPoint& point : points_) widest_mm_ = std::max(widest_mm_, point.radius_mm);
    if (!points_.empty()) nearest_.emplace(places(points_));
  }
  // In it or near its wall: no farther than `reach` of its radii, which shrink where it ends.
  [[nodiscard]] bool reach(const CenterPoint& point) const {
    constexpr double reach = 4;
    if (!nearest_) return false;
    const auto around = nearest_->within(point.position_mm, reach * widest_mm_);
    return std::any_of(around.begin(), around.end(), [&](const auto& one) {
      return std::sqrt(one.squared_distance_mm2) <= reach * points_[static_cast<std::size_t>(one.point)].radius_mm;
    });
  }

 private:
  Line points_;
  double widest_mm_ = 0;
  std::optional<geometry::NearestPoint> nearest_;
};

Parted parted(const imaging::Mask& mask, const VesselGraph& graph, double thin_mm) {
  constexpr std::size_t into_the_thick = 4;  // points, so that a tube begins inside of what it leaves
  // A sheet as thin as a vessel may be fills a tenth and more of what is around it, most vessels less than half of
  // that.
  constexpr double most_of_a_vessel = 0.08;
  const std::vector<double> width_mm = width_at_vertices(graph);
  const WideVessels wide(graph, thin_mm);
  Parted lines;
  for (const GraphBranch& branch : graph.branches) {
    if (branch.joint != Joint::vessel) continue;
    std::vector<char> thin = thin_points(branch.points, thin_mm);
    // A spur no longer than what it stands on is wide: a bump of its wall, or an edge of its cut end.
    const double stands_on_mm =
        std::max(width_mm[static_cast<std::size_t>(branch.from)], width_mm[static_cast<std::size_t>(branch.to)]);
    if (branch.length_mm <= 2 * stands_on_mm && stands_on_mm >= thin_mm) std::fill(thin.begin(), thin.end(), char{0});
    for (std::size_t begin = 0, end = 0; begin < thin.size(); begin = end) {
      for (end = begin; end < thin.size() && thin[end] == thin[begin];) ++end;
      const bool in_a_wide_one =
          thin[begin] != 0 && std::all_of(branch.points.begin() + long(begin), branch.points.begin() + long(end),
                                          [&](const CenterPoint& point) { return wide.reach(point); });
      const bool is_tube = thin[begin] != 0 && !(in_a_wide_one && filled_around(mask, branch.points, begin, end,
                                                                                thin_mm) > most_of_a_vessel);
      Line& heap = is_tube ? lines.thin : lines.thick;
      heap.insert(heap.end(), branch.points.begin() + long(begin), branch.points.begin() + long(end));
      if (!is_tube) continue;
      const std::size_t first = begin - std::min(begin, into_the_thick);
      const std::size_t last = std::min(thin.size(), end + into_the_thick);
      Line stretch;
      for (std::size_t i = first; i < last; ++i) {
        stretch.push_back(branch.points[i]);
        stretch.back().radius_mm = std::min(stretch.back().radius_mm, thin_mm);
      }
      lines.stretches.push_back(std::move(stretch));
    }
  }
  return lines;
}

Vector3d middle_mm(const Surface& surface, const std::array<int, 3>& triangle) {
  Vector3d middle = Vector3d::Zero();
  for (const int p : triangle) middle += surface.points_mm[static_cast<std::size_t>(p)] / 3;
  return middle;
}

Surface thick_part(const Surface& outline, const Parted& lines, double thin_mm) {
  const geometry::NearestPoint thin(places(lines.thin));
  std::optional<geometry::NearestPoint> thick;
  double widest_mm = 0;
  if (!lines.thick.empty()) thick.emplace(places(lines.thick));
  for (const CenterPoint& point : lines.thick) widest_mm = std::max(widest_mm, point.radius_mm);

  // How far outside of the vessel that a line stands for: the wall, not the line, says whose a triangle is.
  const auto is_of_thin = [&](const Vector3d& place_mm) {
    const auto found = thin.nearest(place_mm);
    const double beyond_mm =
        std::sqrt(found.squared_distance_mm2) - lines.thin[static_cast<std::size_t>(found.point)].radius_mm;
    if (beyond_mm > thin_mm) return false;  // a speck that no line follows
    if (!thick) return true;
    const auto around = thick->within(place_mm, std::max(0.0, beyond_mm) + widest_mm);
    return std::none_of(around.begin(), around.end(), [&](const auto& one) {
      const double radius_mm = lines.thick[static_cast<std::size_t>(one.point)].radius_mm;
      return std::sqrt(one.squared_distance_mm2) - radius_mm < beyond_mm;
    });
  };

  return geometry::kept_part(outline,
                             [&](std::size_t t) { return !is_of_thin(middle_mm(outline, outline.triangles[t])); });
}

// Neighbours' means, some times over: a line through voxels has corners. Its ends stay.
Line smoothed(Line line) {
  constexpr int times = 4;
  for (int time = 0; time < times; ++time) {
    const Line before = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      line[i].position_mm = 0.25 * (before[i - 1].position_mm + 2 * before[i].position_mm + before[i + 1].position_mm);
      line[i].radius_mm = 0.25 * (before[i - 1].radius_mm + 2 * before[i].radius_mm + before[i + 1].radius_mm);
    }
  }
  return line;
}

// Rings around the line, a round cap at each end. The ring's frame turns with the line and not about it (Bishop's frame
// by rotation from one tangent to the next: Hanson and Ma 1995).
void add_tube(const Line& line, int sides, Surface& surface) {
  std::vector<Vector3d> tangents;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector3d way = line[std::min(i + 1, line.size() - 1)].position_mm - line[i == 0 ? 0 : i - 1].position_mm;
    tangents.push_back(way.norm() > 0 ? way.normalized() : tangents.empty() ? Vector3d::UnitZ() : tangents.back());
  }
  Vector3d across = tangents.front().unitOrthogonal();
  int rings = 0;
  const int first = static_cast<int>(surface.points_mm.size());
  const auto add_ring = [&](const Vector3d& center_mm, const Vector3d& tangent, double radius_mm) {
    for (int side = 0; side < sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / sides;
      surface.points_mm.push_back(center_mm +
                                  radius_mm * (std::cos(angle) * across + std::sin(angle) * tangent.cross(across)));
    }
    ++rings;
  };
  const double round = std::sqrt(0.5);  // half-way up a cap
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {
      across = Eigen::Quaterniond::FromTwoVectors(tangents[i - 1], tangents[i]) * across;
      across = (across - across.dot(tangents[i]) * tangents[i]).normalized();
    }
    const auto& [center_mm, radius_mm] = line[i];
    if (i == 0) add_ring(center_mm - round * radius_mm * tangents[i], tangents[i], round * radius_mm);
    add_ring(center_mm, tangents[i], radius_mm);
    if (i + 1 == line.size()) add_ring(center_mm + round * radius_mm * tangents[i], tangents[i], round * radius_mm);
  }
  const int begin = static_cast<int>(surface.points_mm.size()), end = begin + 1;
  surface.points_mm.push_back(line.front().position_mm - line.front().radius_mm * tangents.front());
  surface.points_mm.push_back(line.back().position_mm + line.back().radius_mm * tangents.back());
  for (int side = 0; side < sides; ++side) {
    const int next = (side + 1) % sides;
    const auto at = [&](int ring, int place) { return first + ring * sides + place; };
    surface.triangles.push_back({begin, at(0, next), at(0, side)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      surface.triangles.push_back({at(ring, side), at(ring, next), at(ring + 1, next)});
      surface.triangles.push_back({at(ring, side), at(ring + 1, next), at(ring + 1, side)});
    }
    surface.triangles.push_back({end, at(rings - 1, side), at(rings - 1, next)});
  }
}

}  // namespace
}  // namespace glisson::vasculature
