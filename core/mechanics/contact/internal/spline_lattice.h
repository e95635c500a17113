#pragma once
// Displacements as quadratic B-splines over a regular lattice laid through a body, and over one twice as wide.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace glisson::mechanics {

// Quadratic B-splines over a regular lattice, and the nodes among them; those twice as wide. Values are 3 a node, and 3
// a point of the wide lattice. A point of the narrow lattice has 4, the last of which is nothing, and there is one
// point more at the end.
class SplineLattice {
 public:
  using Values = std::vector<Eigen::Vector4f>;
  template <typename Value>
  using Shares = std::vector<std::pair<int, Value>>;

  // The finest with at most so many wide points near the nodes. `fixed` has 1 where a displacement is fixed.
  SplineLattice(const std::vector<Eigen::Vector3d>& positions_mm, const std::vector<std::uint8_t>& fixed,
                int most_wide_points);

  [[nodiscard]] int points() const { return static_cast<int>(wide_of_.size()); }
  [[nodiscard]] int wide_points() const { return wide_points_; }
  [[nodiscard]] bool is_fixed(int node, int axis) const {
    return is_free_[static_cast<std::size_t>(3 * node + axis)] == 0;
  }
  // The points around a node, and the wide ones, with their splines' values there.
  [[nodiscard]] Shares<float> around(int node) const;
  [[nodiscard]] Shares<float> wide_around(int node) const;

  // P^T r; and Q^T of that.
  void down(const Eigen::VectorXd& r, Values& values) const;
  void down_to_wide(const Values& values, Eigen::VectorXf& wide) const;
  // values += Q wide; z += P values.
  void up_from_wide(const Eigen::VectorXf& wide, Values& values) const;
  void up(const Values& values, Eigen::VectorXd& z) const;

  struct alignas(16) Place {
    std::array<std::array<float, 4>, 3> weights;  // along each axis; the last is 0
    int first;                                    // of the lattice's points around the node
  };

 private:
  [[nodiscard]] std::array<int, 9> rows_around() const;
  // Of the wide points those whose splines reach a near one.
  void number_wide_points(const std::vector<std::uint8_t>& is_near);

  struct WideShare {
    int point;  // -1: none
    float weight;
  };
  int nx_ = 0, ny_ = 0, nz_ = 0, wide_points_ = 0;
  std::vector<Place> places_;
  std::vector<float> is_free_;                     // 1, or 0 where it is fixed
  std::vector<std::array<WideShare, 8>> wide_of_;  // of each point: a narrow spline is in two wide ones along each axis
};

}  // namespace glisson::mechanics
