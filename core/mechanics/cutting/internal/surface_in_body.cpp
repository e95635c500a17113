#include "mechanics/cutting/internal/surface_in_body.h"

#include <algorithm>
#include <atomic>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const SurfaceInBody> along(const StaticModel& model, const Loads& standing_loads, const CutStrip& first,
                                           Crossing crossing);
// How the walls lead along a strip: how much of them lies in it (mm2), and how far off it at most (mm).
struct Led {
  double area_mm2 = 0, off_mm = 0;
};
Led led_along(const geometry::TetMesh& mesh, const Crossing& crossing, const CutStrip& strip);
double mean_edge_mm(const geometry::TetMesh& mesh, const Crossing& crossing);

}  // namespace

std::shared_ptr<const SurfaceInBody> surface_in_body(const StaticModel& model, const Loads& standing_loads,
                                                     const CutStrip& first) {
  const geometry::TetMesh& mesh = model.mesh();
  return along(model, standing_loads, first, crossing_of(mesh, first.surface, heights_mm(mesh, first.surface)));
}

Result<std::shared_ptr<const SurfaceInBody>> grown_surface(const StaticModel& model, const Loads& standing_loads,
                                                           const SurfaceInBody& before, const std::vector<int>& open,
                                                           const CutStrip& strip) {
  const geometry::TetMesh& mesh = model.mesh();
  std::vector<std::uint8_t> is_open(mesh.points_mm.size(), 0);
  for (const int point : open) is_open[point] = 1;
  const std::vector<double> drawn_mm = heights_mm(mesh, strip.surface);
  std::vector<double> height_mm = drawn_mm;
  for (const auto& corners : mesh.cells) {
    if (std::none_of(corners.begin(), corners.end(), [&](int p) { return is_open[p] != 0; })) continue;
    for (const int p : corners) height_mm[p] = before.crossing.height_mm[p];
  }
  Crossing crossing = crossing_of(mesh, strip.surface, std::move(height_mm));
  const Led wanted = led_along(mesh, crossing_of(mesh, strip.surface, drawn_mm), strip);
  const Led led = led_along(mesh, crossing, strip);
  // Along what was drawn both are the same but for what a wall bends within a cell or two.
  constexpr double minimum = 0.75, maximum = 1.25;
  if (led.off_mm > 0.5 * mean_edge_mm(mesh, crossing) || led.area_mm2 < minimum * wanted.area_mm2 ||
      led.area_mm2 > maximum * wanted.area_mm2) {
    return failure(
        Error{"cut-turns",
              GLISSON_TEXT("The line turns more sharply than the model's cells can follow, or meets itself."),
              {},
              GLISSON_TEXT("Draw a wider curve, or begin a new cut farther away."),
              {}});
  }
  return along(model, standing_loads, strip, std::move(crossing));
}

namespace {

std::shared_ptr<const SurfaceInBody> along(const StaticModel& model, const Loads& standing_loads, const CutStrip& first,
                                           Crossing crossing) {
  static std::atomic<std::uint64_t> numbers = 0;
  const Body& body = model.body();
  auto made = std::make_shared<SurfaceInBody>();
  made->number = ++numbers;
  made->surface = first.surface;
  made->crossing = std::move(crossing);
  made->begin_mm = first.from_mm;
  made->forward = (first.to_mm - first.from_mm).normalized();
  const ReducedFunctions* reduced = model.reduced_functions();
  made->functions = reduced == nullptr ? point_jumps(body, made->crossing, made->begin_mm, made->forward)
                                       : split_functions(body, made->crossing, *reduced, made->begin_mm, made->forward);
  made->standing_load = made->functions->load_on(standing_loads);
  made->solved.resize(made->functions->points_of.size());
  return made;
}

Led led_along(const geometry::TetMesh& mesh, const Crossing& crossing, const CutStrip& strip) {
  const CutSoFar within({strip});
  Led led;
  for (const CrossedCell& crossed : crossing.cells) {
    Eigen::Matrix<double, 3, 4> corner_mm;
    for (int i = 0; i < 4; ++i) corner_mm.col(i) = mesh.points_mm[mesh.cells[crossed.cell][i]];
    for (const auto& [at, area_mm2] : places_on_wall(crossed, corner_mm)) {
      const Vector3d place_mm = corner_mm * at;
      if (!within.covers(place_mm)) continue;
      led.area_mm2 += area_mm2;
      led.off_mm = std::max(led.off_mm, std::abs(strip.surface.height_mm(place_mm)));
    }
  }
  return led;
}

double mean_edge_mm(const geometry::TetMesh& mesh, const Crossing& crossing) {
  double sum_mm = 0;
  for (const CrossedCell& crossed : crossing.cells) {
    const auto& corners = mesh.cells[crossed.cell];
    for (int i = 1; i < 4; ++i) sum_mm += (mesh.points_mm[corners[i]] - mesh.points_mm[corners[0]]).norm();
  }
  return sum_mm / (3.0 * static_cast<double>(std::max<std::size_t>(1, crossing.cells.size())));
}

}  // namespace
}  // namespace glisson::mechanics
