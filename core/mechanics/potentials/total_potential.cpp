#include "mechanics/potentials/total_potential.h"

#include "mechanics/potentials/capsule_potential.h"
#include "mechanics/potentials/dead_load.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/potentials/follower_pressure.h"
#include "mechanics/potentials/foundation.h"
#include "mechanics/potentials/ligament.h"

namespace glisson::mechanics {
using Eigen::VectorXd;

TotalPotential TotalPotential::with(const Potentials& more) const {
  Potentials all = terms_;
  all.insert(all.end(), more.begin(), more.end());
  return {*body_, std::move(all)};
}

double TotalPotential::energy_uJ(const VectorXd& u_mm) const { return mechanics::energy_uJ(terms_, u_mm); }

VectorXd TotalPotential::force_mN(const VectorXd& u_mm) const { return mechanics::force_mN(terms_, u_mm); }

Eigen::SparseMatrix<double> TotalPotential::tangent(const VectorXd& u_mm, Tangent which) const {
  TangentSum sum(body_->layout);
  for (const auto& term : terms_) term->add_tangent(u_mm, which, sum);
  return sum.take();
}

double TotalPotential::energy_scale_uJ(const VectorXd& u_mm) const {
  double scale_uJ = 0;
  for (const auto& term : terms_) scale_uJ += term->scale_uJ(u_mm);
  return scale_uJ;
}

Potentials boundary_potentials(const Body& body, double pressure_kPa) {
  Potentials terms;
  if (!body.resolved.foundations.empty()) terms.push_back(std::make_shared<FoundationPotential>(body));
  if (!body.resolved.ligaments.empty()) terms.push_back(std::make_shared<LigamentPotential>(body));
  if (body.options.capsule) terms.push_back(std::make_shared<CapsulePotential>(body));
  if (pressure_kPa != 0) terms.push_back(std::make_shared<FollowerPressure>(body, pressure_kPa));
  return terms;
}

Potentials boundary_and_loads(const Body& body, const AppliedLoads& loads) {
  Potentials terms = boundary_potentials(body, loads.follower_pressure_kPa);
  terms.push_back(std::make_shared<DeadLoad>(loads.dead_mN));
  return terms;
}

Potentials elastic_potentials(const Body& body, const std::vector<Material>& materials, double pressure_kPa) {
  Potentials terms = boundary_potentials(body, pressure_kPa);
  terms.push_back(std::make_shared<ElasticPotential>(body, materials));
  return terms;
}

Potentials static_potentials(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads) {
  Potentials terms = elastic_potentials(body, materials, loads.follower_pressure_kPa);
  terms.push_back(std::make_shared<DeadLoad>(loads.dead_mN));
  return terms;
}

VectorXd force_mN(const Potentials& terms, const VectorXd& u_mm) {
  VectorXd sum = VectorXd::Zero(u_mm.size());
  for (const auto& term : terms) term->add_force(u_mm, sum);
  return sum;
}

double energy_uJ(const Potentials& terms, const VectorXd& u_mm) {
  double sum = 0;
  for (const auto& term : terms) sum += term->energy_uJ(u_mm);
  return sum;
}

}  // namespace glisson::mechanics
