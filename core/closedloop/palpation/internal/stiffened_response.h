#pragma once
// What a specimen that stiffens with strain does to its markers, for any settings of effects: equilibria and how they
// change with every parameter. Remembered, and each search begun from the last one's end.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// What settings mean: the specimen's state, and how much of each unit load (rows) acts at each shot (columns), divided
// by the state's stiffness factor.
struct Acting {
  PalpationState state;
  Eigen::MatrixXd amounts;
};

class StiffenedResponse {
 public:
  // `mesh_error_mm` is added to what the mesh's equations say: 3 rows a marker, a column a shot.
  StiffenedResponse(PalpationSolver solver, std::function<Acting(const Settings&)> acting,
                    std::function<Eigen::MatrixXd(const Acting&)> mesh_error_mm);

  // Displacements (mm): 3 rows a marker, a column a shot. The settings stiffen the specimen. Failures: those of
  // PalpationSolver, "stiffening-diverged".
  [[nodiscard]] Result<Eigen::MatrixXd> at_markers(const Settings& settings) const;
  // Their derivatives, a matrix a parameter of the settings; also where the stiffening is still zero.
  [[nodiscard]] Result<std::vector<Eigen::MatrixXd>> derivatives_at_markers(const Settings& settings) const;

 private:
  struct Memory;
  struct Nodal;
  [[nodiscard]] Result<std::shared_ptr<const Nodal>> equilibria(const Settings& settings) const;

  PalpationSolver solver_;
  std::function<Acting(const Settings&)> acting_;
  std::function<Eigen::MatrixXd(const Acting&)> mesh_error_mm_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace glisson::closedloop
