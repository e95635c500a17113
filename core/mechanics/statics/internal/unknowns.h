#pragma once
// What is solved for, and how the nodes of a body follow it: the nodes themselves, or the handles of a meshfree basis
// (reduced_potential.h). Equilibria, contact and steps in time are written once over it.

#include "mechanics/potentials/total_potential.h"
#include "mechanics/solvers/internal/newton.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {

class Unknowns {
 public:
  virtual ~Unknowns() = default;
  [[nodiscard]] virtual Eigen::VectorXd at_rest() const = 0;
  // Of the nodes, 3 each.
  [[nodiscard]] virtual Eigen::VectorXd displacement_mm(const Eigen::VectorXd& x_mm) const = 0;
  // How large forces on the nodes are to the unknowns: without what acts on fixed ones.
  [[nodiscard]] virtual double size_mN(const Eigen::VectorXd& force_mN) const = 0;
  // The potential energy's minimum over the unknowns; the result's `u_mm` are unknowns. Failures: those of `minimise`.
  [[nodiscard]] virtual Result<NewtonResult> minimum_of(const TotalPotential& potential, double scale_mN,
                                                        const Eigen::VectorXd& start_mm, const MinimiseOptions& options,
                                                        const Progress& progress) const = 0;
};

// The nodes of a body, which must outlive it.
class NodalUnknowns : public Unknowns {
 public:
  explicit NodalUnknowns(const Body& body) : body_(body) {}

  [[nodiscard]] Eigen::VectorXd at_rest() const override {
    return Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body_.layout.nodes()));
  }
  [[nodiscard]] Eigen::VectorXd displacement_mm(const Eigen::VectorXd& x_mm) const override { return x_mm; }
  [[nodiscard]] double size_mN(const Eigen::VectorXd& force_mN) const override {
    return free_values(body_.resolved.fixed, force_mN).norm();
  }
  [[nodiscard]] Result<NewtonResult> minimum_of(const TotalPotential& potential, double scale_mN,
                                                const Eigen::VectorXd& start_mm, const MinimiseOptions& options,
                                                const Progress& progress) const override {
    return minimise(potential, body_.resolved.fixed, scale_mN, start_mm, options, progress);
  }

 private:
  const Body& body_;
};

// The equilibrium under as much of the loads as there is one for: all at once, or in smaller parts where that does not
// converge. Failures: those of `minimise`.
struct CarriedLoad {
  Eigen::VectorXd x_mm;
  double share = 0;  // 1: all of it
  double relative_residual = 0;
  int steps = 0;          // Newton's
  bool hopeless = false;  // by small strain the body would move a thousand times its size
};
Result<CarriedLoad> carry_load(const Unknowns& unknowns, const Body& body, const std::vector<Material>& materials,
                               const AppliedLoads& loads, const NewtonOptions& options, const Progress& progress);
[[nodiscard]] AppliedLoads share_of(const AppliedLoads& loads, double share);

}  // namespace glisson::mechanics
