#pragma once
// The linear tetrahedra of a moving body, each with the rotation it has turned by: forces in double precision without
// any matrix, and the same stiffness as blocks of one. Inside of this room.
//
// The force is that of warped stiffness (corotational.h): R C : sym(R^T grad w - I), with R held. Nodes are numbered
// anew, along the body's longest side, and cells go through in slabs along it, every other one at a time: two slabs
// that are worked on together share no node, and every sum is made in the same order with any number of threads.

#include <Eigen/Core>
#include <vector>

#include "mechanics/block_csr.h"
#include "mechanics/body.h"

namespace glisson::mechanics {

class TurningCells {
 public:
  enum class Turning { each_step, never };  // never: linear elasticity

  // The body's cells must be linear.
  TurningCells(const Body& body, Turning turning);

  [[nodiscard]] int nodes() const { return static_cast<int>(node_of_layout_.size()); }
  [[nodiscard]] const std::vector<int>& node_of_layout() const { return node_of_layout_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& rest_positions_mm() const { return rest_mm_; }

  // The pattern of the stiffness: which nodes share a cell, themselves included.
  [[nodiscard]] Lists neighbours() const;

  struct Turned {
    int inverted_cells = 0;
    double strain_energy_uJ = 0;
  };
  // Takes every cell's rotation from the displacement.
  Turned turn(const Eigen::VectorXd& u_mm);

  // Adds the forces (mN) that the cells resist with where the nodes are moved by u, rotations held.
  void add_force_mN(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const;
  // Adds `factor` K w with the same rotations: the change of the forces above.
  void add_stiffness_times(double factor, const Eigen::VectorXd& w, Eigen::VectorXd& product) const;
  // Adds `factor` K to the matrix, whose pattern is `neighbours()`.
  void add_stiffness(double factor, BlockCsr& matrix);

 private:
  struct Cell {
    std::array<int, 4> nodes;
    Eigen::Matrix<double, 3, 3> gradients;  // columns: of the nodes 1, 2, 3; that of node 0 is minus their sum
    double lambda_volume, mu_volume;        // Lame's constants times the volume (kPa mm3)
  };
  struct Slab {
    std::size_t begin, end;  // of cells_
  };

  void make_slabs();
  void find_blocks(const BlockCsr& matrix);
  template <typename Work>
  void each_cell(const Work& work) const;
  template <bool at_rest_is_identity>
  [[nodiscard]] Eigen::Matrix3d stress_times_volume(std::size_t cell, const Eigen::VectorXd& w) const;
  void scatter(std::size_t cell, const Eigen::Matrix3d& stress, Eigen::VectorXd& force) const;

  Turning turning_;
  std::vector<int> node_of_layout_;
  std::vector<Eigen::Vector3d> rest_mm_;
  std::vector<Cell> cells_;
  std::vector<Eigen::Matrix3d> rotations_;
  std::vector<Slab> slabs_;
  std::vector<std::array<int, 16>> blocks_;  // of a cell in the matrix, row after row; found at the first use
};

}  // namespace glisson::mechanics
