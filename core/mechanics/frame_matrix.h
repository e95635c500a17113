#pragma once
// The meshfree engine's unknowns and matrices. Each node carries an affine frame, 12 unknowns: how its place moves, and
// how that changes along x, y and z (mm each). A place x moves by
//
//   u(x) = sum over nodes of w_i(x) (t_i + B_i (x - X_i) / l_i),     q = (t, B's three columns) of all nodes in turn
//
// X_i being the node, l_i its size (mm). Affine rather than rigid frames, because then any uniform strain and any
// rotation is in the space exactly, whatever the weights (they sum to 1): that passes the patch test and turns without
// growing, and it leaves mass and stiffness constant in q, so that they are assembled offline. Weights being linear in
// each cell of the background mesh, u is quadratic in each: its values at the corners and mid-side nodes of quadratic
// tetrahedra say all, and integrals over cells are exact. Inside of this room.

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "mechanics/block_assembly.h"
#include "mechanics/meshfree_nodes.h"

namespace glisson::mechanics {

inline constexpr int frame_size = 12;
using FrameBlock = Eigen::Matrix<double, frame_size, frame_size>;

// l_i.
[[nodiscard]] double frame_length_mm(const ShapeFunctions& shape, int frame);

// The frames of an affine field of displacements (or velocities): what they blend to is that field exactly.
[[nodiscard]] Eigen::VectorXd affine_frames(const ShapeFunctions& shape,
                                            const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& field);

// How the nodes of a quadratic layout (here: places) follow the frames.
class FrameBasis {
 public:
  FrameBasis(const geometry::TetMesh& mesh, const NodeLayout& layout, const ShapeFunctions& shape);

  [[nodiscard]] int frames() const { return static_cast<int>(neighbours_.starts.size()) - 1; }
  [[nodiscard]] Eigen::Index unknowns() const { return Eigen::Index{frame_size} * frames(); }

  // Displacements of the places (3 each) from q; and forces on q from forces at the places: the transpose.
  [[nodiscard]] Eigen::VectorXd displacement(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd reduce(const Eigen::VectorXd& force) const;

  // A frame's factor at a place: w (1, (x - X) / l).
  struct Share {
    int place_or_frame;
    Eigen::Vector4d factor;
  };
  [[nodiscard]] const std::vector<Share>& frames_of(int place) const { return frames_of_[place]; }
  [[nodiscard]] const std::vector<Share>& places_of(int frame) const { return places_of_[frame]; }
  // Which frames meet in some cell, themselves included, ascending.
  [[nodiscard]] const Lists& neighbours() const { return neighbours_; }

 private:
  std::vector<std::vector<Share>> frames_of_, places_of_;
  Lists neighbours_;
};

// A symmetric matrix of 12x12 blocks, both triangles stored.
class FrameMatrix {
 public:
  explicit FrameMatrix(Lists columns_of_row)
      : columns_(std::move(columns_of_row)), blocks_(columns_.items.size(), FrameBlock::Zero()) {}

  [[nodiscard]] int rows() const { return static_cast<int>(columns_.starts.size()) - 1; }
  [[nodiscard]] const Lists& columns() const { return columns_; }
  [[nodiscard]] std::vector<FrameBlock>& blocks() { return blocks_; }
  [[nodiscard]] const std::vector<FrameBlock>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t position(int row, int column) const {
    return static_cast<std::size_t>(std::lower_bound(columns_.begin(row), columns_.end(row), column) -
                                    columns_.items.data());
  }
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::SparseMatrix<double> lower() const;
  // a A + b B, of one pattern.
  [[nodiscard]] static FrameMatrix sum(double a, const FrameMatrix& first, double b, const FrameMatrix& second);

 private:
  Lists columns_;
  std::vector<FrameBlock> blocks_;
};

// P^T K P, `lower` being the lower triangle of K over the places (3 unknowns each, 3x3 blocks whole).
[[nodiscard]] FrameMatrix reduced(const Eigen::SparseMatrix<double>& lower, const FrameBasis& basis);

// Adds springs (mN/mm, one for each unknown of a place, 3 a place; 0: none) that resist the places' displacements.
void add_springs(const std::vector<double>& stiffness, const FrameBasis& basis, FrameMatrix& matrix);

}  // namespace glisson::mechanics
