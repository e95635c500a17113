#include "mechanics/cutting/internal/surface_in_body.h"

#include <algorithm>

#include "mechanics/cutting/internal/jump_functions.h"

namespace glisson::mechanics {
namespace {

std::vector<double> volumes_around_mm3(const geometry::TetMesh& mesh);
bool is_fixed(const Body& body, int point);

}  // namespace

std::shared_ptr<const SurfaceInBody> surface_in_body(const Body& body, const CutStrip& first) {
  auto made = std::make_shared<SurfaceInBody>();
  made->surface = first.surface;
  made->crossing = crossing_of(body.mesh, first.surface);
  made->begin_mm = first.from_mm;
  made->forward = (first.to_mm - first.from_mm).normalized();
  const std::vector<double> around_mm3 = volumes_around_mm3(body.mesh);
  std::vector<std::pair<double, int>> in_order;
  for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
    const int point = static_cast<int>(p);
    if (made->crossing.cells_of_point[p].empty() || is_fixed(body, point)) continue;
    constexpr double next_to_nothing = 1e-4;
    if (share_filled(body.mesh, made->crossing, point, around_mm3) < next_to_nothing) continue;
    in_order.emplace_back((body.mesh.points_mm[p] - made->begin_mm).dot(made->forward), point);
  }
  std::sort(in_order.begin(), in_order.end());
  for (const auto& [at_mm, point] : in_order) {
    made->candidates.push_back(point);
    made->at_mm.push_back(at_mm);
  }
  made->coupling = coupling(body, made->crossing, made->candidates);
  made->solved.resize(made->candidates.size());
  return made;
}

namespace {

std::vector<double> volumes_around_mm3(const geometry::TetMesh& mesh) {
  std::vector<double> volumes_mm3(mesh.points_mm.size(), 0.0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int point : mesh.cells[c]) volumes_mm3[point] += geometry::cell_volume_mm3(mesh, c);
  }
  return volumes_mm3;
}

bool is_fixed(const Body& body, int point) {
  const auto first = body.resolved.fixed.begin() + 3 * static_cast<std::ptrdiff_t>(body.layout.node_of_point[point]);
  return std::any_of(first, first + 3, [](std::uint8_t fixed) { return fixed != 0; });
}

}  // namespace
}  // namespace glisson::mechanics
