#pragma once
// Preconditioned conjugate gradients on a matrix in single precision (eqs. 4.7-4.10 of the dissertation with the
// preconditioner of e.g. Saad, Iterative Methods for Sparse Linear Systems, 9.2). Sums are kept in double precision and
// made in the same order with any number of threads.

#include "mechanics/solvers/internal/lattice_preconditioner.h"

namespace glisson::mechanics {

// Buffers that a body keeps from step to step; 3 values a node and one more.
struct GradientBuffers {
  std::vector<float> residual, solution, direction, product, preconditioned;

  explicit GradientBuffers(std::size_t nodes)
      : residual(3 * nodes + 1),
        solution(3 * nodes + 1),
        direction(3 * nodes + 1),
        product(3 * nodes + 1),
        preconditioned(3 * nodes + 1) {}
};

// Solves A e = `buffers.residual` (zero where fixed) into `buffers.solution`. It goes on until the recurrence's
// residual is at most `target_norm` or the iterations are spent, and gives back how many it took.
int conjugate_gradients(const BlockCsr& matrix, const std::vector<float>& mask, LatticePreconditioner& preconditioner,
                        double target_norm, int max_iterations, GradientBuffers& buffers);

}  // namespace glisson::mechanics
