#include "mechanics/contact/internal/live_cut.h"

#include <fmt/format.h>
#include <algorithm>

#include "mechanics/contact/internal/live_step.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/strain.h"

namespace glisson::mechanics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Loads dead_loads(const Loads& loads);

}  // namespace

LiveCut::LiveCut(const LiveParts& parts, Opening opened, std::size_t advanced)
    : opening(std::move(opened)),
      advances(advanced),
      open(parts.body, parts.materials, opening, parts.standing.follower_pressure_kPa),
      others(parts.cells.without(open.cells())),
      level(parts.body, parts.levels.lattice(), parts.levels.wide_of_node(), open, opening.fronts()),
      standing_mN(opening.force_on_jumps_mN(dead_loads(parts.standing_loads))),
      of_watched(opening.jumps_at(parts.watched)) {
  const std::lock_guard lock(parts.of_last_cut->mutex);
  number_ = ++parts.of_last_cut->cuts;
}

void LiveCut::correct(StaticResult& result, const LiveParts& parts, const LiveState& state) const {
  const Index nodes = parts.unknowns();
  const VectorXd u_mm = state.u_mm.head(nodes);
  std::vector<std::uint8_t> is_open(parts.body.mesh.cells.size(), 0);
  for (const int cell : open.cells()) is_open[static_cast<std::size_t>(cell)] = 1;
  result.strain_energy_uJ = open.energy_uJ(state.u_mm);
  for (std::size_t c = 0; c < is_open.size(); ++c) {
    if (is_open[c]) continue;
    for (const TetPoint& point : tet_points_degree_2()) {
      const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() +
                                displacement_gradient(parts.body.mesh, parts.body.layout, c, point.barycentric, u_mm);
      result.strain_energy_uJ +=
          point.weight * geometry::cell_volume_mm3(parts.body.mesh, c) * energy_density_kPa(parts.materials[c], f);
    }
  }
  result.external_work_uJ += state.u_mm.tail(state.u_mm.size() - nodes).dot(standing_mN);
  result.largest_strain = state.report.largest_strain;
  result.inverted_cells = state.report.inverted_cells;
  result.notes.clear();  // about strains that are not there
  if (state.resisting_mN.size() != state.u_mm.size()) return;
  VectorXd on_fixed_mN = -(state.resisting_mN.head(nodes) + parts.standing.dead_mN);
  for (Index i = 0; i < nodes; ++i) {
    if (!parts.body.resolved.fixed[static_cast<std::size_t>(i)]) on_fixed_mN[i] = 0;
  }
  result.fixed_reaction_mN = sum_of(on_fixed_mN);
  result.support_reaction_mN = sum_of_each_support(parts.body, on_fixed_mN);
}

// u = K^-1 (f - B a) with the jumps a of the opening under f.
Result<std::shared_ptr<const Eigen::MatrixXf>> LiveCut::adjoints(const LiveParts& parts) const {
  KeptAdjoints& kept = *parts.of_last_cut;
  const std::lock_guard lock(kept.mutex);
  if (kept.of_cut == number_) return kept.values;
  MatrixXd force_mN = parts.unit_forces_at_judged();
  const Index columns = force_mN.cols(), jumps = 3 * Index{open.jumps()};
  MatrixXd jumps_mm(jumps, columns);
  for (Index c = 0; c < columns; ++c) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(c % 3);
    jumps_mm.col(c) = opening.amplitudes_mm(opening.load_of_force(c - c % 3, unit));
    force_mN.col(c) += opening.force_on_nodes_mN(jumps_mm.col(c));
  }
  auto values = std::make_shared<Eigen::MatrixXf>(parts.unknowns() + jumps, columns);
  if (columns > 0) {
    const auto answered = parts.model.respond(force_mN);
    if (!answered.converged) {
      return failure("not-converged",
                     GLISSON_TEXT("The body's answer to the cut was not found: the relative residual stayed at {0}."),
                     {fmt::format("{:.1e}", answered.relative_residual)});
    }
    *values << answered.displacement_mm.cast<float>(), jumps_mm.cast<float>();
  }
  kept.of_cut = number_;
  kept.values = values;
  return kept.values;
}

SeenPart judged_places(const LiveParts& parts) {
  const MatrixXd unit = parts.unit_forces_at_judged();
  SeenPart seen{[at = Eigen::SparseMatrix<double>(unit.transpose().sparseView())](const MatrixXd& displacement_mm) {
                  return MatrixXd(at * displacement_mm);
                },
                {}};
  for (std::size_t w = 0; w < parts.judged; ++w) seen.places.push_back({3 * static_cast<Index>(w), parts.watched[w]});
  return seen;
}

namespace {

// Gas follows the walls instead.
Loads dead_loads(const Loads& loads) {
  Loads dead = loads;
  std::erase_if(dead, [](const Load& load) { return std::holds_alternative<PressureLoad>(load); });
  return dead;
}

}  // namespace
}  // namespace glisson::mechanics
