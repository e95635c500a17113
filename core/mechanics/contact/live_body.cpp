#include "mechanics/contact/live_body.h"

#include "mechanics/contact/internal/live_step.h"
#include "mechanics/cutting/opened_surface.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/quadratic.h"
#include "mechanics/potentials/total_potential.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// In units of the tissue's own stiffness, those of tools spread over their area. Stiffer tools are not balanced in the
// few gradients of a picture, in Veronda and Westmann's tissue; softer ones enter too deep at rest and need
// multipliers, at each move of which a smooth tool starts to slide. Stiffer walls let fewer of the places across a cut
// take part at once. Those of tools were found on paths 0 and 1 of bench_casefile's SessionAtLargeStrain, that of walls
// on the block of tests/widgets/block_patient.h, cut half through under a probe and a grasper.
constexpr double shown_penalty = 60, settling_penalty = 300, friction_penalty = 10, jaw_penalty = 10, wall_penalty = 2;

}  // namespace

struct LiveBody::Impl {
  std::shared_ptr<const LiveParts> parts;
  std::shared_ptr<const LiveCut> cut;  // nullptr: nothing is cut

  [[nodiscard]] LiveStep step(const LiveState& from, const std::vector<ContactTool>& tools, const LiveOptions& options,
                              const Progress& progress = {}) const {
    return {*parts, cut.get(), from, tools, options, progress};
  }
};

Result<LiveBody> LiveBody::create(StaticModel model, const ChosenLaw& law, const std::vector<Support>& supports,
                                  const Loads& standing_loads, std::vector<PointInMesh> watched, std::size_t judged,
                                  const Eigen::VectorXd& inertia_mN_mm) {
  const StaticOptions options = model.options();
  const bool known = law.law == MaterialLaw::neo_hookean || law.law == MaterialLaw::veronda_westmann;
  if (!known || options.anisotropy || options.order != ElementOrder::quadratic) {
    return failure("not-available", GLISSON_TEXT("At large strain a session knows quadratic cells of a neo-Hookean or "
                                                 "Veronda-Westmann material without a grain."));
  }
  auto prepared = prepare_body(model.mesh(), model.youngs_kPa(), supports, options, Holding::required);
  if (!prepared) return failure(std::move(prepared.error()));
  auto made = std::make_shared<LiveParts>(std::move(model), std::move(*prepared), law);
  LiveParts& parts = *made;
  auto loads = applied_loads(parts.body, standing_loads, PressureKind::follower);
  if (!loads) return failure(std::move(loads.error()));
  parts.standing_loads = standing_loads;
  parts.standing = std::move(*loads);
  parts.around = boundary_potentials(parts.body, parts.standing.follower_pressure_kPa);
  Potentials inertia;
  if (inertia_mN_mm.size() > 0) {
    parts.inertia_mN_mm = Eigen::SparseMatrix<double>(inertia_mN_mm.asDiagonal());
    inertia.push_back(
        std::make_shared<QuadraticPotential>(1.0, parts.inertia_mN_mm, VectorXd::Zero(inertia_mN_mm.size())));
    parts.around.push_back(inertia.back());
  }
  parts.surface = geometry::boundary_surface(parts.body.mesh);
  for (const double p : geometry::find_field(parts.surface.point_fields, "mesh_point")->values) {
    parts.node_of_point.push_back(parts.body.layout.node_of_point[static_cast<std::size_t>(p)]);
  }
  parts.watched = std::move(watched);
  parts.judged = judged;
  parts.k_mN_mm = penalty_stiffness_mN_mm(jaw_penalty, parts.body, parts.surface);
  parts.pressing_kPa_mm = penalty_stiffness_kPa_mm(shown_penalty, parts.body, parts.surface);
  parts.settling_kPa_mm = penalty_stiffness_kPa_mm(settling_penalty, parts.body, parts.surface);
  parts.friction_kPa_mm = penalty_stiffness_kPa_mm(friction_penalty, parts.body, parts.surface);
  parts.k_wall_mN_mm = penalty_stiffness_mN_mm(wall_penalty, parts.body, parts.surface);
  if (judged > 0) {
    const auto answered = parts.model.respond(parts.unit_forces_at_judged());
    parts.adjoints = std::make_shared<Eigen::MatrixXf>(answered.displacement_mm.cast<float>());
  }
  // Under the standing loads, put on in parts where all of them at once find no rest.
  const VectorXd rest_mm = VectorXd::Zero(parts.unknowns());
  const TotalPotential potential =
      TotalPotential(parts.body, static_potentials(parts.body, parts.materials, parts.standing)).with(inertia);
  if (!parts.levels.refresh(potential.tangent(rest_mm, Tangent::positive))) {
    return failure("not-converged", GLISSON_TEXT("The body has no rest under its standing loads."));
  }
  LiveState standing;
  standing.u_mm = rest_mm;
  if (parts.standing.dead_mN.norm() > 0 || parts.standing.follower_pressure_kPa != 0) {
    const auto found = find_equilibrium(parts.body, parts.materials, parts.standing, {.relative_tolerance = 1e-4});
    if (!found) return failure(found.error());
    if (!found->converged()) {
      return failure("not-converged", GLISSON_TEXT("The equilibrium was not found. {0}"), {found->why_stopped});
    }
    standing.u_mm = nodal_displacements(parts.body.layout, *found);
    parts.levels.refresh(potential.tangent(standing.u_mm, Tangent::positive));
  }
  const std::vector<ContactTool> no_tools;
  LiveOptions usual;
  if (!inertia.empty()) {
    usual.besides_mN = std::make_shared<const VectorXd>(inertia_mN_mm.cwiseProduct(standing.u_mm));
  }
  auto untouched = LiveStep(parts, nullptr, standing, no_tools, usual, {}).run(standing, Until::settled);
  if (!untouched) return failure(std::move(untouched.error()));
  if (!untouched->settled) {
    return failure("not-converged", GLISSON_TEXT("The body has no rest under its standing loads."));
  }
  parts.untouched = std::move(*untouched);
  return LiveBody(std::make_shared<Impl>(Impl{std::move(made), nullptr}));
}

