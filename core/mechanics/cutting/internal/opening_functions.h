#pragma once
// The functions by which displacements may differ on the two sides of one surface, with their equations: each has
// several amplitudes (mm). Two kinds: point_jumps.cpp and split_functions.cpp. Inside of this room.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/elements/body.h"
#include "mechanics/statics/reduced_functions.h"

namespace glisson::mechanics {

class OpeningFunctions {
 public:
  virtual ~OpeningFunctions() = default;

  int size = 3;                             // amplitudes of each
  std::vector<std::vector<int>> points_of;  // of each function: the points of crossed cells that it lets jump
  std::vector<double> at_mm;                // of each: where the front first comes to it, ascending
  Eigen::SparseMatrix<double> coupling;     // 3 rows a node and `size` columns a function (mN/mm)
  Eigen::SparseMatrix<double> jumps;        // 3 rows a point of the mesh: its jump from below to above

  // Between two lists of functions (mN/mm), `size` rows and columns each.
  [[nodiscard]] virtual Eigen::MatrixXd stiffness_between(const std::vector<int>& rows,
                                                          const std::vector<int>& columns) const = 0;
  // What loads do on the amplitudes of all (mN). The loads must have passed load_vector.
  [[nodiscard]] virtual Eigen::VectorXd load_on(const Loads& loads) const = 0;
  // Takes off what they move of what is seen by themselves, `size` columns each.
  virtual void take_off(const SeenPart& part, const std::vector<int>& functions, Eigen::MatrixXd& seen_mm) const = 0;
  // The same of all nodes (3 rows each).
  [[nodiscard]] virtual Eigen::VectorXd of_nodes_mm(int function, const Eigen::VectorXd& amplitudes_mm) const = 0;
  // Whether two that belong to different surfaces reach a common node.
  [[nodiscard]] virtual bool meets(int function, const OpeningFunctions& others, int other) const = 0;
};

// Both are kept: the body and the crossing must outlive what is made. `forward` is the way of the front.
[[nodiscard]] std::unique_ptr<const OpeningFunctions> point_jumps(const Body& body, const Crossing& crossing,
                                                                  const Eigen::Vector3d& begin_mm,
                                                                  const Eigen::Vector3d& forward);
[[nodiscard]] std::unique_ptr<const OpeningFunctions> split_functions(const Body& body, const Crossing& crossing,
                                                                      const ReducedFunctions& reduced,
                                                                      const Eigen::Vector3d& begin_mm,
                                                                      const Eigen::Vector3d& forward);

}  // namespace glisson::mechanics
