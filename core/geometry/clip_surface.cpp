#include "geometry/clip_surface.h"

#include <algorithm>
#include <map>

namespace glisson::geometry {
namespace {

// Points of the piece as they come to be asked for: those of the surface, and those on its edges.
class Piece {
 public:
  Piece(const Surface& surface, const std::vector<double>& height_mm)
      : surface_(surface), height_mm_(height_mm), new_number_(surface.points_mm.size(), -1) {}

  int point(int of_surface) {
    int& number = new_number_[static_cast<std::size_t>(of_surface)];
    if (number < 0) number = add(surface_.points_mm[static_cast<std::size_t>(of_surface)]);
    return number;
  }

  int point_between(int a, int b) {
    const auto [found, is_new] = on_edge_.try_emplace({std::min(a, b), std::max(a, b)}, -1);
    if (is_new) {
      const auto from = static_cast<std::size_t>(found->first.first),
                 to = static_cast<std::size_t>(found->first.second);
      const double share = height_mm_[from] / (height_mm_[from] - height_mm_[to]);
      found->second = add((1 - share) * surface_.points_mm[from] + share * surface_.points_mm[to]);
    }
    return found->second;
  }

  Surface made;

 private:
  int add(const Eigen::Vector3d& position_mm) {
    made.points_mm.push_back(position_mm);
    return static_cast<int>(made.points_mm.size()) - 1;
  }

  const Surface& surface_;
  const std::vector<double>& height_mm_;
  std::vector<int> new_number_;
  std::map<std::pair<int, int>, int> on_edge_;
};

}  // namespace

Surface clipped(const Surface& surface, const CutSurface& cut, CutSide side) {
  std::vector<double> height_mm;
  height_mm.reserve(surface.points_mm.size());
  for (const Eigen::Vector3d& point : surface.points_mm) height_mm.push_back(cut.height_mm(point));
  const auto kept = [&](int p) { return (height_mm[static_cast<std::size_t>(p)] > 0) == (side == CutSide::above); };

  Piece piece(surface, height_mm);
  for (const auto& triangle : surface.triangles) {
    // Walked around once: what stays of a triangle has three or four corners.
    std::vector<int> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const int here = triangle[i], next = triangle[(i + 1) % 3];
      if (kept(here)) corners.push_back(piece.point(here));
      if (kept(here) != kept(next)) corners.push_back(piece.point_between(here, next));
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      piece.made.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return std::move(piece.made);
}

Surface kept_part(const Surface& surface, const std::function<bool(std::size_t triangle)>& is_kept) {
  Surface part;
  std::vector<int> number(surface.points_mm.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!is_kept(t)) continue;
    std::array<int, 3> triangle = surface.triangles[t];
    for (int& p : triangle) {
      int& known = number[static_cast<std::size_t>(p)];
      if (known < 0) {
        known = static_cast<int>(part.points_mm.size());
        part.points_mm.push_back(surface.points_mm[static_cast<std::size_t>(p)]);
      }
      p = known;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

}  // namespace glisson::geometry
