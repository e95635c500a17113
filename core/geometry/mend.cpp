#include "geometry/mend.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "geometry/disjoint_sets.h"
#include "geometry/fields.h"
#include "geometry/nearest.h"

namespace glisson::geometry {
namespace {

using Triangle = std::array<int, 3>;
using SoupKernel = CGAL::Simple_cartesian<double>;

// A surface under repair: its triangles and where its points and triangles come from.
struct Soup {
  std::vector<SoupKernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  std::vector<int> point_from, triangle_from;
};

Soup soup_of(const Surface& surface, const std::vector<int>& point_in_place_of);
std::vector<int> first_at_each_place(const std::vector<Eigen::Vector3d>& points_mm);
int leave_out_doubled(Soup& soup);
struct Turned {
  int triangles = 0, parted_points = 0;
};
Turned turn_alike(Soup& soup, const Surface& given);
std::vector<int> piece_of_triangles(const Soup& soup);
std::vector<double> areas_of_pieces(const Soup& soup, const Surface& given, const std::vector<int>& piece);
Mended surface_of(const Surface& given, const Soup& soup, const std::vector<int>& piece, std::optional<int> kept);
void remark(Mended& mended, int count, const char* text);

}  // namespace

Result<Mended> mended(const Surface& surface, Pieces pieces) {
  if (auto checked = check_surface(surface); !checked) return failure(std::move(checked.error()));
  if (!(area_mm2(surface) > 0)) {
    return failure(Error{"surface-flat",
                         GLISSON_TEXT("No triangle of the surface has an area."),
                         {},
                         GLISSON_TEXT("Make the surface anew; a cloud of points is not one."),
                         {}});
  }
  const std::vector<int> first = first_at_each_place(surface.points_mm);
  Soup soup = soup_of(surface, first);
  const auto flat = static_cast<int>(surface.triangles.size() - soup.triangles.size());
  const int doubled = leave_out_doubled(soup);
  const Turned turned = turn_alike(soup, surface);

  const std::vector<int> piece = piece_of_triangles(soup);
  const std::vector<double> areas = areas_of_pieces(soup, surface, piece);
  const auto largest = std::max_element(areas.begin(), areas.end());
  const double share = *largest / std::accumulate(areas.begin(), areas.end(), 0.0);
  constexpr double crumbs = 0.01;
  if (pieces == Pieces::one && share < 1 - crumbs) {
    return failure(Error{"surface-in-pieces",
                         GLISSON_TEXT("The surface is in {0} pieces, between which there is no way along it; the "
                                      "largest has {1} % of its area."),
                         {std::to_string(areas.size()), fmt::format("{:.0f}", 100 * share)},
                         GLISSON_TEXT("Keep its largest piece, or join the pieces."),
                         {}});
  }
  const auto kept = pieces == Pieces::one ? std::optional(static_cast<int>(largest - areas.begin())) : std::nullopt;
  Mended mended = surface_of(surface, soup, piece, kept);
  int joined = 0;
  for (std::size_t p = 0; p < first.size(); ++p) joined += first[p] != static_cast<int>(p) ? 1 : 0;
  remark(mended, joined, GLISSON_TEXT("Points at the place of another, joined with it: {0}."));
  remark(mended, doubled + flat, GLISSON_TEXT("Doubled or empty triangles left out: {0}."));
  remark(mended, turned.triangles, GLISSON_TEXT("Triangles turned to fit their neighbours: {0}."));
  remark(mended, turned.parted_points, GLISSON_TEXT("Points parted where the surface only touches itself: {0}."));
  remark(mended, kept ? static_cast<int>(areas.size()) - 1 : 0,
         GLISSON_TEXT("Pieces left out, together below 1 % of the area: {0}."));
  return mended;
}

Surface carried_back(const Surface& given, const Mended& mended, const std::vector<Eigen::Vector3d>& moved_mm) {
  GLISSON_ASSERT(moved_mm.size() == mended.point_from.size());
  Surface carried = given;
  std::vector<bool> placed(given.points_mm.size(), false);
  for (std::size_t i = moved_mm.size(); i-- > 0;) {  // backwards: of points that were parted the first counts
    const auto from = static_cast<std::size_t>(mended.point_from[i]);
    carried.points_mm[from] = moved_mm[i];
    placed[from] = true;
  }
  if (std::find(placed.begin(), placed.end(), false) == placed.end()) return carried;
  const NearestPoint nearest(mended.surface.points_mm);
  for (std::size_t p = 0; p < placed.size(); ++p) {
    if (placed[p]) continue;
    const auto by = static_cast<std::size_t>(nearest.nearest(given.points_mm[p]).point);
    carried.points_mm[p] += moved_mm[by] - mended.surface.points_mm[by];
  }
  return carried;
}

namespace {

void remark(Mended& mended, int count, const char* text) {
  if (count > 0) mended.remarks.push_back({text, {std::to_string(count)}});
}

// For each point the first that lies exactly there.
std::vector<int> first_at_each_place(const std::vector<Eigen::Vector3d>& points_mm) {
  std::map<std::array<double, 3>, int> at;
  std::vector<int> first(points_mm.size());
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    const std::array<double, 3> place{points_mm[p].x() + 0.0, points_mm[p].y() + 0.0, points_mm[p].z() + 0.0};
    first[p] = at.try_emplace(place, static_cast<int>(p)).first->second;
  }
  return first;
}

Soup soup_of(const Surface& surface, const std::vector<int>& point_in_place_of) {
  Soup soup;
  for (const Eigen::Vector3d& p : surface.points_mm) soup.points.emplace_back(p.x(), p.y(), p.z());
  soup.point_from.resize(surface.points_mm.size());
  std::iota(soup.point_from.begin(), soup.point_from.end(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::vector<std::size_t> corners;
    for (const int corner : surface.triangles[t]) {
      corners.push_back(static_cast<std::size_t>(point_in_place_of[static_cast<std::size_t>(corner)]));
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    soup.triangles.push_back(std::move(corners));
    soup.triangle_from.push_back(static_cast<int>(t));
  }
  return soup;
}

int leave_out_doubled(Soup& soup) {
  std::set<std::vector<std::size_t>> seen;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    std::vector<std::size_t> sorted = soup.triangles[t];
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(std::move(sorted)).second) continue;
    if (kept != t) soup.triangles[kept] = std::move(soup.triangles[t]);
    soup.triangle_from[kept++] = soup.triangle_from[t];
  }
  const auto left_out = static_cast<int>(soup.triangles.size() - kept);
  soup.triangles.resize(kept);
  soup.triangle_from.resize(kept);
  return left_out;
}

// Keeps account of what CGAL does.
struct Account : CGAL::Polygon_mesh_processing::Default_orientation_visitor {
  std::vector<int>* point_from = nullptr;
  void duplicated_vertex(std::size_t old, std::size_t) { point_from->push_back((*point_from)[old]); }
};

bool is_turned(const std::vector<std::size_t>& now, const std::vector<int>& point_from, const Triangle& given,
               const std::vector<Eigen::Vector3d>& points_mm) {
  // Where the first corner stands now, and which of the other two follows it; places, since points may be joined.
  const auto at = [&](std::size_t i) -> const Eigen::Vector3d& {
    return points_mm[static_cast<std::size_t>(point_from[now[i % 3]])];
  };
  const auto was = [&](std::size_t i) -> const Eigen::Vector3d& {
    return points_mm[static_cast<std::size_t>(given[i])];
  };
  std::size_t first = 0;
  while (first < 2 && at(first) != was(0)) ++first;
  return at(first + 1) != was(1);
}

Turned turn_alike(Soup& soup, const Surface& given) {
  Account account;
  account.point_from = &soup.point_from;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.triangles, CGAL::parameters::visitor(account));
  // CGAL turns each piece as its first triangle; most of it decides.
  const std::vector<int> piece = piece_of_triangles(soup);
  std::vector<std::array<int, 2>> votes(soup.triangles.size(), {0, 0});
  std::vector<bool> turned(soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& triangle = given.triangles[static_cast<std::size_t>(soup.triangle_from[t])];
    turned[t] = is_turned(soup.triangles[t], soup.point_from, triangle, given.points_mm);
    ++votes[static_cast<std::size_t>(piece[t])][turned[t] ? 1 : 0];
  }
  Turned result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& [as_given, reversed] = votes[static_cast<std::size_t>(piece[t])];
    const bool back = reversed > as_given;
    if (back) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    result.triangles += turned[t] != back ? 1 : 0;
  }
  result.parted_points = static_cast<int>(soup.points.size() - given.points_mm.size());
  return result;
}

