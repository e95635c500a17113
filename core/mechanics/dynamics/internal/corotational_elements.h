#pragma once
// The linear tetrahedra of a moving body, each with the rotation it has turned by. They give forces in double precision
// without any matrix, and the same stiffness as blocks of one.
//
// The force is that of warped stiffness (corotational.h): R C : sym(R^T grad w - I), with R kept. Nodes are numbered
// anew, along the body's longest side. Cells go through in slabs along it, every other one at a time, so that two slabs
// worked on together share no node. Every sum is made in the same order with any number of threads.

#include <Eigen/Core>
#include <vector>

#include "mechanics/dynamics/internal/element_batch.h"
#include "mechanics/elements/body.h"
#include "mechanics/solvers/internal/block_csr.h"

namespace glisson::mechanics {

class CorotationalElements {
 public:
  enum class Turning { each_step, never };  // never: linear elasticity

  // The body's cells must be linear; they are as stiff as that share of its moduli makes them.
  CorotationalElements(const Body& body, Turning turning, double share = 1);

  [[nodiscard]] int nodes() const { return static_cast<int>(node_of_layout_.size()); }
  [[nodiscard]] const std::vector<int>& node_of_layout() const { return node_of_layout_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& rest_positions_mm() const { return rest_mm_; }

  // The pattern of the stiffness: which nodes share a cell, themselves included.
  [[nodiscard]] Lists neighbours() const;

  using Turned = CellKernels::Turned;
  // Takes every cell's rotation from the displacement.
  Turned turn(const Eigen::VectorXd& u_mm);

  // Adds the forces (mN) that the cells resist with where the nodes are moved by u, rotations kept.
  void add_force_mN(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const;
  // Adds `factor` K w with the same rotations: the change of the forces above.
  void add_stiffness_times(double factor, const Eigen::VectorXd& w, Eigen::VectorXd& product) const;
  // Adds `factor` K to the matrix, whose pattern is `neighbours()`.
  void add_stiffness(double factor, BlockCsr& matrix);

 private:
  struct Slab {
    std::size_t begin, end;  // of batches_
  };

  template <typename Work>
  void each_slab(const Work& work) const;
  void find_blocks(const BlockCsr& matrix);
  void add_forces(const Eigen::VectorXd& w, double rest, double factor, Eigen::VectorXd& forces) const;

  Turning turning_;
  CellKernels kernels_ = cell_kernels();
  std::vector<int> node_of_layout_;
  std::vector<Eigen::Vector3d> rest_mm_;
  std::vector<ElementBatch> batches_;  // of one slab each
  std::vector<Slab> slabs_;
  std::vector<std::array<int, 16>> blocks_;  // of each lane's cell in the matrix, row after row; found at the first use
};

}  // namespace glisson::mechanics
