#include "mechanics/dynamics/moving_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/dynamics/internal/step_solver.h"
#include "mechanics/elements/internal/mass_matrix.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/strain.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/solvers/constrained_system.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

using Eigen::VectorXd;
using LowerMatrix = Eigen::SparseMatrix<double>;

namespace {

VectorXd product(const LowerMatrix& lower, const VectorXd& x) { return lower.selfadjointView<Eigen::Lower>() * x; }

// The mass between nodes, of the lower triangle over their three coordinates each.
LowerMatrix mass_of_nodes(const LowerMatrix& lower_kg) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index column = 0; column < lower_kg.cols(); column += 3) {
    for (LowerMatrix::InnerIterator at(lower_kg, column); at; ++at) {
      if (at.row() % 3 == 0) entries.emplace_back(at.row() / 3, column / 3, at.value());
    }
  }
  LowerMatrix nodes_kg(lower_kg.rows() / 3, lower_kg.cols() / 3);
  nodes_kg.setFromTriplets(entries.begin(), entries.end());
  return nodes_kg;
}

}  // namespace

struct MovingBody::Impl {
  DynamicsOptions options;
  ContactBody contact;       // of a step
  LowerMatrix tissue_mN_mm;  // after long
  LowerMatrix around_mN_mm;
  LowerMatrix nodes_kg;
  VectorXd standing_mN, rest_mm;
  std::vector<RelaxationStep> relaxing;
  double long_term = 1;  // share of the moduli at once
  MovingState untouched = {};

  [[nodiscard]] VectorXd momentum(const VectorXd& v_mm_s) const;
  [[nodiscard]] VectorXd unbalanced_mN(const MovingState& state) const;
  [[nodiscard]] Result<VectorXd> change_mm(const VectorXd& force_mN, double& relative_residual) const;
  void move(const MovingState& from, const VectorXd& change_mm, MovingState& next) const;
};

Result<MovingBody> MovingBody::create(const StaticModel& at_rest, const Loads& standing_loads,
                                      std::vector<PointInMesh> watched, std::size_t judged,
                                      const DynamicsOptions& options, const Progress& progress) {
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  if (at_rest.reduced_functions() != nullptr || at_rest.nodes().order != ElementOrder::quadratic) {
    return failure("not-available", GLISSON_TEXT("A session in motion is by quadratic finite elements."));
  }
  const auto rest = at_rest.solve(standing_loads);
  if (!rest) return failure(rest.error());
  if (!rest->converged()) {
    return failure("not-converged", GLISSON_TEXT("The equilibrium was not found. {0}"), {rest->why_stopped});
  }
  Body body = at_rest.body();
  auto standing_mN = load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, standing_loads);
  if (!standing_mN) return failure(std::move(standing_mN.error()));

  Body tissue = body;
  tissue.options.capsule.reset();
  tissue.resolved.foundations.clear();
  LowerMatrix tissue_mN_mm = assemble_stiffness(tissue);
  LowerMatrix around_mN_mm = (assemble_stiffness(body) - tissue_mN_mm).pruned();
  const LowerMatrix mass_kg = consistent_mass_kg(body);
  const double h = options.step_s, long_term = long_term_share(options.relaxation);
  LowerMatrix of_step = share_within(options.relaxation, h) / long_term * tissue_mN_mm;
  of_step += around_mN_mm;
  of_step *= 1 + options.stiffness_damping_s / h;
  of_step += (1 / (h * h) + options.mass_damping_per_s / h) * mass_kg;
  auto system =
      ConstrainedSystem::create(std::move(of_step), body.resolved.fixed, body.options.memory_limit_bytes, progress);
  if (!system) return failure(std::move(system.error()));
  system->keep_factor_in_single_precision();

  body.options.relative_tolerance = 1e-3;  // of a factor in single precision, unrefined: the next step makes it good
  auto contact =
      ContactBody::create(StaticModel::solved_by(std::move(body), std::make_shared<StepSolver>(std::move(*system))), {},
                          std::move(watched), judged);
  if (!contact) return failure(std::move(contact.error()));
  auto parts = std::make_shared<Impl>(Impl{options, std::move(*contact), std::move(tissue_mN_mm),
                                           std::move(around_mN_mm), mass_of_nodes(mass_kg), std::move(*standing_mN),
                                           nodal_displacements(at_rest.nodes(), *rest), steps_of(options.relaxation, h),
                                           long_term});
  MovingState& untouched = parts->untouched;
  untouched.u_mm = parts->rest_mm;
  untouched.v_mm_s = VectorXd::Zero(untouched.u_mm.size());
  untouched.older_mm.assign(options.relaxation.size(), untouched.v_mm_s);
  untouched.report = parts->contact.untouched().report;
  parts->contact.show(untouched.u_mm, untouched);
  return MovingBody(std::move(parts));
}

