#include "guidance/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/line_and_triangle.h"

namespace glisson::guidance {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr std::size_t shortest_outline_px = 12;  // around it: less is a speck of a surface that grazes the sight
constexpr std::size_t shortest_piece_px = 4;

double mean_depth_mm(const std::vector<Vector3d>& points_mm) {
  double sum = 0;
  for (const Vector3d& point : points_mm) sum += point.z();
  return points_mm.empty() ? 0 : sum / static_cast<double>(points_mm.size());
}

// The triangles all of whose corners lie before the camera.
std::vector<std::array<Vector2d, 3>> projected(const vision::Camera& camera, const std::vector<Vector3d>& points_mm,
                                               const std::vector<std::array<int, 3>>& triangles) {
  const auto pixels = vision::project(camera, points_mm);
  std::vector<std::array<Vector2d, 3>> shown;
  for (const auto& [a, b, c] : triangles) {
    const auto &pa = pixels[static_cast<std::size_t>(a)], &pb = pixels[static_cast<std::size_t>(b)],
               &pc = pixels[static_cast<std::size_t>(c)];
    if (pa && pb && pc) shown.push_back({*pa, *pb, *pc});
  }
  return shown;
}

// A closed line of pixels without their steps: the mean over a few neighbours.
std::vector<Vector2d> smoothed(const std::vector<Vector2d>& line) {
  constexpr std::ptrdiff_t reach = 3;
  const auto n = static_cast<std::ptrdiff_t>(line.size());
  std::vector<Vector2d> smooth(line.size(), Vector2d::Zero());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      smooth[static_cast<std::size_t>(i)] += line[static_cast<std::size_t>((i + k + n) % n)] / (2 * reach + 1.0);
    }
  }
  return smooth;
}

// What of a picture an outline may stand on.
class Canvas {
 public:
  Canvas(int width, int height, const std::vector<std::uint8_t>& hidden)
      : width_(width), height_(height), hidden_(hidden) {}

  [[nodiscard]] bool shows(const Vector2d& pixel) const {
    const int x = static_cast<int>(std::lround(pixel.x())), y = static_cast<int>(std::lround(pixel.y()));
    if (x < 1 || y < 1 || x > width_ - 2 || y > height_ - 2) return false;
    return hidden_.empty() || hidden_[static_cast<std::size_t>(x + width_ * y)] == 0;
  }

 private:
  int width_, height_;
  const std::vector<std::uint8_t>& hidden_;
};

// The parts of a closed line that the canvas shows; a whole line ends where it begins.
std::vector<std::vector<Vector2d>> shown_parts(const std::vector<Vector2d>& line, const Canvas& canvas) {
  std::vector<bool> shown;
  for (const Vector2d& pixel : line) shown.push_back(canvas.shows(pixel));
  const std::vector<Vector2d> smooth = smoothed(line);
  const std::size_t n = line.size();
  const auto gap = static_cast<std::size_t>(std::find(shown.begin(), shown.end(), false) - shown.begin());
  std::vector<std::vector<Vector2d>> parts;
  if (gap == n) {
    parts.push_back(smooth);
    parts.back().push_back(smooth.front());
    return parts;
  }
  bool open = false;
  for (std::size_t k = 1; k <= n; ++k) {  // from the gap on, round to it
    const std::size_t i = (gap + k) % n;
    if (shown[i] && !open) parts.emplace_back();
    if (shown[i]) parts.back().push_back(smooth[i]);
    open = shown[i];
  }
  std::erase_if(parts, [](const auto& part) { return part.size() < shortest_piece_px; });
  return parts;
}

// What the fit says of a structure's places: where each is in the picture, and its error.
struct JudgedPlaces {
  std::vector<Vector2d> pixels;
  std::vector<double> sd_mm;
  double largest_mm = unknown;

  JudgedPlaces(const vision::Camera& camera, const EmbeddedStructure& structure, const ElasticPlacement& placement) {
    if (structure.judged == 0 || placement.further_mm.size() < structure.first_judged + structure.judged) return;
    const auto from = placement.further_mm.begin() + static_cast<std::ptrdiff_t>(structure.first_judged);
    const auto seen = vision::project(camera, {from, from + static_cast<std::ptrdiff_t>(structure.judged)});
    largest_mm = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double sd = placement.further_sd_mm[structure.first_judged + k];
      largest_mm = std::max(largest_mm, sd);
      if (!seen[k]) continue;
      pixels.push_back(*seen[k]);
      sd_mm.push_back(sd);
    }
  }

  [[nodiscard]] double sd_at_mm(const Vector2d& pixel) const {
    double nearest = unknown, sd = unknown;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const double distance = (pixels[k] - pixel).squaredNorm();
      if (distance < nearest) nearest = distance, sd = sd_mm[k];
    }
    return sd;
  }
};

