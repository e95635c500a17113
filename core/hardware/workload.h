#pragma once
// What a case asks of a computer: nodes, block products, and the work and memory traffic of one frame.
//
// Section 6.3.1: every node has its local stiffness matrix A_k. The product of the global matrix with the degrees of
// freedom is the batch A_k x_k, k = 1..N (eqs. 6.1 to 6.5). A frame is 200 iterations of conjugate gradients (figure
// 6.9). A has as many rows as there are degrees of freedom, N n with n = 3, so A_k has three rows. How many nodes its
// columns couple is left open there:
//   1   A_k is 3 x 3: the blocks of eq. 6.1 as its sizes are written, and the only choice for which the batteries of
//       table 6.2 leave frame rates of 10 or more over three hours (figures 6.9c and 6.9d). The default.
//   27  A_k is 3 x 81: all nodes of the cube around the node, as figure 6.3b draws in two dimensions; what a coupled
//       simulation moves.
// Counted is the product alone, as the dissertation's benchmark does, each number fetched or stored once. The vector
// updates of conjugate gradients come on top: about 10 vectors, 120 bytes a node and iteration in single precision.

#include "base/result.h"
#include "hardware/convergence_curve.h"

namespace glisson::hardware {

inline constexpr double smallest_liver_cm3 = 100;  // a small child's
inline constexpr double largest_liver_cm3 = 6000;  // far beyond any but polycystic disease: more is a typing error

struct WorkloadOptions {
  int nodes_in_domain = 1;       // 1 to 125: cubes of 1, 3 or 5 nodes have 1, 27, 125
  int products_per_frame = 200;  // the dissertation's CG iterations
  int bytes_per_value = 4;       // single precision, as accelerators run it
};

struct Workload {
  double resolution_mm3 = 0;
  double nodes = 0;
  int block_rows = 3;
  int block_columns = 3;
  int products_per_frame = 0;
  double bytes_per_node = 0;  // matrix, vector in, vector out
  double product_flops = 0;   // one product: a multiplication and an addition for each entry
  double product_bytes = 0;
  double frame_flops = 0;
  double frame_bytes = 0;
};

// Refused: volumes outside the limits above ("volume-not-a-liver"), domains that are no odd cube
// ("domain-invalid"), a resolution that is not positive.
Result<Workload> workload_at_resolution(double volume_cm3, double resolution_mm3, const WorkloadOptions& options = {});

// The resolution comes from the curve. Refused as above and by resolution_for_accuracy_mm3.
Result<Workload> workload_for_accuracy(double volume_cm3, double accuracy_mm, const ConvergenceCurve& curve,
                                       const WorkloadOptions& options = {});

}  // namespace glisson::hardware
