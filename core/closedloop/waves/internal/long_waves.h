#pragma once
// Waves that compress are metres long in tissue: within a body their displacement is a gradient of a harmonic function,
// and of those the polynomials of low degree (Hobson 1931).

#include <vector>

#include "closedloop/waves/internal/patches.h"

namespace glisson::closedloop {

class LongWaves {
 public:
  // Gradients of all harmonic polynomials of degree 1 to `degree`, as the moments of three components: of each patch a
  // row a moment, a column a field. Of order 1 within the region.
  LongWaves(const imaging::Grid& grid, const TestFunctions& functions, const std::vector<Patch>& patches, int degree);

  [[nodiscard]] const std::vector<Eigen::MatrixXd>& moments() const { return moments_; }

 private:
  std::vector<Eigen::MatrixXd> moments_;
};

}  // namespace glisson::closedloop