Result<LiveState> LiveBody::step(const LiveState& from, const std::vector<ContactTool>& tools,
                                 const LiveOptions& options) const {
  return impl_->step(from, tools, options).run(from, Until::shown);
}

Result<LiveState> LiveBody::settle(const LiveState& from, const std::vector<ContactTool>& tools,
                                   const LiveOptions& options, const Progress& progress) const {
  return impl_->step(from, tools, options, progress).run(from, Until::settled);
}

Result<LiveBody> LiveBody::opened(const CutStrip& strip) const {
  const LiveParts& parts = *impl_->parts;
  auto before = impl_->cut ? Result<Opening>(impl_->cut->opening) : Opening::of(parts.model, {}, judged_places(parts));
  if (!before) return failure(std::move(before.error()));
  auto advanced = before->advanced(strip);
  if (!advanced) return failure(std::move(advanced.error()));
  const std::size_t advances = impl_->cut ? impl_->cut->advances + 1 : 1;
  auto cut = std::make_shared<LiveCut>(parts, std::move(*advanced), advances);
  if (auto weighed = cut->adjoints(parts); !weighed) return failure(std::move(weighed.error()));
  return LiveBody(std::make_shared<Impl>(Impl{impl_->parts, std::move(cut)}));
}

const Opening* LiveBody::opening() const { return impl_->cut ? &impl_->cut->opening : nullptr; }

Result<bool> LiveBody::prepare(const CutStrip& ahead) const {
  return impl_->cut ? impl_->cut->opening.prepare(ahead) : Result<bool>(false);
}

std::vector<Vector3d> LiveBody::jumps_mm(const LiveState& state) const {
  std::vector<Vector3d> jumps_mm;
  for (auto at = impl_->parts->unknowns(); at < state.u_mm.size(); at += 3) {
    jumps_mm.emplace_back(state.u_mm.segment<3>(at));
  }
  return jumps_mm;
}

geometry::Surface LiveBody::opened_surface(const LiveState& state) const {
  const Body& body = impl_->parts->body;
  std::vector<Vector3d> moved_mm;
  for (const int node : body.layout.node_of_point) {
    moved_mm.push_back(node < 0 ? Vector3d(0, 0, 0) : Vector3d(state.u_mm.segment<3>(3 * node)));
  }
  return mechanics::opened_surface(body.mesh, surface(),
                                   opening() == nullptr ? std::vector<OpenCell>() : opening()->cells(), moved_mm,
                                   jumps_mm(state));
}

StaticResult LiveBody::whole_result(const LiveState& state) const {
  const LiveParts& parts = *impl_->parts;
  const VectorXd u_mm = state.u_mm.head(parts.unknowns());
  StaticResult result = state_of(parts.body, parts.materials, u_mm, parts.standing, VectorXd::Zero(u_mm.size()));
  if (impl_->cut) impl_->cut->correct(result, parts, state);
  result.status = state.settled ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = state.report.relative_residual;
  result.iterations = state.report.rounds;
  return result;
}

const LiveState& LiveBody::untouched() const { return impl_->parts->untouched; }
const geometry::Surface& LiveBody::surface() const { return impl_->parts->surface; }
const StaticModel& LiveBody::model() const { return impl_->parts->model; }

VectorXd LiveParts::surface_of(const VectorXd& u_mm) const {
  VectorXd moved(3 * static_cast<Eigen::Index>(node_of_point.size()));
  for (std::size_t p = 0; p < node_of_point.size(); ++p) {
    moved.segment<3>(3 * static_cast<Eigen::Index>(p)) = u_mm.segment<3>(3 * node_of_point[p]);
  }
  return moved;
}

Eigen::MatrixXd LiveParts::unit_forces_at_judged() const {
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(unknowns(), 3 * static_cast<Eigen::Index>(judged));
  for (std::size_t w = 0; w < judged; ++w) {
    const auto& nodes = body.layout.cells[static_cast<std::size_t>(watched[w].cell)];
    const TetValues values = tet_values(body.options.order, watched[w].barycentric);
    for (int i = 0; i < body.layout.nodes_per_cell(); ++i) {
      for (int d = 0; d < 3; ++d) unit(3 * nodes[i] + d, 3 * static_cast<Eigen::Index>(w) + d) += values[i];
    }
  }
  return unit;
}

void LiveParts::show(LiveState& state) const {
  for (const int node : node_of_point) state.surface_mm.push_back(state.u_mm.segment<3>(3 * node));
  for (const PointInMesh& place : watched) {
    const auto& nodes = body.layout.cells[static_cast<std::size_t>(place.cell)];
    const TetValues values = tet_values(body.options.order, place.barycentric);
    Vector3d moved_mm = Vector3d::Zero();
    for (int i = 0; i < body.layout.nodes_per_cell(); ++i) moved_mm += values[i] * state.u_mm.segment<3>(3 * nodes[i]);
    state.watched_mm.push_back(moved_mm);
  }
}

}  // namespace glisson::mechanics
