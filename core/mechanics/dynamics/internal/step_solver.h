#pragma once
// A step in time as its factor answers: what bodies in motion have in place of a body's stiffness at rest. And how what
// moves comes to rest.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "mechanics/dynamics/moving_body.h"
#include "mechanics/solvers/constrained_system.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

// Answers to forces within a step, by its factor.
class StepSolver : public DisplacementSolver {
 public:
  explicit StepSolver(ConstrainedSystem system) : system_(std::move(system)) {}

  [[nodiscard]] Solution solve(const Eigen::MatrixXd& force_mN) const override {
    auto response = system_.respond(force_mN, Digits::seen);
    return {std::move(response.u), Eigen::MatrixXd::Zero(force_mN.rows(), force_mN.cols()), response.relative_residual};
  }
  [[nodiscard]] Result<StaticModel> with_moduli(std::vector<double> /*youngs_kPa*/, const StaticOptions& /*options*/,
                                                const Progress& /*progress*/) const override {
    return failure("not-available", GLISSON_TEXT("A body in motion keeps its moduli."));
  }
  [[nodiscard]] StaticModel::Cost cost() const override {
    return {0, system_.free_unknowns(), system_.matrix_bytes(), system_.factor() ? system_.factor()->bytes() : 0};
  }

 private:
  ConstrainedSystem system_;
};

// After a step of that many seconds that changed the displacements of nodes so (mm, 3 a node). What moves dies out
// within `longest_s`.
[[nodiscard]] Movement moved_on(const Movement& before, const Eigen::VectorXd& change_mm, double step_s,
                                double longest_s);

}  // namespace glisson::mechanics
