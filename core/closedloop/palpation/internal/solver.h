#pragma once
// A specimen of any structure under unit loads. It is factorised once a structure, and remembered: fits and left-out
// trials ask for the same structures again and again.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "closedloop/palpation/internal/structure.h"
#include "mechanics/solvers/constrained_system.h"

namespace glisson::closedloop {

class PalpationSolver {
 public:
  // `loads` has a column of nodal forces (mN) for each unit load. Failures: those of solving the declared structure.
  static Result<PalpationSolver> create(SpecimenBody specimen, Eigen::MatrixXd loads_mN, Interpolation markers,
                                        const Progress& progress);

  // What every unit load moves the markers by (mm): 3 rows a marker, a column a load. Failures:
  // "factorisation-failed" and "too-large" (mechanics/solvers/cholesky_factor.h), "solve-inexact".
  [[nodiscard]] Result<Eigen::MatrixXd> at_markers(const Structure& structure) const;
  // Its derivatives, one matrix a parameter, per unit of the parameter.
  [[nodiscard]] Result<std::vector<Eigen::MatrixXd>> derivatives_at_markers(
      const Structure& structure, const std::vector<StructureParameter>& parameters) const;

  // The same at all nodes, with the factorisation.
  struct Solution {
    Structure structure;
    mechanics::ConstrainedSystem system;
    Eigen::MatrixXd u_mm;
  };
  [[nodiscard]] Result<std::shared_ptr<const Solution>> solution(const Structure& structure) const;

  // (inverse of the stiffness) times the columns, by the factor alone; zero where the structure is fixed.
  [[nodiscard]] static Eigen::MatrixXd solve(const Solution& solution, const Eigen::MatrixXd& forces_mN);

  [[nodiscard]] const SpecimenBody& specimen() const { return *specimen_; }
  [[nodiscard]] const Eigen::MatrixXd& loads_mN() const { return *loads_mN_; }
  [[nodiscard]] const Interpolation& markers() const { return *markers_; }

 private:
  PalpationSolver() = default;
  struct Memory;
  std::shared_ptr<const SpecimenBody> specimen_;
  std::shared_ptr<const Eigen::MatrixXd> loads_mN_;
  std::shared_ptr<const Interpolation> markers_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace glisson::closedloop