Result<MovingState> MovingBody::step(const MovingState& from, const std::vector<ContactTool>& tools) const {
  const Impl& parts = *impl_;
  MovingState next;
  double relative_residual = 0;
  const VectorXd pushed_mN = parts.unbalanced_mN(from) + parts.momentum(from.v_mm_s) / parts.options.step_s;
  auto change_mm = parts.change_mm(pushed_mN, relative_residual);
  if (!change_mm) return failure(std::move(change_mm.error()));
  if (tools.empty()) {
    next.report.converged = true;
  } else {
    ContactOptions options;
    options.on_the_way = true;  // what is shown follows of all nodes
    auto touched = parts.contact.solve(from, tools, {parts.rest_mm, from.u_mm + *change_mm}, options);
    if (!touched) return failure(std::move(touched.error()));
    static_cast<ContactState&>(next) = std::move(*touched);
    next.report.energy_uJ = 0;
  }
  if (!next.force_mN.empty()) {
    VectorXd by_tools_mN = VectorXd::Zero(from.u_mm.size());
    const auto& mesh_point = geometry::find_field(surface().point_fields, "mesh_point")->values;
    const NodeLayout& layout = parts.contact.model().nodes();
    for (const auto& [point, force] : next.force_mN) {
      by_tools_mN.segment<3>(3 * layout.node_of_point[static_cast<std::size_t>(mesh_point[point])]) += force;
    }
    const auto by_tools_mm = parts.change_mm(by_tools_mN, relative_residual);
    if (!by_tools_mm) return failure(by_tools_mm.error());
    *change_mm += *by_tools_mm;
  }
  next.report.relative_residual = relative_residual;
  parts.move(from, *change_mm, next);
  return next;
}

void MovingBody::Impl::move(const MovingState& from, const VectorXd& change_mm, MovingState& next) const {
  next.u_mm = from.u_mm + change_mm;
  next.v_mm_s = change_mm / options.step_s;
  double longest_s = options.step_s;  // for which what is seen goes on
  for (std::size_t k = 0; k < relaxing.size(); ++k) {
    next.older_mm.push_back(relaxing[k].decay * from.older_mm[k] + relaxing[k].share * change_mm);
    longest_s = std::max(longest_s, options.relaxation[k].time_s / long_term);  // of creep, at most
  }
  static_cast<Movement&>(next) = moved_on(from, change_mm, options.step_s, longest_s);
  contact.show(next.u_mm, next);
}

Movement moved_on(const Movement& before, const VectorXd& change_mm, double step_s, double longest_s) {
  constexpr double nothing_to_see_mm = 0.01;
  constexpr double quiet_s = 0.5;
  constexpr int fewest_quiet_steps = 10;
  Movement now;
  now.time_s = before.time_s + step_s;
  for (Eigen::Index i = 0; i < change_mm.size(); i += 3) {
    now.largest_speed_mm_s = std::max(now.largest_speed_mm_s, change_mm.segment<3>(i).norm() / step_s);
  }
  now.quiet_steps = now.largest_speed_mm_s * longest_s <= nothing_to_see_mm ? before.quiet_steps + 1 : 0;
  now.moves = now.quiet_steps < std::max(fewest_quiet_steps, static_cast<int>(std::ceil(quiet_s / step_s)));
  return now;
}

VectorXd MovingBody::Impl::momentum(const VectorXd& v_mm_s) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const Eigen::Map<const Rows> of_nodes(v_mm_s.data(), v_mm_s.size() / 3, 3);
  const Rows of_each = nodes_kg.selfadjointView<Eigen::Lower>() * of_nodes;
  return Eigen::Map<const VectorXd>(of_each.data(), v_mm_s.size());
}

// What pushes if nothing moves within the step.
VectorXd MovingBody::Impl::unbalanced_mN(const MovingState& state) const {
  VectorXd as_after_long_mm = state.u_mm;
  for (std::size_t k = 0; k < relaxing.size(); ++k) {
    as_after_long_mm += relaxing[k].decay / long_term * state.older_mm[k];
  }
  return standing_mN - product(tissue_mN_mm, as_after_long_mm) - product(around_mN_mm, state.u_mm);
}

Result<VectorXd> MovingBody::Impl::change_mm(const VectorXd& force_mN, double& relative_residual) const {
  StaticModel::Responses answer = contact.model().respond(force_mN, Digits::seen);
  if (auto usable = answer.usable(); !usable) return failure(std::move(usable.error()));
  relative_residual = std::max(relative_residual, answer.relative_residual);
  return VectorXd(answer.displacement_mm);
}

double MovingBody::energy_uJ(const MovingState& state) const {
  const Impl& parts = *impl_;
  const VectorXd from_rest_mm = state.u_mm - parts.rest_mm;
  double twice_uJ = state.v_mm_s.dot(parts.momentum(state.v_mm_s)) +
                    from_rest_mm.dot(product(parts.tissue_mN_mm, from_rest_mm)) +
                    from_rest_mm.dot(product(parts.around_mN_mm, from_rest_mm));
  for (std::size_t k = 0; k < state.older_mm.size(); ++k) {
    twice_uJ += state.older_mm[k].dot(product(parts.tissue_mN_mm, state.older_mm[k])) /
                (parts.long_term * parts.options.relaxation[k].weight);
  }
  return 0.5 * twice_uJ;
}

StaticResult MovingBody::whole_result(const MovingState& state) const {
  const Body& body = impl_->contact.model().body();
  StaticResult result;
  set_displacements(body, state.u_mm, result);
  const StrainRange strains = strain_range(body.mesh, body.layout, state.u_mm);
  result.largest_strain = strains.largest_strain;
  result.inverted_cells = strains.inverted_cells;
  result.status = state.report.converged ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = state.report.relative_residual;
  result.iterations = state.report.rounds;
  return result;
}

Result<bool> MovingBody::prepare_touch(const ContactState& state, const std::vector<ContactTool>& tools) const {
  return impl_->contact.prepare_touch(state, tools);
}
const MovingState& MovingBody::untouched() const { return impl_->untouched; }
const geometry::Surface& MovingBody::surface() const { return impl_->contact.surface(); }

}  // namespace glisson::mechanics
