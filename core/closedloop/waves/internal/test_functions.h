#pragma once
// The bump that test functions are made of, its derivatives up to the third, and what white noise makes of them.

#include <array>
#include <Eigen/Core>

namespace glisson::closedloop {

// How often a function is differentiated along each axis of the grid.
using Derivative = std::array<int, 3>;

// The twenty derivatives of order 0 to 3; each has a place among the moments of a component.
inline constexpr int moments_of_a_component = 20;
[[nodiscard]] const std::array<Derivative, moments_of_a_component>& derivatives();
[[nodiscard]] int place_of(const Derivative& derivative);
[[nodiscard]] Derivative plus(Derivative derivative, int axis);  // once more along the axis

class TestFunctions {
 public:
  // The bump's half width in voxels, an axis each; 0 along an axis of one voxel, along which nothing changes.
  TestFunctions(const std::array<int, 3>& radius, const Eigen::Vector3d& spacing_mm);

  [[nodiscard]] const std::array<int, 3>& radius() const { return radius_; }
  // Where the bump is not 0: -reach .. reach.
  [[nodiscard]] int reach(int axis) const;
  // Of the factor along an axis, `order` times differentiated (1/mm each), `offset` voxels from the middle.
  [[nodiscard]] double factor(int axis, int order, int offset) const;
  [[nodiscard]] double value(const Derivative& derivative, const std::array<int, 3>& offset) const;
  // Sums over voxels of the products of all derivatives: the covariance of moments of noise of variance 1.
  [[nodiscard]] const Eigen::MatrixXd& gram() const { return gram_; }

 private:
  std::array<int, 3> radius_;
  std::array<std::array<Eigen::VectorXd, 4>, 3> factors_;
  Eigen::MatrixXd gram_;
};

}  // namespace glisson::closedloop
