#pragma once
// Conjugate gradients on an OpenCL device, in single precision. The inverses of the diagonal 3x3 blocks precondition
// them (Saad, Iterative Methods for Sparse Linear Systems, 9.2 and 10.2). More iterations than with the lattices of
// conjugate_gradients.h, each far shorter.
//
// Vectors stay on the device; of the scalars only the residual's norm comes back, every `iterations_between_looks`.
// Sums are made in a fixed order: the same device gives the same bits.

#include "mechanics/solvers/internal/conjugate_gradients.h"
#include "opencl/session.h"

namespace glisson::mechanics {

class DeviceGradients {
 public:
  static constexpr int iterations_between_looks = 8;

  // For matrices with this one's pattern. `mask` is 1 for what is free and 0 for what is fixed, 3 a node and one more.
  // Failures: those of opencl::Session::open, and "opencl-failed" where memory does not suffice.
  static Result<DeviceGradients> open(const BlockCsr& matrix, const std::vector<float>& mask,
                                      const std::string& device_name);

  // As conjugate_gradients. Failure: "opencl-failed".
  Result<int> solve(const BlockCsr& matrix, double target_norm, int max_iterations, GradientBuffers& buffers);

  [[nodiscard]] const std::string& device_name() const { return session_.device_name(); }

 private:
  DeviceGradients(const BlockCsr& matrix, const std::vector<float>& mask, opencl::Session session);

  opencl::Session session_;
  int rows_;
  opencl::Buffer starts_, columns_, values_, mask_, inverse_diagonal_;
  opencl::Buffer r_, x_, p_, q_, z_;
  opencl::Buffer partial_, scalars_;
};

}  // namespace glisson::mechanics
