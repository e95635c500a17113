#include "mechanics/dynamics/internal/incremental_potential.h"

#include <cmath>

#include "mechanics/elements/boundary_potential.h"

namespace glisson::mechanics {
namespace {

using Eigen::SparseMatrix;
using Eigen::VectorXd;

VectorXd times(const SparseMatrix<double>& lower, const VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

}  // namespace

IncrementalPotential::IncrementalPotential(const Body& body, const std::vector<Material>& materials,
                                           const AppliedLoads& loads, const DynamicsOptions& options,
                                           const SparseMatrix<double>& mass_kg, const VectorXd& u_mm,
                                           const VectorXd& v_mm_s)
    : body_(body),
      materials_(materials),
      loads_(loads),
      mass_kg_(mass_kg),
      from_mm_(u_mm),
      coasted_mm_(u_mm + options.step_s * v_mm_s),
      inertia_(1.0 / (options.step_s * options.step_s)),
      drag_(options.mass_damping_per_s / options.step_s),
      creep_(options.stiffness_damping_s / options.step_s) {
  if (creep_ > 0) stiffness_ = tangent_stiffness(body, materials, u_mm, Tangent::positive);
}

double IncrementalPotential::energy_uJ(const VectorXd& u_mm) const {
  const VectorXd moved = u_mm - from_mm_, strayed = u_mm - coasted_mm_;
  double energy = strain_energy_uJ(body_, materials_, u_mm) +
                  boundary_energy_uJ(body_, loads_.follower_pressure_kPa, u_mm) - loads_.dead_mN.dot(u_mm) +
                  0.5 * inertia_ * strayed.dot(times(mass_kg_, strayed)) +
                  0.5 * drag_ * moved.dot(times(mass_kg_, moved));
  if (creep_ > 0) energy += 0.5 * creep_ * moved.dot(times(stiffness_, moved));
  return energy;
}

VectorXd IncrementalPotential::force_mN(const VectorXd& u_mm) const {
  const VectorXd moved = u_mm - from_mm_;
  VectorXd force = loads_.dead_mN + boundary_force_mN(body_, loads_.follower_pressure_kPa, u_mm) -
                   internal_force_mN(body_, materials_, u_mm) -
                   times(mass_kg_, inertia_ * (u_mm - coasted_mm_) + drag_ * moved);
  if (creep_ > 0) force -= creep_ * times(stiffness_, moved);
  return force;
}

SparseMatrix<double> IncrementalPotential::tangent(const VectorXd& u_mm, Tangent which) const {
  SparseMatrix<double> sum = tangent_stiffness(body_, materials_, u_mm, which, loads_.follower_pressure_kPa);
  sum += (inertia_ + drag_) * mass_kg_;
  if (creep_ > 0) sum += creep_ * stiffness_;
  return sum;
}

double IncrementalPotential::energy_scale_uJ(const VectorXd& u_mm) const {
  const VectorXd strayed = u_mm - coasted_mm_;
  return std::abs(loads_.dead_mN.dot(u_mm)) +
         std::abs(loads_.follower_pressure_kPa) * geometry::volume_mm3(body_.mesh) +
         0.5 * inertia_ * strayed.dot(times(mass_kg_, strayed));
}

double IncrementalPotential::scale_mN() const {
  const auto size = [&](const VectorXd& force) { return free_values(body_.resolved.fixed, force).norm(); };
  return size(loads_.dead_mN + boundary_force_mN(body_, loads_.follower_pressure_kPa, from_mm_)) +
         size(internal_force_mN(body_, materials_, from_mm_)) +
         size(inertia_ * times(mass_kg_, coasted_mm_ - from_mm_));
}

}  // namespace glisson::mechanics
