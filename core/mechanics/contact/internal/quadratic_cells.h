#pragma once
// The forces of a body of quadratic tetrahedra at large deformation: what a live body asks for several times a picture.
// Eight cells are worked on at a time, one a lane of the vectors that the machine has (Google Highway). The same
// integral as potentials/elastic.h, at the same four points.
//
// With w_kq the displacement of corner k where q = k and of the edge k-q otherwise, the displacement's derivative by
// the barycentric coordinate L_k is linear in the cell: (4b - 1) u_k + 4b sum_q w_kq + 4 (a - b) w_kq at point q, whose
// coordinate L_q is a and whose others are b.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

struct alignas(64) QuadraticBatch {
  static constexpr int lanes = 8;
  using Lanes = std::array<double, lanes>;

  std::array<std::array<std::int64_t, lanes>, 10> first;  // 3 times each node: where its values start
  std::array<std::array<Lanes, 3>, 3> gradients;          // [axis][i]: of L_(i+1); that of L_0 is minus their sum
  Lanes volume;                                           // of one point (mm3); 0 in the lanes after `count`
  std::array<Lanes, 2> constants;  // neo-Hookean: mu and lambda of the stable law; Veronda-Westmann: mu, bulk (kPa)
  std::array<int, lanes> cell;
  int count;
};

class QuadraticCells {
 public:
  // Neo-Hookean (the stable one) or Veronda-Westmann; the cells must be quadratic.
  QuadraticCells(const Body& body, const ChosenLaw& law);

  // The same but for some of the cells, which then resist with nothing and are seen by nobody.
  [[nodiscard]] QuadraticCells without(const std::vector<int>& cells) const;

  struct Strained {
    int inverted_points = 0;
    double largest_squared = 0;  // |C - I|^2, C = F^T F, of any point
  };
  // Takes what the cells resist with (mN, 3 a node) off the forces. Always the same bits, on one thread. `squared` is
  // room to work in: |C - I|^2 of each cell, the largest of its points.
  Strained add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN, std::vector<double>& squared) const;

  // How far the principal stretches differ from 1 at most, over all points, where add_force left `squared`.
  [[nodiscard]] double largest_strain(const Body& body, const Eigen::VectorXd& u_mm,
                                      const std::vector<double>& squared) const;

 private:
  MaterialLaw law_;
  double stiffening_;
  std::vector<QuadraticBatch> batches_;
};

}  // namespace glisson::mechanics