std::vector<OutlinePiece> pieces_around(const vision::Camera& camera, int width, int height,
                                        const std::vector<Vector3d>& points_mm,
                                        const std::vector<std::array<int, 3>>& triangles, const Canvas& canvas,
                                        const JudgedPlaces& judged) {
  std::vector<OutlinePiece> pieces;
  for (const auto& line : vision::outlines(width, height, projected(camera, points_mm, triangles))) {
    if (line.size() < shortest_outline_px) continue;
    for (auto& part : shown_parts(line, canvas)) {
      OutlinePiece piece{std::move(part), {}};
      for (const Vector2d& pixel : piece.line_px) piece.sd_mm.push_back(judged.sd_at_mm(pixel));
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

// What of a line on the organ's surface is turned to the camera and shown.
std::vector<OutlinePiece> pieces_on_organ(const std::vector<SurfaceLine>& lines, const vision::Camera& camera,
                                          const std::vector<Vector3d>& organ_mm,
                                          const std::vector<std::array<int, 3>>& triangles, const Canvas& canvas,
                                          const JudgedPlaces& judged) {
  const auto faces_camera = [&](int triangle) {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
    const Vector3d& corner = organ_mm[static_cast<std::size_t>(a)];
    const Vector3d normal =
        (organ_mm[static_cast<std::size_t>(b)] - corner).cross(organ_mm[static_cast<std::size_t>(c)] - corner);
    return normal.dot(corner) < 0;
  };
  std::vector<OutlinePiece> pieces;
  for (const SurfaceLine& line : lines) {
    const auto pixels = vision::project(camera, places_of(line, organ_mm));
    bool open = false;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const bool shown = pixels[i] && canvas.shows(*pixels[i]);
      if (!open && shown) pieces.emplace_back();
      if (shown) {
        pieces.back().line_px.push_back(*pixels[i]);
        pieces.back().sd_mm.push_back(judged.sd_at_mm(*pixels[i]));
      }
      open = shown && i < line.triangles.size() && faces_camera(line.triangles[i]);
    }
  }
  std::erase_if(pieces, [](const OutlinePiece& piece) { return piece.line_px.size() < 2; });
  return pieces;
}

// How far behind the organ's front each of the places lies; the minimum, or nothing where the front is before none.
std::optional<double> minimum_depth_mm(const std::vector<Vector3d>& organ_mm,
                                       const std::vector<std::array<int, 3>>& triangles,
                                       const std::vector<Vector3d>& places_mm) {
  std::optional<double> minimum;
  for (const Vector3d& place : places_mm) {
    const double away_mm = place.norm();
    if (place.z() <= 0) continue;
    const Vector3d sight = place / away_mm;
    double front_mm = away_mm;
    for (const auto& [a, b, c] : triangles) {
      const auto corner = [&](int point) -> const Vector3d& { return organ_mm[static_cast<std::size_t>(point)]; };
      const auto met = geometry::line_meets_triangle(Vector3d::Zero(), sight, corner(a), corner(b), corner(c));
      if (met && met->at > 0) front_mm = std::min(front_mm, met->at);
    }
    if (!minimum || away_mm - front_mm < *minimum) minimum = away_mm - front_mm;
  }
  return minimum;
}

// The places at which a structure's depth is taken: a few suffice.
std::vector<Vector3d> some_of(const std::vector<Vector3d>& points_mm) {
  constexpr std::size_t some = 12;
  std::vector<Vector3d> taken;
  const std::size_t step = std::max<std::size_t>(1, points_mm.size() / some);
  for (std::size_t p = 0; p < points_mm.size(); p += step) taken.push_back(points_mm[p]);
  return taken;
}

}  // namespace

EmbeddedStructure embedded(std::string name, const vision::Rgb& colour, geometry::Surface at_rest,
                           const geometry::TetMesh& mesh) {
  auto places = mechanics::locate_points(mesh, at_rest.points_mm);
  return {std::move(name), colour, std::move(at_rest), std::move(places)};
}

std::vector<Vector3d> spread_over(const geometry::Surface& surface, std::size_t count) {
  const std::vector<Vector3d>& among = surface.points_mm;
  std::vector<double> apart_mm2(among.size(), unknown);
  std::vector<Vector3d> chosen;
  for (std::size_t next = 0; chosen.size() < std::min(count, among.size());) {
    chosen.push_back(among[next]);
    for (std::size_t i = 0; i < among.size(); ++i) {
      apart_mm2[i] = std::min(apart_mm2[i], (among[i] - chosen.back()).squaredNorm());
    }
    next = static_cast<std::size_t>(std::max_element(apart_mm2.begin(), apart_mm2.end()) - apart_mm2.begin());
  }
  return chosen;
}

std::vector<Vector3d> placed_points_mm(const EmbeddedStructure& structure, const geometry::TetMesh& mesh,
                                       const ElasticPlacement& placement) {
  std::vector<Vector3d> points_mm = structure.at_rest.points_mm;
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    const mechanics::PointInMesh& place = structure.places[p];
    const auto& corners = mesh.cells[static_cast<std::size_t>(place.cell)];
    for (int k = 0; k < 4; ++k) {
      points_mm[p] += place.barycentric[k] *
                      placement.displacement_mm[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
    }
    points_mm[p] = placement.pose * points_mm[p];
  }
  return points_mm;
}

std::vector<OutlinePiece> outlines_of(const vision::Camera& camera, int width, int height,
                                      const geometry::Surface& seen_mm) {
  const std::vector<std::uint8_t> nothing_hidden;
  return pieces_around(camera, width, height, seen_mm.points_mm, seen_mm.triangles,
                       Canvas(width, height, nothing_hidden), JudgedPlaces(camera, {}, {}));
}

std::vector<PlacedOutline> placed_outlines(const vision::Camera& camera, int width, int height,
                                           const geometry::TetMesh& mesh,
                                           const std::vector<EmbeddedStructure>& structures,
                                           const ElasticPlacement& placement, const std::vector<std::uint8_t>& hidden) {
  std::vector<PlacedOutline> outlines;
  if (!placement.converged || structures.empty()) return outlines;
  const Canvas canvas(width, height, hidden);
  const std::vector<Vector3d> organ_mm = placed_points_mm(structures.front(), mesh, placement);
  const JudgedPlaces judged_organ(camera, structures.front(), placement);
  for (std::size_t s = 0; s < structures.size(); ++s) {
    const EmbeddedStructure& structure = structures[s];
    if (!structure.on_organ.empty()) {
      PlacedOutline lines{s, 0, 0, {}, {}};
      lines.pieces = pieces_on_organ(structure.on_organ, camera, organ_mm, structures.front().at_rest.triangles, canvas,
                                     judged_organ);
      for (const OutlinePiece& piece : lines.pieces) {
        lines.sd_mm = std::max(lines.sd_mm, *std::max_element(piece.sd_mm.begin(), piece.sd_mm.end()));
      }
      outlines.push_back(std::move(lines));
      continue;
    }
    const std::vector<Vector3d> points_mm = s == 0 ? organ_mm : placed_points_mm(structure, mesh, placement);
    const JudgedPlaces judged(camera, structure, placement);
    PlacedOutline outline{s, mean_depth_mm(points_mm), judged.largest_mm, {}, {}};
    if (s > 0) {
      outline.deep_mm = minimum_depth_mm(organ_mm, structures.front().at_rest.triangles, some_of(points_mm));
    }
    outline.pieces = pieces_around(camera, width, height, points_mm, structure.at_rest.triangles, canvas, judged);
    outlines.push_back(std::move(outline));
  }
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const PlacedOutline& a, const PlacedOutline& b) { return a.depth_mm > b.depth_mm; });
  return outlines;
}

void draw_outlines(vision::Frame& frame, const std::vector<EmbeddedStructure>& structures,
                   const std::vector<PlacedOutline>& outlines) {
  const int width_px = std::max(2, frame.height / 240);
  constexpr vision::Rgb rim{15, 15, 15};
  for (const PlacedOutline& outline : outlines) {
    for (const OutlinePiece& piece : outline.pieces) {
      vision::draw_line(frame, piece.line_px, rim, width_px + 2);
      vision::draw_line(frame, piece.line_px, structures[outline.structure].colour, width_px);
    }
  }
}

}  // namespace glisson::guidance
