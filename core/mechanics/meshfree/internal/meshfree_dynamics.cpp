#include "mechanics/meshfree/internal/meshfree_dynamics.h"

#include <Eigen/LU>

#include "base/stopwatch.h"
#include "mechanics/contact/internal/augmented_lagrangian.h"
#include "mechanics/dynamics/internal/implicit_step.h"
#include "mechanics/elements/internal/mass_matrix.h"
#include "mechanics/elements/strain.h"
#include "mechanics/meshfree/internal/reduced_potential.h"
#include "mechanics/meshfree/internal/reduced_solver.h"

namespace glisson::mechanics {

namespace {

std::optional<StressHistory> history_of(const MeshfreeBody& of_step, const DynamicsOptions& options) {
  if (options.relaxation.empty()) return {};
  std::vector<Material> at_once;
  const double share = share_within(options.relaxation, options.step_s);
  for (const Material& material : of_step.materials) at_once.push_back(scaled(material, 1 / share));
  return StressHistory(of_step.body, std::move(at_once), options.relaxation, options.step_s);
}

}  // namespace

struct MeshfreeImplicitEuler::Impl {
  MeshfreeBody handles;
  DynamicsOptions options;
  ReducedOperator mass;       // kg
  ReducedOperator stiffness;  // of the present shape, supports included (mN/mm)
  ReducedOperator system;     // A
  ReducedPreconditioner preconditioner;
  Eigen::VectorXd q_mm, v_mm_s, last_dv_mm_s;
  std::optional<StressHistory> history;  // where the body relaxes

  Impl(MeshfreeBody given, const DynamicsOptions& given_options)
      : handles(std::move(given)),
        options(given_options),
        mass(handles.over_handles(consistent_mass_kg(handles.body))),
        stiffness(handles.rest_stiffness),
        system(system_of(stiffness)),
        preconditioner(ReducedPreconditioner::of(system, handles.body.options.memory_limit_bytes)),
        q_mm(Eigen::VectorXd::Zero(handles.basis->unknowns())),
        v_mm_s(q_mm),
        last_dv_mm_s(q_mm),
        history(history_of(handles, options)) {}

  [[nodiscard]] ReducedOperator system_of(const ReducedOperator& k) const {
    const double h = options.step_s;
    return ReducedOperator::sum(1.0 + h * options.mass_damping_per_s, mass, h * (h + options.stiffness_damping_s), k);
  }
  [[nodiscard]] bool is_linear() const {
    return handles.law == MaterialLaw::linear && handles.body.resolved.ligaments.empty();
  }

  // What all but the dead loads pushes with at q, over handles.
  [[nodiscard]] Eigen::VectorXd force_mN(double follower_pressure_kPa) const {
    if (is_linear()) return -(stiffness * q_mm);
    const Eigen::VectorXd u_mm = handles.basis->displacement(q_mm);
    return handles.basis->reduce(mechanics::force_mN(boundary_potentials(handles.body, follower_pressure_kPa), u_mm) +
                                 handles.penalty_force_mN(u_mm) -
                                 internal_force_mN(handles.body, handles.materials, u_mm));
  }

