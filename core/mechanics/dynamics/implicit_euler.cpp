#include "mechanics/dynamics/implicit_euler.h"

#include <cmath>

#include "base/stopwatch.h"
#include "mechanics/dynamics/internal/corotational_elements.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/solvers/internal/device_gradients.h"

namespace glisson::mechanics {

struct ImplicitEuler::Impl {
  Body body;
  DynamicsOptions options;
  CorotationalElements cells;            // of a step's stiffness
  std::optional<StressHistory> history;  // where the body relaxes
  Eigen::VectorXd mass_kg;               // 3 a node, as are all below, in the order of `cells`
  std::vector<float> mask;               // 1 free, 0 held
  Eigen::VectorXd free;                  // the same
  BlockCsr constant;                     // what of A does not turn: mass and foundations
  BlockCsr matrix;                       // A
  LatticePreconditioner preconditioner;
  std::optional<DeviceGradients> device;  // in place of the preconditioner
  GradientBuffers buffers;
  Eigen::VectorXd u_mm, v_mm_s, last_dv_mm_s;
  CorotationalElements::Turned turned;
  bool lattice_is_due = true;
  int iterations_when_fresh = 0;  // of the first step after the lattice was refreshed
  int iterations_lost = 0;        // beyond that, since then

  Impl(Body given, MaterialLaw law, const DynamicsOptions& given_options);

  [[nodiscard]] double mass_factor() const { return 1.0 + options.step_s * options.mass_damping_per_s; }
  [[nodiscard]] double stiffness_factor() const {
    return options.step_s * (options.step_s + options.stiffness_damping_s);
  }
  void assemble();
  int solve(double target_norm, int max_iterations);
  [[nodiscard]] Eigen::VectorXd right_hand_side(const Eigen::VectorXd& force_mN) const;
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& b, const Eigen::VectorXd& dv) const;
  void add_foundation_force(double factor, const Eigen::VectorXd& w, Eigen::VectorXd& force) const;
  [[nodiscard]] Eigen::VectorXd to_inside(const Eigen::VectorXd& layout_values) const;
  [[nodiscard]] Eigen::VectorXd to_layout(const Eigen::VectorXd& inside_values) const;
};

namespace {

Result<void> check(const Body& body, MaterialLaw law);
std::vector<float> mask_of(const Body& body, const CorotationalElements& cells);
Eigen::VectorXd masses_of(const Body& body, const CorotationalElements& cells);
double lattice_spacing_mm(const Body& body);
std::optional<StressHistory> history_of(const Body& body, MaterialLaw law, const DynamicsOptions& options);

}  // namespace

Result<ImplicitEuler> ImplicitEuler::create(Body body, MaterialLaw law, const DynamicsOptions& options) {
  if (auto checked = check(body, law); !checked) return failure(std::move(checked.error()));
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  auto parts = std::make_unique<Impl>(std::move(body), law, options);
  if (options.device) {
    auto device = DeviceGradients::open(parts->matrix, parts->mask, *options.device);
    if (!device) return failure(std::move(device.error()));
    parts->device = std::move(*device);
  }
  return ImplicitEuler(std::move(parts));
}

Result<void> check_dynamics_options(const DynamicsOptions& options) {
  const auto at_least_zero = [](double value) { return std::isfinite(value) && value >= 0; };
  if (auto checked = check_relaxation(options.relaxation); !checked) return checked;
  if (std::isfinite(options.step_s) && options.step_s > 0 && at_least_zero(options.mass_damping_per_s) &&
      at_least_zero(options.stiffness_damping_s) && options.relative_tolerance > 0 && options.max_iterations >= 1) {
    return {};
  }
  return failure("step-invalid",
                 GLISSON_TEXT("A motion needs a step and a tolerance above zero, and damping not below it."));
}

