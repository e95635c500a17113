#include "mechanics/elements/internal/mass_matrix.h"

#include "mechanics/elements/block_assembly.h"

namespace glisson::mechanics {
namespace {

// The integral of N_i N_j over a tetrahedron, times 420 over its volume: by how the two nodes lie to each other, from
// the integral of barycentric coordinates L0^a L1^b L2^c L3^d = 6 V a! b! c! d! / (a + b + c + d + 3)!.
double share_of_420(int i, int j) {
  if (i > j) std::swap(i, j);
  if (j < 4) return i == j ? 6 : 1;
  const auto& [p, q] = edges_of_cell[static_cast<std::size_t>(j - 4)];
  if (i < 4) return i == p || i == q ? -4 : -6;
  if (i == j) return 32;
  const auto& [r, s] = edges_of_cell[static_cast<std::size_t>(i - 4)];
  return p == r || p == s || q == r || q == s ? 16 : 8;
}

}  // namespace

Eigen::SparseMatrix<double> consistent_mass_kg(const Body& body) {
  GLISSON_ASSERT(body.layout.order == ElementOrder::quadratic);
  return assemble_blocks(body.layout, body.boundary, {}, [&](std::size_t cell, int b) {
    const double unit_kg = body.options.density_kg_mm3 * geometry::cell_volume_mm3(body.mesh, cell) / 420.0;
    return [unit_kg, b](int a) { return (unit_kg * share_of_420(a, b) * Eigen::Matrix3d::Identity()).eval(); };
  });
}

}  // namespace glisson::mechanics
