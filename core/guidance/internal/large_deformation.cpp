#include "guidance/internal/large_deformation.h"

#include <cstdint>
#include <utility>

#include "mechanics/potentials/elastic.h"

namespace glisson::guidance {

using Eigen::MatrixXd;
using Eigen::VectorXd;

LargeDeformation::LargeDeformation(const ForceModes& modes, mechanics::MaterialLaw law)
    : modes_(modes),
      materials_(mechanics::materials_of(modes.body(), law)),
      energy_(modes.body(), mechanics::elastic_potentials(modes.body(), materials_, 0)) {}

Result<void> LargeDeformation::turn_to(const VectorXd& u_mm) {
  const mechanics::Body& body = modes_.body();
  u_mm_ = u_mm;
  resisting_mN_ = -energy_.force_mN(u_mm);
  const auto factorised = [&](mechanics::Tangent which) {
    return mechanics::ConstrainedSystem::create(energy_.tangent(u_mm, which), body.resolved.fixed,
                                                body.options.memory_limit_bytes, {}, order_);
  };
  auto system = factorised(mechanics::Tangent::exact);
  if (!system && system.error().code == "factorisation-failed") system = factorised(mechanics::Tangent::positive);
  if (!system) return failure(std::move(system.error()));
  system_ = std::move(*system);
  order_ = system_->order();
  return {};
}

VectorXd LargeDeformation::under(const VectorXd& force_mN) const { return u_mm_ + moved_by(force_mN - resisting_mN_); }

MatrixXd LargeDeformation::moved_by(const MatrixXd& forces_mN) const { return system_->respond(forces_mN).u; }

double LargeDeformation::off_equilibrium(const VectorXd& force_mN) const {
  VectorXd off_mN = force_mN - resisting_mN_;
  const std::vector<std::uint8_t>& fixed = modes_.body().resolved.fixed;
  for (Eigen::Index i = 0; i < off_mN.size(); ++i) {
    if (fixed[static_cast<std::size_t>(i)] != 0) off_mN[i] = 0;
  }
  return force_mN.isZero(0) ? off_mN.norm() : off_mN.norm() / force_mN.norm();
}

}  // namespace glisson::guidance
