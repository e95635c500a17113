#pragma once
// Linear tetrahedra eight at a time, one a lane of the vectors that the machine has: what CorotationalElements does
// with them at every step. Google Highway compiles this for every instruction set that the compiler knows, and chooses
// when the program runs. Another instruction set rounds otherwise, in the last digit.

#include <array>
#include <cstdint>

namespace glisson::mechanics {

struct alignas(64) ElementBatch {
  static constexpr int lanes = 8;
  using Lanes = std::array<double, lanes>;

  std::array<std::array<std::int64_t, lanes>, 4> first;  // 3 times each node: where its values start
  std::array<std::array<Lanes, 3>, 3> gradients;         // [axis][i]: of node i + 1; that of node 0 is minus their sum
  std::array<std::array<Lanes, 3>, 3> rotation;          // [row][column]
  Lanes lambda_volume, mu_volume;                        // Lame's constants times the volume (kPa mm3)
  int count;  // of cells; the lanes after them repeat the last one's nodes, without gradients or stiffness
};

struct CellKernels {
  struct Turned {
    int inverted_cells = 0;
    double strain_energy_uJ = 0;
  };
  // Takes the rotations of F = I + grad u, unless `kept`, and sums up. Where a cell is crushed or inside out, its
  // rotation is asked of `slow_rotation` (F in, R out, [row][column]).
  Turned (*turn)(ElementBatch* begin, const ElementBatch* end, const double* u, bool fixed,
                 void (*slow_rotation)(const double f[3][3], double r[3][3]));
  // Adds `factor` times the forces R C : sym(R^T (rest I + grad w) - rest I). `rest` is 1 for those of a displacement
  // w, and 0 for their change by w. No two batches in the range may be worked on elsewhere with a node in common.
  void (*add_forces)(const ElementBatch* begin, const ElementBatch* end, const double* w, double rest, double factor,
                     double* forces);
};

// For the widest instructions that this machine has.
[[nodiscard]] CellKernels cell_kernels();

}  // namespace glisson::mechanics
