#pragma once
// A cut that opens step by step through a linear body, while the factor of the whole body is kept.
//
// Behind the cut's front the displacement may jump. With K the body's stiffness, u its nodes' displacements and a the
// amplitudes of the functions that jump,
//   [K B; B^T D] [u; a] = [f; g],   S = D - B^T K^-1 B,   a = S^-1 (g - B^T K^-1 f),   u = K^-1 f - V a,
// V = K^-1 B less the functions' own part of what is seen (a bordered system, e.g. Golub and Van Loan, Matrix
// Computations, 3.2). S is dense and small. An advance costs a dozen solves with K's factor for four points, or one
// meshfree node, that begin to open; nothing else is solved again.
//
// Of finite elements the functions are those of points of crossed cells, and their amplitudes are the jumps there
// (internal/jump_functions.h). Where displacements follow fewer functions than nodes (meshfree nodes), those that the
// cut crosses are split by it (internal/split_functions.cpp), and the jumps at points follow.
//
// The front runs through cells. Where part of a point's share of the wall is still whole, springs hold its jump back.
// Per area of that part they are 2.5 times Young's modulus over the cell's edge (internal/whole_walls.h).
//
// Lengths mm, forces mN, patient coordinates (LPS) at rest. A value: an advance gives a new one, and shares with the
// old what is the same.

#include <array>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/result.h"
#include "mechanics/cutting/cut_strip.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

// What of the displacements is asked for.
struct SeenPart {
  // Its rows of displacements of all nodes (3 a node), one column a case.
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& displacement_mm)> of_nodes;
  // Those rows, three a place, that are not of a point of the mesh but of a place in a cell.
  struct Place {
    Eigen::Index row;
    PointInMesh at;
  };
  std::vector<Place> places;
  // Of three rows each, in order, the point of the mesh, -1 where it is one of `places`. Finite elements need none.
  std::vector<int> points = {};
};

// A cell that is open, wholly or in part. On the side `s` (1 above, 0 below) the corner i is displaced by u_i + (s -
// H_i) times its jump. `jump` has that one's number in Opening::points(), -1 for none. H_i is 1 where the corner's
// height is above zero.
struct OpenCell {
  int cell;
  std::array<int, 4> jump;
  Eigen::Vector4d height_mm;
  std::vector<Eigen::Vector4d> wall;  // three or four places in order around it, barycentric
};

// Springs on jumps, alike along all axes (mN/mm): what still bridges the walls, and what of foundations lies under
// them.
struct JumpSprings {
  Eigen::SparseMatrix<double> with_nodes;  // one row a node and one column a jump
  Eigen::SparseMatrix<double> between;     // jumps
};

// A place of a wall that is still whole (mm2 of it). Springs resist the jump there, which is the sum of `share` of
// jumps; it strains the tissue over `length_mm`.
struct Bridge {
  int cell;
  std::array<int, 4> jump;  // -1: none
  Eigen::Vector4d share;
  double area_mm2, length_mm;
};

// How far the cut along one surface has come, by its last strip.
struct CutFront {
  CutStrip last;
  std::vector<int> jumps;  // across it
};

class Opening {
 public:
  // Nothing is open yet. Failures: those of load_vector; "not-converged".
  static Result<Opening> of(StaticModel model, Loads standing_loads, SeenPart seen);

  // Opens a strip, along a new surface or one that is cut already, or along a swept line that is longer than the one
  // that is cut: that one is led on, and what is open stays as it is to the bit. Points that are fixed stay together.
  // Fails with "cut-invalid" (a strip without a length along its
  // surface) or "cut-misses" (it opens nothing that was not open). Fails with "cuts-meet" (it crosses cells, or
  // comes into the reach of meshfree nodes, that a cut along another surface has opened). Fails with "cut-frees-part"
  // (nothing would hold what is cut off), "not-available" (a capsule; a longer line with meshfree nodes),
  // "not-converged", or "cut-turns" (cells that are open lead another way than the line does further on).
  [[nodiscard]] Result<Opening> advanced(const CutStrip& strip) const;

