#include "mechanics/elements/load_vector.h"

#include <cmath>

namespace glisson::mechanics {
namespace {

Failure invalid(const std::string& which, const std::string& text) { return failure("load-invalid", text, {which}); }

void add_gravity(const geometry::TetMesh& mesh, const NodeLayout& layout, const Eigen::Vector3d& force_per_mm3,
                 Eigen::VectorXd& force_mN) {
  // Integrals of the shape functions over a cell: a quarter of the volume at each node of a linear one; -1/20 at the
  // corners and 1/5 at the middles of a quadratic one.
  const double corner = layout.order == ElementOrder::linear ? 0.25 : -0.05;
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const Eigen::Vector3d cell_force = geometry::cell_volume_mm3(mesh, c) * force_per_mm3;
    for (int i = 0; i < layout.nodes_per_cell(); ++i) {
      force_mN.segment<3>(3 * layout.cells[c][i]) += (i < 4 ? corner : 0.2) * cell_force;
    }
  }
}

}  // namespace

Result<Eigen::VectorXd> load_vector(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                    const std::vector<BoundaryFace>& boundary, double density_kg_mm3,
                                    const Loads& loads) {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout.nodes()));
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const std::string which = std::to_string(l + 1);
    if (const auto* tool = std::get_if<ToolLoad>(&loads[l])) {
      if (!tool->center_mm.allFinite() || !tool->force_mN.allFinite()) {
        return invalid(which, GLISSON_TEXT("The tool of load {0} needs a finite centre and force."));
      }
      if (!std::isfinite(tool->radius_mm) || tool->radius_mm <= 0) {
        return invalid(which, GLISSON_TEXT("The tool of load {0} needs a radius above zero."));
      }
      const auto touched = spread(*tool, boundary);
      if (!touched) return failure(touched.error());
      for (const std::size_t f : touched->faces) add_traction(boundary[f], touched->traction_kPa, force_mN);
    } else if (const auto* pressure = std::get_if<PressureLoad>(&loads[l])) {
      if (!std::isfinite(pressure->pressure_kPa))
        return invalid(which, GLISSON_TEXT("The pressure of load {0} is not a finite number."));
      for (const BoundaryFace& face : boundary) add_traction(face, -pressure->pressure_kPa * face.normal, force_mN);
    } else {
      const auto& gravity = std::get<GravityLoad>(loads[l]);
      if (!gravity.acceleration_mm_s2.allFinite())
        return invalid(which, GLISSON_TEXT("The gravity of load {0} is not a finite vector."));
      add_gravity(mesh, layout, density_kg_mm3 * gravity.acceleration_mm_s2, force_mN);
    }
  }
  return force_mN;
}

Result<SpreadForce> spread(const ToolLoad& tool, const std::vector<BoundaryFace>& boundary) {
  return faces_within(boundary, tool.center_mm, tool.radius_mm).map([&](std::vector<std::size_t> faces) {
    double area_mm2 = 0;
    for (const std::size_t f : faces) area_mm2 += boundary[f].area_mm2;
    return SpreadForce{std::move(faces), tool.force_mN / area_mm2};
  });
}

Result<AppliedLoads> applied_loads(const Body& body, const Loads& loads, PressureKind kind) {
  AppliedLoads applied;
  Loads dead;
  for (const Load& load : loads) {
    const auto* pressure = std::get_if<PressureLoad>(&load);
    if (pressure != nullptr && kind == PressureKind::follower && std::isfinite(pressure->pressure_kPa)) {
      applied.follower_pressure_kPa += pressure->pressure_kPa;
    } else {
      dead.push_back(load);
    }
  }
  auto force_mN = load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, dead);
  if (!force_mN) return failure(std::move(force_mN.error()));
  applied.dead_mN = std::move(*force_mN);
  return applied;
}

}  // namespace glisson::mechanics