  [[nodiscard]] ReducedSolution solve(const Eigen::VectorXd& b);
  // With what the shape and its motion are after the step.
  [[nodiscard]] StepReport described(StepReport report, const Stopwatch& watch) const;
};

namespace {

constexpr int newton_steps_of_a_frame = 40;

int cells_turned_inside_out(const Body& body, const Eigen::VectorXd& u_mm);

}  // namespace

Result<MeshfreeImplicitEuler> MeshfreeImplicitEuler::create(MeshfreeBody handles, const DynamicsOptions& options) {
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  return MeshfreeImplicitEuler(std::make_unique<Impl>(std::move(handles), options));
}

StepReport MeshfreeImplicitEuler::step(const AppliedLoads& loads) {
  const Stopwatch watch;
  Impl& parts = *impl_;
  const DynamicsOptions& options = parts.options;
  const double h = options.step_s;
  if (!parts.is_linear()) {
    parts.stiffness = parts.handles.tangent(parts.handles.basis->displacement(parts.q_mm), Tangent::warped,
                                            loads.follower_pressure_kPa);
    parts.system = parts.system_of(parts.stiffness);
  }
  const Eigen::VectorXd dead_mN =
      parts.history ? (loads.dead_mN + parts.history->force_mN(parts.handles.body)).eval() : loads.dead_mN;
  const Eigen::VectorXd b = h * (parts.handles.basis->reduce(dead_mN) + parts.force_mN(loads.follower_pressure_kPa) -
                                 (h + options.stiffness_damping_s) * (parts.stiffness * parts.v_mm_s) -
                                 options.mass_damping_per_s * (parts.mass * parts.v_mm_s));
  const ReducedSolution solution = parts.solve(b);

  StepReport report;
  report.iterations = solution.iterations;
  report.relative_residual = solution.relative_residual;
  report.converged = solution.converged;
  if (report.converged) {
    parts.last_dv_mm_s = solution.x;
    parts.v_mm_s += solution.x;
    parts.q_mm += h * parts.v_mm_s;
    if (parts.history) parts.history->advance(parts.handles.body, displacement_mm());
  }
  return parts.described(report, watch);
}

Result<StepReport> MeshfreeImplicitEuler::step(const AppliedLoads& loads, const MinimiseWithTools& minimise_with_tools,
                                               const Progress& progress) {
  const Stopwatch watch;
  Impl& parts = *impl_;
  const Body& body = parts.handles.body;
  const Eigen::SparseMatrix<double> mass_kg = consistent_mass_kg(body);
  const ImplicitStep step(body, parts.handles.materials, loads, parts.options, mass_kg, displacement_mm(),
                          velocity_mm_s(), parts.history ? parts.history->potentials(body) : Potentials());
  Minimum minimum{parts.q_mm};
  const Result<bool> rested =
      minimise_with_tools({step.potential(),
                           step.scale_mN(),
                           HandleUnknowns(parts.handles),
                           minimum,
                           {parts.options.relative_tolerance, newton_steps_of_a_frame, body.options.memory_limit_bytes},
                           progress});
  if (!rested) return failure(rested.error());
  StepReport report;
  report.iterations = minimum.newton_steps;
  report.relative_residual = minimum.relative_residual;
  report.converged = *rested && minimum.x_mm.allFinite();
  if (report.converged) {
    parts.v_mm_s = (minimum.x_mm - parts.q_mm) / parts.options.step_s;
    parts.q_mm = std::move(minimum.x_mm);
    if (parts.history) parts.history->advance(body, displacement_mm());
  }
  return parts.described(report, watch);
}

StepReport MeshfreeImplicitEuler::Impl::described(StepReport report, const Stopwatch& watch) const {
  const Eigen::VectorXd u_mm = handles.basis->displacement(q_mm);
  report.inverted_cells = cells_turned_inside_out(handles.body, u_mm);
  report.strain_energy_uJ =
      history ? history->free_energy_uJ(handles.body) : strain_energy_uJ(handles.body, handles.materials, u_mm);
  report.kinetic_energy_uJ = 0.5 * v_mm_s.dot(mass * v_mm_s);
  report.step_ms = 1e3 * watch.seconds();
  return report;
}

// With the factor there is; where that has aged, with a fresh one.
ReducedSolution MeshfreeImplicitEuler::Impl::solve(const Eigen::VectorXd& b) {
  const auto attempt = [&](int maximum) {
    return conjugate_gradients(system, preconditioner, b, last_dv_mm_s, options.relative_tolerance, maximum);
  };
  ReducedSolution solution =
      attempt(is_linear() ? options.max_iterations : std::min(preconditioner.patience(), options.max_iterations));
  if (solution.converged || is_linear()) return solution;
  const int spent = solution.iterations;
  preconditioner = ReducedPreconditioner::of(system, handles.body.options.memory_limit_bytes);
  solution = attempt(options.max_iterations);
  solution.iterations += spent;
  return solution;
}

MeshfreeImplicitEuler::MeshfreeImplicitEuler(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
MeshfreeImplicitEuler::MeshfreeImplicitEuler(MeshfreeImplicitEuler&&) noexcept = default;
MeshfreeImplicitEuler& MeshfreeImplicitEuler::operator=(MeshfreeImplicitEuler&&) noexcept = default;
MeshfreeImplicitEuler::~MeshfreeImplicitEuler() = default;

Eigen::VectorXd MeshfreeImplicitEuler::displacement_mm() const {
  return impl_->handles.basis->displacement(impl_->q_mm);
}
Eigen::VectorXd MeshfreeImplicitEuler::velocity_mm_s() const {
  return impl_->handles.basis->displacement(impl_->v_mm_s);
}
const Body& MeshfreeImplicitEuler::body() const { return impl_->handles.body; }
const StressHistory* MeshfreeImplicitEuler::history() const { return impl_->history ? &*impl_->history : nullptr; }

void MeshfreeImplicitEuler::set_rigid_velocity(const Eigen::Vector3d& velocity_mm_s,
                                               const Eigen::Vector3d& spin_per_s) {
  const auto field = [&](const Eigen::Vector3d& place_mm) {
    return (velocity_mm_s + spin_per_s.cross(place_mm)).eval();
  };
  impl_->v_mm_s = affine_handles(impl_->handles.shape, field);
}

Eigen::Vector3d MeshfreeImplicitEuler::fixed_reaction_mN() const {
  return sum_of(impl_->handles.penalty_force_mN(displacement_mm()));
}

Eigen::Vector3d MeshfreeImplicitEuler::momentum_kg_mm_s() const {
  const Eigen::VectorXd momenta = impl_->mass * impl_->v_mm_s;
  // A uniform unit velocity is 1 in every handle's translation.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index handle = 0; handle < momenta.size() / handle_size; ++handle) {
    sum += momenta.segment<3>(handle_size * handle);
  }
  return sum;
}

namespace {

int cells_turned_inside_out(const Body& body, const Eigen::VectorXd& u_mm) {
  int cells = 0;
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c) {
    const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() +
                              displacement_gradient(body.mesh, body.layout, c, Eigen::Vector4d::Constant(0.25), u_mm);
    cells += f.determinant() <= 0 ? 1 : 0;
  }
  return cells;
}

}  // namespace
}  // namespace glisson::mechanics