  // Solves ahead for some of the points that such an advance would open, so that the advance need not. On a liver that
  // is a tenth of a second's work. False where all of them are known, and along a swept line. What is opened stays as
  // it is, to the bit. Failure: "not-converged".
  [[nodiscard]] Result<bool> prepare(const CutStrip& ahead) const;

  // Points of the mesh whose jump is open, in the order of `jumps_mm`, and the normals of their walls, to above.
  [[nodiscard]] const std::vector<int>& points() const;
  [[nodiscard]] const std::vector<Eigen::Vector3d>& normals() const;
  // Whether any of the wall around a point is cut: where none is, functions let it jump and bridges hold it.
  [[nodiscard]] bool is_cut(std::size_t point) const;
  [[nodiscard]] std::vector<OpenCell> cells() const;

  // For those who put finite elements' functions together anew: L_i (H - H_i) at each of points(). `springs` are what
  // is more than the cells' own, `force_on_jumps_mN` the dead loads on them (mN, 3 a jump; gas as at rest). `jumps_at`
  // gives, of places, the jumps that are seen, with their values.
  [[nodiscard]] JumpSprings springs() const;
  [[nodiscard]] std::vector<Bridge> bridges() const;  // of which springs() has the stiffness at rest
  [[nodiscard]] Eigen::VectorXd force_on_jumps_mN(const Loads& loads) const;
  using JumpValues = std::vector<std::pair<int, double>>;
  [[nodiscard]] std::vector<JumpValues> jumps_at(const std::vector<PointInMesh>& places) const;
  [[nodiscard]] std::vector<CutFront> fronts() const;

  // The loads on the amplitudes, g - B^T K^-1 f (mN). The first are of the standing loads. The second are of a
  // force (mN) on the point of the mesh that is seen in three rows from `row`. The third are of 1 mN that pushes the
  // walls apart at a point, along the direction.
  [[nodiscard]] const Eigen::VectorXd& standing_load() const;
  [[nodiscard]] Eigen::VectorXd load_of_force(Eigen::Index row, const Eigen::Vector3d& force_mN) const;
  [[nodiscard]] Eigen::VectorXd load_of_push(std::size_t point, const Eigen::Vector3d& direction) const;

  // The amplitudes (mm) under loads on them, and the jumps that they make (mm, 3 a point). `seen_mm` is how much what
  // is seen moves because of them: all of it, or its first rows alone.
  [[nodiscard]] Eigen::MatrixXd amplitudes_mm(const Eigen::MatrixXd& load) const;
  [[nodiscard]] Eigen::VectorXd jumps_mm(const Eigen::VectorXd& amplitudes_mm) const;
  [[nodiscard]] Eigen::VectorXd seen_mm(const Eigen::VectorXd& amplitudes_mm) const;
  [[nodiscard]] Eigen::VectorXd seen_mm(const Eigen::VectorXd& amplitudes_mm, Eigen::Index rows) const;

  // Of the cuts' walls within the body (mm2), one side of them, and what still bridges them. A swept line is cut as it
  // is drawn, and nothing of it counts as whole.
  [[nodiscard]] double open_mm2() const;
  [[nodiscard]] double whole_mm2() const;

  // What they push on the body's nodes with. Under these forces and the loads, the whole body has the displacements of
  // the cut one, less what the functions move of it by themselves (mm, 3 a node; of finite elements nothing).
  [[nodiscard]] Eigen::VectorXd force_on_nodes_mN(const Eigen::VectorXd& amplitudes_mm) const;
  [[nodiscard]] Eigen::VectorXd of_nodes_mm(const Eigen::VectorXd& amplitudes_mm) const;

  [[nodiscard]] double relative_residual() const;  // the worst of its solves

 private:
  struct State;
  explicit Opening(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace glisson::mechanics
