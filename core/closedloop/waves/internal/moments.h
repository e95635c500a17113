#pragma once
// What the test functions of each patch see of a measured field: sums over voxels of u times each derivative of the
// bump. Kept slice by slice, so that slices can be turned in phase against each other.

#include <complex>
#include <vector>

#include "closedloop/waves/internal/patches.h"

namespace glisson::closedloop {

// A value a voxel, of each component.
using Fields = std::vector<std::vector<std::complex<float>>>;

// The components along the grid's axes where all three were measured; as they are otherwise.
[[nodiscard]] Fields along_grid(const WaveTrial& trial, const imaging::Grid& grid);

// What takes a slice's phase off; `slice_phase` (rad, a slice each) may be empty, for none.
[[nodiscard]] std::complex<double> turned_back(const std::vector<double>& slice_phase, int slice);

class Moments {
 public:
  Moments(const Fields& fields, const imaging::Grid& grid, const TestFunctions& functions,
          const std::vector<Patch>& patches);

  // A column a patch: the moments of the first component, then of the next. `slice_phase` is taken off first.
  [[nodiscard]] Eigen::MatrixXcd of(const TestFunctions& functions, const std::vector<double>& slice_phase) const;

 private:
  // Of a patch: derivatives across the slice in columns (ten a component), a row each slice.
  struct Slices {
    int first = 0;
    Eigen::MatrixXcd sums;
  };
  std::vector<Slices> patches_;
  Eigen::Index components_ = 0;
};

}  // namespace glisson::closedloop