// Pieces hang together by points; numbered from 0.
std::vector<int> piece_of_triangles(const Soup& soup) {
  DisjointSets sets(soup.points.size());
  for (const auto& corners : soup.triangles) {
    sets.join(corners[0], corners[1]);
    sets.join(corners[1], corners[2]);
  }
  std::map<std::size_t, int> number_of_root;
  std::vector<int> piece;
  for (const auto& corners : soup.triangles) {
    const std::size_t root = sets.root(corners[0]);
    piece.push_back(number_of_root.try_emplace(root, static_cast<int>(number_of_root.size())).first->second);
  }
  return piece;
}

std::vector<double> areas_of_pieces(const Soup& soup, const Surface& given, const std::vector<int>& piece) {
  std::vector<double> areas(static_cast<std::size_t>(*std::max_element(piece.begin(), piece.end())) + 1, 0.0);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& [a, b, c] = given.triangles[static_cast<std::size_t>(soup.triangle_from[t])];
    const auto at = [&](int point) { return given.points_mm[static_cast<std::size_t>(point)]; };
    areas[static_cast<std::size_t>(piece[t])] += 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
  }
  return areas;
}

Mended surface_of(const Surface& given, const Soup& soup, const std::vector<int>& piece, std::optional<int> kept) {
  Mended mended;
  std::vector<int> number(soup.points.size(), -1), triangles;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (kept && piece[t] != *kept) continue;
    triangles.push_back(soup.triangle_from[t]);
    for (const std::size_t corner : soup.triangles[t]) number[corner] = 0;
  }
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    number[p] = static_cast<int>(mended.point_from.size());
    mended.point_from.push_back(soup.point_from[p]);
    mended.surface.points_mm.push_back(given.points_mm[static_cast<std::size_t>(soup.point_from[p])]);
  }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (kept && piece[t] != *kept) continue;
    const auto& corners = soup.triangles[t];
    mended.surface.triangles.push_back({number[corners[0]], number[corners[1]], number[corners[2]]});
  }
  mended.surface.point_fields = select(given.point_fields, mended.point_from);
  mended.surface.cell_fields = select(given.cell_fields, triangles);
  return mended;
}

}  // namespace
}  // namespace glisson::geometry
