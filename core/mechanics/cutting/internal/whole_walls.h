#pragma once
// What of a cut's walls still holds: the bridges before the front, and their share.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "mechanics/cutting/cut_strip.h"
#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// The part of a crossed cell's wall that is still whole (mm2). Of the corners' linear shape functions `whole_mm2` has
// the integrals over it, `products_mm2` those of their products. `all_mm2` has the integrals over all of the wall.
struct WholeWall {
  Eigen::Vector4d all_mm2 = Eigen::Vector4d::Zero(), whole_mm2 = Eigen::Vector4d::Zero();
  Eigen::Matrix4d products_mm2 = Eigen::Matrix4d::Zero();
};

// Chosen on a clamped block (60 x 30 x 30 mm) of five sizes of cells, which hangs or is bent, with fronts at three
// depths. What the cut adds to its end's displacement is off by 5.7 % on average (2: 7.5 %, 3: 6.2 %) from the block
// meshed with the cut; more where cells are a quarter of the block thick, and by how the front lies in them.
inline constexpr double bridge_stiffness = 2.5;

// Over so much tissue (mm) a jump strains what bridges a cell's wall, in series with the cell itself.
[[nodiscard]] double bridged_mm(const geometry::TetMesh& mesh, int cell);

// Places of a crossed cell's wall that are still whole: barycentric, with the area (mm2) that each stands for.
[[nodiscard]] std::vector<std::pair<Eigen::Vector4d, double>> whole_places(const geometry::TetMesh& mesh,
                                                                           const CrossedCell& crossed,
                                                                           const CutSoFar& opened);

// Of the crossing's cells, in their order, where these strips are cut.
[[nodiscard]] std::vector<WholeWall> whole_walls(const geometry::TetMesh& mesh, const Crossing& crossing,
                                                 const std::vector<CutStrip>& strips);

[[nodiscard]] double whole_area_mm2(const std::vector<WholeWall>& walls);
[[nodiscard]] double all_area_mm2(const std::vector<WholeWall>& walls);

// How much of the points' shares of the wall is cut, between 0 and 1.
[[nodiscard]] double cut_share(const geometry::TetMesh& mesh, const Crossing& crossing,
                               const std::vector<WholeWall>& walls, const std::vector<int>& points);

// The springs of Young's modulus over `bridged_mm`, per area that is whole, between jumps (mN/mm, alike along all
// axes); `number` is of each point of the mesh its jump, -1: none.
void add_bridges(const Body& body, const Crossing& crossing, const std::vector<WholeWall>& walls,
                 const std::vector<int>& number, std::vector<Eigen::Triplet<double>>& between);

}  // namespace glisson::mechanics
