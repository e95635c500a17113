#pragma once
// Weak forms of patches through which the border of a stiffer or softer region runs: there div(G grad w), with the
// region's indicator smoothed over about a voxel, is summed over voxels.

#include <complex>
#include <functional>
#include <vector>

#include "closedloop/waves/internal/moments.h"
#include "closedloop/waves/internal/patches.h"
#include "closedloop/waves/internal/wave_law.h"

namespace glisson::closedloop {

// Of a voxel: how much of it belongs to the region, and how that changes (1/mm, along the grid's axes).
struct Belonging {
  double share = 0;
  Eigen::Vector3d slope{0, 0, 0};
};
using Region = std::function<Belonging(const std::array<int, 3>& voxel)>;

// Where a signed distance (mm, positive within) and its gradient lead, smoothed over `width_mm` to each side.
[[nodiscard]] Belonging smoothed(double signed_distance_mm, const Eigen::Vector3d& gradient, double width_mm);

// Of one patch and region; b is what the region adds to L w for a modulus of 1.
struct RegionSums {
  Eigen::VectorXcd seen;   // <u, b>, a test function each
  Eigen::MatrixXd with_w;  // <w, b>: test functions across and down
  Eigen::MatrixXd with_l;  // <L w / G, b>
  Eigen::MatrixXd own;     // <b, b>
  double share = 0;        // of the patch, by the bump
};

class RegionForms {
 public:
  RegionForms(const WeakForms& forms, TestFunctions functions, imaging::Grid grid);

  [[nodiscard]] RegionSums sums(const Patch& patch, const Fields& fields, const std::vector<double>& slice_phase,
                                const Region& region) const;

  // The covariance of `rows` (a homogeneous isotropic medium's, with that of unit noise `covariance`) with the region
  // `ratio` times as stiff, and what the test functions see.
  struct Forms {
    Eigen::MatrixXcd covariance;
    Eigen::VectorXcd seen;
  };
  [[nodiscard]] static Forms with_region(const RegionSums& sums, const Medium& medium, double ratio,
                                         const Eigen::MatrixXcd& covariance, const Eigen::VectorXcd& seen);

 private:
  WeakForms forms_;
  TestFunctions functions_;
  imaging::Grid grid_;
  int tests_, axes_;  // by component all components have the same test functions, of one axis
  // Of each voxel of a patch: test functions by axis, L w / G of them, and what a slope of G along each axis of the
  // grid adds.
  Eigen::MatrixXd w_, l_;
  std::array<Eigen::MatrixXd, 3> by_slope_;
  Eigen::VectorXd weights_;  // squares of the bump
};

}  // namespace glisson::closedloop
