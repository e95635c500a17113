#pragma once
// Springs under faces of the boundary (Winkler's foundation): k |u|^2 / 2 over their area.

#include "mechanics/elements/body.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class FoundationPotential : public Potential {
 public:
  // Of the body's resolved foundations; the body must outlive it.
  explicit FoundationPotential(const Body& body) : body_(body) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override {
    return -0.5 * u_mm.dot(foundation_force_mN(body_, u_mm));
  }
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override {
    force_mN += foundation_force_mN(body_, u_mm);
  }
  void add_tangent(const Eigen::VectorXd& /*u_mm*/, Tangent /*which*/, TangentSum& sum) const override {
    for (const FoundationFace& spring : body_.resolved.foundations) {
      add_foundation(body_.boundary[spring.face], spring, body_.options.order, sum.within_cells());
    }
  }

 private:
  const Body& body_;
};

}  // namespace glisson::mechanics