ImplicitEuler::Impl::Impl(Body given, MaterialLaw law, const DynamicsOptions& given_options)
    : body(std::move(given)),
      options(given_options),
      cells(
          body,
          law == MaterialLaw::linear ? CorotationalElements::Turning::never : CorotationalElements::Turning::each_step,
          share_within(options.relaxation, options.step_s)),
      history(history_of(body, law, options)),
      mass_kg(masses_of(body, cells)),
      mask(mask_of(body, cells)),
      free(Eigen::Map<const Eigen::VectorXf>(mask.data(), mass_kg.size()).cast<double>()),
      constant(cells.neighbours()),
      matrix(constant),
      preconditioner(cells.rest_positions_mm(), mask, lattice_spacing_mm(body)),
      buffers(static_cast<std::size_t>(cells.nodes())),
      u_mm(Eigen::VectorXd::Zero(mass_kg.size())),
      v_mm_s(u_mm),
      last_dv_mm_s(u_mm) {
  const auto add = [&](int row, int column, double value) {
    float* block = constant.block(constant.position(row, column));
    for (int d = 0; d < 3; ++d) block[4 * d] += static_cast<float>(value);
  };
  for (int n = 0; n < cells.nodes(); ++n) add(n, n, mass_factor() * mass_kg[3 * n]);
  for (const FoundationFace& spring : body.resolved.foundations) {
    const BoundaryFace& face = body.boundary[spring.face];
    const FaceMass mass = face_mass_mm2(face, ElementOrder::linear);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        add(cells.node_of_layout()[face.nodes[a]], cells.node_of_layout()[face.nodes[b]],
            stiffness_factor() * spring.stiffness_kPa_per_mm * mass(a, b));
      }
    }
  }
}

StepReport ImplicitEuler::step(const Eigen::VectorXd& force_mN) {
  const Stopwatch watch;
  Impl& parts = *impl_;
  const DynamicsOptions& options = parts.options;
  const Eigen::VectorXd b = parts.right_hand_side(
      parts.to_inside(parts.history ? (force_mN + parts.history->force_mN(parts.body)).eval() : force_mN));
  const double scale = b.norm();
  StepReport report;
  Eigen::VectorXd dv = parts.last_dv_mm_s;
  Eigen::VectorXd residual = parts.residual(b, dv);
  if (!(residual.norm() < scale)) {
    dv.setZero();
    residual = b;
  }
  const auto relative = [&] { return scale > 0 ? residual.norm() / scale : 0.0; };
  report.relative_residual = relative();
  if (report.relative_residual > options.relative_tolerance) parts.assemble();
  // What single precision calls solved may not quite be; then the rest is solved for once more.
  while (report.relative_residual > options.relative_tolerance && report.iterations < options.max_iterations) {
    const auto values = static_cast<Eigen::Index>(parts.mask.size()) - 1;
    Eigen::Map<Eigen::VectorXf>(parts.buffers.residual.data(), values) = residual.cast<float>();
    report.iterations +=
        parts.solve(0.8 * options.relative_tolerance * scale, options.max_iterations - report.iterations);
    dv += Eigen::Map<const Eigen::VectorXf>(parts.buffers.solution.data(), values).cast<double>();
    residual = parts.residual(b, dv);
    if (!(relative() < 0.9 * report.relative_residual)) {
      report.relative_residual = relative();
      break;
    }
    report.relative_residual = relative();
  }
  if (report.iterations > 0) {
    // Refreshing the lattice costs about as much as a hundred iterations: it waits until its age has cost that.
    if (parts.lattice_is_due) {
      parts.iterations_when_fresh = report.iterations;
      parts.iterations_lost = 0;
    }
    parts.iterations_lost += std::max(0, report.iterations - parts.iterations_when_fresh);
    parts.lattice_is_due = parts.iterations_lost > 100;
  }

  report.converged = report.relative_residual <= options.relative_tolerance && dv.allFinite();
  if (report.converged) {
    parts.v_mm_s += dv;
    parts.u_mm += options.step_s * parts.v_mm_s;
    parts.last_dv_mm_s = dv;
    parts.turned = parts.cells.turn(parts.u_mm);
    if (parts.history) parts.history->advance(parts.body, parts.to_layout(parts.u_mm));
  }
  report.inverted_cells = parts.turned.inverted_cells;
  report.strain_energy_uJ = parts.history ? parts.history->free_energy_uJ(parts.body) : parts.turned.strain_energy_uJ;
  report.kinetic_energy_uJ = 0.5 * parts.v_mm_s.cwiseAbs2().dot(parts.mass_kg);
  report.step_ms = 1e3 * watch.seconds();
  return report;
}

