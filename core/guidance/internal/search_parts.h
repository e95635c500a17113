#pragma once
// What searches for a pose share: rotations spread evenly, how a pose moves, how far two lie apart and which fits
// better.

#include <Eigen/Geometry>
#include <vector>

namespace glisson::guidance {

// Where the line of sight points in the organ (48 directions, Fibonacci's lattice), and 12 turns about it.
[[nodiscard]] std::vector<Eigen::Matrix3d> even_rotations();

// At least in one of both.
struct Apart {
  double mm = 0;  // at the organ's middle
  double deg = 0;
};
[[nodiscard]] bool lie_apart(const Eigen::Isometry3d& pose, const Eigen::Isometry3d& other,
                             const Eigen::Vector3d& middle_mm, const Apart& apart);

// Shifted by the step's first three, mm, and turned by its last three, radians about that place.
[[nodiscard]] Eigen::Isometry3d moved_about(const Eigen::Isometry3d& pose, const Eigen::Vector3d& about_mm,
                                            const Eigen::Matrix<double, 6, 1>& step);

struct Scored {
  double cost = 0;  // what is not explained
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};
[[nodiscard]] inline bool fits_better(const Scored& a, const Scored& b) { return a.cost < b.cost; }

// So many at most, spread evenly over their order.
template <typename T>
std::vector<T> every_nth(const std::vector<T>& all, std::size_t maximum) {
  if (all.size() <= maximum) return all;
  std::vector<T> some;
  for (std::size_t i = 0; i < maximum; ++i) some.push_back(all[i * all.size() / maximum]);
  return some;
}

}  // namespace glisson::guidance
