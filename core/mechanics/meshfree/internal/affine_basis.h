#pragma once
// The meshfree engine's unknowns. Each node carries an affine handle, 12 unknowns: how its place moves, and how that
// changes along x, y and z (mm each). A place x moves by
//
//   u(x) = sum over nodes of w_i(x) (t_i + B_i (x - X_i) / l_i),     q = (t, B's three columns) of all nodes in turn
//
// X_i being the node, l_i its size (mm). Handles are affine rather than rigid. Then any uniform strain and any rotation
// is in the space exactly, whatever the weights (they sum to 1). So the engine passes the patch test, and the body
// turns without growing. Mass and stiffness are constant in q, and are assembled offline. The weights are linear in
// each cell of the background mesh, so u is quadratic there. Its values at the corners and mid-side nodes of quadratic
// tetrahedra say all, and integrals over cells are exact.
//
// At a point p of the mesh the handles blend to one affine field of its own: A_p = sum of w_i times handle i. At the
// point, u is A_p. In the middle of an edge it is the mean of two such fields. So handles speak to points, of which
// there are few, and points to the places of a quadratic layout.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "mechanics/elements/block_assembly.h"
#include "mechanics/meshfree/meshfree_nodes.h"

namespace glisson::mechanics {

inline constexpr int handle_size = 12;
using HandleBlock = Eigen::Matrix<double, handle_size, handle_size>;

// l_i.
[[nodiscard]] double handle_length_mm(const ShapeFunctions& shape, int handle);

// The handles of an affine field of displacements (or velocities): what they blend to is that field exactly.
[[nodiscard]] Eigen::VectorXd affine_handles(const ShapeFunctions& shape,
                                             const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& field);

// How few coarse handles lead many: handle i follows them with the weights [starts[i], starts[i + 1]), which sum to 1.
struct HandleLead {
  std::vector<Eigen::Vector3d> leaders_mm;
  std::vector<double> lengths_mm;
  std::vector<std::size_t> starts;
  std::vector<int> leaders;
  std::vector<double> weights;
};

// How the nodes of a quadratic layout (here: places) follow the handles.
class AffineBasis {
 public:
  AffineBasis(const geometry::TetMesh& mesh, const NodeLayout& layout, const ShapeFunctions& shape);

  [[nodiscard]] int handles() const { return static_cast<int>(positions_mm_.size()); }
  [[nodiscard]] Eigen::Index unknowns() const { return Eigen::Index{handle_size} * handles(); }
  // How many of the last handles are those of fixed points (meshfree_body.h).
  [[nodiscard]] int fixed_nodes() const { return fixed_nodes_; }
  [[nodiscard]] int points() const { return static_cast<int>(points_mm_.size()); }
  [[nodiscard]] int places() const { return static_cast<int>(ends_.size()); }

  // Displacements of the places (3 each) from q; and forces on q from forces at the places: the transpose.
  [[nodiscard]] Eigen::VectorXd displacement(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd reduce(const Eigen::VectorXd& force) const;

  // P itself, of some handles: 3 rows a place and handle_size columns a handle.
  [[nodiscard]] Eigen::SparseMatrix<double> columns(const std::vector<int>& handles) const;

  // The same body over the leaders alone: where the handles do what their leaders say, places move alike.
  [[nodiscard]] AffineBasis led_by(const HandleLead& lead) const;
  // The handles that do what their leaders say, and the transpose.
  [[nodiscard]] Eigen::VectorXd follow(const HandleLead& lead, const Eigen::VectorXd& leaders) const;
  [[nodiscard]] Eigen::VectorXd gather(const HandleLead& lead, const Eigen::VectorXd& handles) const;

  // What a handle gives to the field at a point x of the mesh. It gives weight * t + B * arm to its value, and slope *
  // B to its slope. For a handle of its own, w, w (x - X) / l and w / l.
  struct Share {
    int handle;
    double weight;
    Eigen::Vector3d arm;
    double slope_per_mm;
  };
  [[nodiscard]] const Share* shares_begin(int point) const { return shares_.data() + share_starts_[point]; }
  [[nodiscard]] const Share* shares_end(int point) const { return shares_.data() + share_starts_[point + 1]; }
  // The points that a handle acts on, ascending, and which of the point's shares it is.
  struct Reach {
    int point;
    int share;
  };
  [[nodiscard]] const std::vector<Reach>& points_of(int handle) const { return points_of_[handle]; }

  // A place is a point of the mesh, or the middle between two: it takes `part` of each one's field, `away_mm` from it.
  struct End {
    int point = -1;  // of the second end of a place that is a point
    double part = 0;
    Eigen::Vector3d away_mm{0, 0, 0};
  };
  [[nodiscard]] const std::array<End, 2>& ends_of(int place) const { return ends_[place]; }
  [[nodiscard]] const Lists& places_of_point() const { return places_of_point_; }

  [[nodiscard]] const Eigen::Vector3d& position_mm(int handle) const { return positions_mm_[handle]; }
  [[nodiscard]] double length_mm(int handle) const { return lengths_mm_[handle]; }

 private:
  AffineBasis() = default;
  void find_reach();

  std::vector<Eigen::Vector3d> positions_mm_;  // of handles
  std::vector<double> lengths_mm_;
  int fixed_nodes_ = 0;
  std::vector<Eigen::Vector3d> points_mm_;
  std::vector<std::size_t> share_starts_;
  std::vector<Share> shares_;
  std::vector<std::vector<Reach>> points_of_;
  std::vector<std::array<End, 2>> ends_;
  Lists places_of_point_;
};

}  // namespace glisson::mechanics