void ImplicitEuler::Impl::assemble() {
  matrix.values() = constant.values();
  cells.add_stiffness(stiffness_factor(), matrix);
  if (device) return;  // which has a preconditioner of its own
  preconditioner.refresh_diagonal(matrix);
  if (lattice_is_due) preconditioner.refresh_lattices(matrix);
}

int ImplicitEuler::Impl::solve(double target_norm, int max_iterations) {
  if (device) {
    if (const auto solved = device->solve(matrix, target_norm, max_iterations, buffers)) return *solved;
    device.reset();
    preconditioner.refresh_diagonal(matrix);
    preconditioner.refresh_lattices(matrix);
  }
  return conjugate_gradients(matrix, mask, preconditioner, target_norm, max_iterations, buffers);
}

// h (f + h K v), with the damping's force in f: everything elastic is one pass over the cells at u + (h + beta) v.
Eigen::VectorXd ImplicitEuler::Impl::right_hand_side(const Eigen::VectorXd& force_mN) const {
  const double h = options.step_s;
  const Eigen::VectorXd ahead_mm = u_mm + (h + options.stiffness_damping_s) * v_mm_s;
  Eigen::VectorXd resisting_mN = Eigen::VectorXd::Zero(u_mm.size());
  cells.add_force_mN(ahead_mm, resisting_mN);
  add_foundation_force(1.0, ahead_mm, resisting_mN);
  resisting_mN += options.mass_damping_per_s * mass_kg.cwiseProduct(v_mm_s);
  return h * free.cwiseProduct(force_mN - resisting_mN);
}

Eigen::VectorXd ImplicitEuler::Impl::residual(const Eigen::VectorXd& b, const Eigen::VectorXd& dv) const {
  Eigen::VectorXd product = mass_factor() * mass_kg.cwiseProduct(dv);
  cells.add_stiffness_times(stiffness_factor(), dv, product);
  add_foundation_force(stiffness_factor(), dv, product);
  return free.cwiseProduct(b - product);
}

void ImplicitEuler::Impl::add_foundation_force(double factor, const Eigen::VectorXd& w, Eigen::VectorXd& force) const {
  for (const FoundationFace& spring : body.resolved.foundations) {
    const BoundaryFace& face = body.boundary[spring.face];
    const FaceMass mass = face_mass_mm2(face, ElementOrder::linear);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        force.segment<3>(3 * cells.node_of_layout()[face.nodes[a]]) +=
            factor * spring.stiffness_kPa_per_mm * mass(a, b) * w.segment<3>(3 * cells.node_of_layout()[face.nodes[b]]);
      }
    }
  }
}

Eigen::VectorXd ImplicitEuler::Impl::to_inside(const Eigen::VectorXd& layout_values) const {
  GLISSON_ASSERT(layout_values.size() == u_mm.size());
  Eigen::VectorXd values(layout_values.size());
  for (int n = 0; n < cells.nodes(); ++n) {
    values.segment<3>(3 * cells.node_of_layout()[n]) = layout_values.segment<3>(3 * n);
  }
  return values;
}

Eigen::VectorXd ImplicitEuler::Impl::to_layout(const Eigen::VectorXd& inside_values) const {
  Eigen::VectorXd values(inside_values.size());
  for (int n = 0; n < cells.nodes(); ++n) {
    values.segment<3>(3 * n) = inside_values.segment<3>(3 * cells.node_of_layout()[n]);
  }
  return values;
}

ImplicitEuler::ImplicitEuler(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
ImplicitEuler::ImplicitEuler(ImplicitEuler&&) noexcept = default;
ImplicitEuler& ImplicitEuler::operator=(ImplicitEuler&&) noexcept = default;
ImplicitEuler::~ImplicitEuler() = default;

Result<Eigen::VectorXd> ImplicitEuler::force_of(const Loads& loads) const {
  const Body& body = impl_->body;
  return load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, loads);
}

