#pragma once
// One term of a body's potential energy: its material, a support, a load, inertia, a contact. `u_mm` is the
// displacement of the body's nodes, 3 values a node in the order of NodeLayout. Forces are in mN, 3 a node, energies in
// uJ. A new support or contact is one class of these; tests/mechanics/potentials_test.cpp judges it by differences.

#include <memory>
#include <vector>

#include "mechanics/potentials/tangent_sum.h"
#include "mechanics/solvers/objective.h"

namespace glisson::mechanics {

class Potential {
 public:
  virtual ~Potential() = default;
  [[nodiscard]] virtual double energy_uJ(const Eigen::VectorXd& u_mm) const = 0;
  // Adds minus the slope of the energy.
  virtual void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const = 0;
  // Adds the slope of minus the force, or of what `which` leaves of it.
  virtual void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const = 0;
  // The size of what the energy is the difference of, where that is larger than the energy.
  [[nodiscard]] virtual double scale_uJ(const Eigen::VectorXd& /*u_mm*/) const { return 0; }
};

using Potentials = std::vector<std::shared_ptr<const Potential>>;

// What all of them push with, 3 a node.
[[nodiscard]] Eigen::VectorXd force_mN(const Potentials& terms, const Eigen::VectorXd& u_mm);
[[nodiscard]] double energy_uJ(const Potentials& terms, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