Eigen::VectorXd ImplicitEuler::displacement_mm() const { return impl_->to_layout(impl_->u_mm); }
Eigen::VectorXd ImplicitEuler::velocity_mm_s() const { return impl_->to_layout(impl_->v_mm_s); }
const Body& ImplicitEuler::body() const { return impl_->body; }
const StressHistory* ImplicitEuler::history() const { return impl_->history ? &*impl_->history : nullptr; }

void ImplicitEuler::set_state(const Eigen::VectorXd& displacement_mm, const Eigen::VectorXd& velocity_mm_s) {
  impl_->u_mm = impl_->to_inside(displacement_mm);
  impl_->v_mm_s = impl_->free.cwiseProduct(impl_->to_inside(velocity_mm_s));
  impl_->last_dv_mm_s.setZero();
  impl_->turned = impl_->cells.turn(impl_->u_mm);
  if (impl_->history) impl_->history->jump(impl_->body, displacement_mm);
}

Eigen::VectorXd ImplicitEuler::mass_kg() const {
  const Eigen::VectorXd all = impl_->to_layout(impl_->mass_kg);
  return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<3>>(all.data(), all.size() / 3);
}

ImplicitEuler::Cost ImplicitEuler::cost() const {
  return {impl_->matrix.columns().items.size(), impl_->matrix.bytes_of_a_product(),
          impl_->preconditioner.lattice_points(), impl_->device ? impl_->device->device_name() : std::string()};
}

namespace {

Result<void> check(const Body& body, MaterialLaw law) {
  if ((law == MaterialLaw::linear || law == MaterialLaw::corotational) && body.resolved.ligaments.empty() &&
      !body.options.capsule) {
    return {};
  }
  return failure("not-available",
                 GLISSON_TEXT("One linear solve a step moves the materials \"linear\" and \"corotational\", without "
                              "ligaments or a capsule."));
}

std::optional<StressHistory> history_of(const Body& body, MaterialLaw law, const DynamicsOptions& options) {
  if (options.relaxation.empty()) return {};
  return StressHistory(body, materials_of(body, law), options.relaxation, options.step_s);
}

// One value more than the nodes have: see BlockCsr::multiply.
std::vector<float> mask_of(const Body& body, const CorotationalElements& cells) {
  std::vector<float> mask(3 * static_cast<std::size_t>(cells.nodes()) + 1, 0.0F);
  for (int n = 0; n < cells.nodes(); ++n) {
    for (int d = 0; d < 3; ++d) {
      mask[3 * static_cast<std::size_t>(cells.node_of_layout()[n]) + d] =
          body.resolved.fixed[3 * static_cast<std::size_t>(n) + d] ? 0.0F : 1.0F;
    }
  }
  return mask;
}

Eigen::VectorXd masses_of(const Body& body, const CorotationalElements& cells) {
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(cells.nodes()));
  for (std::size_t c = 0; c < body.layout.cells.size(); ++c) {
    const double quarter_kg = 0.25 * body.options.density_kg_mm3 * geometry::cell_volume_mm3(body.mesh, c);
    for (int i = 0; i < 4; ++i) {
      masses.segment<3>(3 * cells.node_of_layout()[body.layout.cells[c][i]]).array() += quarter_kg;
    }
  }
  return masses;
}

// Wide enough that a lattice has few points, narrow enough that the blocks of the diagonal see across its cells.
double lattice_spacing_mm(const Body& body) {
  double sum_mm = 0, longest_mm = 0;
  for (const auto& cell : body.mesh.cells) {
    for (const auto& [i, j] : edges_of_cell) {
      const double length_mm = (body.mesh.points_mm[cell[i]] - body.mesh.points_mm[cell[j]]).norm();
      sum_mm += length_mm;
      longest_mm = std::max(longest_mm, length_mm);
    }
  }
  const double mean_mm = sum_mm / (6.0 * static_cast<double>(body.mesh.cells.size()));
  return std::max(4.5 * mean_mm, 1.01 * longest_mm);
}

}  // namespace
}  // namespace glisson::mechanics
