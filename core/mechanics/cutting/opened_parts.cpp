// What others put together anew of an opening: its cells, its jumps' springs, loads and values, and its fronts.

#include <algorithm>

#include "mechanics/cutting/internal/jump_functions.h"
#include "mechanics/cutting/internal/opening_state.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<OpenCell> Opening::cells() const {
  const geometry::TetMesh& mesh = state_->model.mesh();
  std::vector<OpenCell> cells;
  for (const PartlyCut& cut : state_->cuts) {
    const std::vector<int> number = state_->jumps_along(*cut.along);
    for (const CrossedCell& crossed : cut.along->crossing.cells) {
      OpenCell cell{crossed.cell, {}, Eigen::Vector4d::Zero(), crossed.division.wall};
      for (int i = 0; i < 4; ++i) {
        cell.jump[i] = number[mesh.cells[crossed.cell][i]];
        cell.height_mm[i] = cut.along->crossing.height_mm[mesh.cells[crossed.cell][i]];
      }
      if (std::any_of(cell.jump.begin(), cell.jump.end(), [](int j) { return j >= 0; }))
        cells.push_back(std::move(cell));
    }
  }
  return cells;
}

JumpSprings Opening::springs() const {
  const Body& body = state_->model.body();
  const auto jumps = static_cast<Index>(state_->points.size());
  std::vector<Eigen::Triplet<double>> with_nodes, between;
  for (const PartlyCut& cut : state_->cuts) {
    const std::vector<int> number = state_->jumps_along(*cut.along);
    add_bridges(body, cut.along->crossing, cut.walls, number, between);
    add_foundation_springs(body, cut.along->crossing, number, with_nodes, between);
  }
  JumpSprings springs{Eigen::SparseMatrix<double>(body.layout.nodes(), jumps),
                      Eigen::SparseMatrix<double>(jumps, jumps)};
  springs.with_nodes.setFromTriplets(with_nodes.begin(), with_nodes.end());
  springs.between.setFromTriplets(between.begin(), between.end());
  return springs;
}

std::vector<Bridge> Opening::bridges() const {
  const geometry::TetMesh& mesh = state_->model.mesh();
  std::vector<Bridge> bridges;
  for (const PartlyCut& cut : state_->cuts) {
    const std::vector<int> number = state_->jumps_along(*cut.along);
    const CutSoFar opened(cut.strips);
    for (const CrossedCell& crossed : cut.along->crossing.cells) {
      std::array<int, 4> jump{};
      for (std::size_t i = 0; i < 4; ++i) jump[i] = number[mesh.cells[crossed.cell][i]];
      if (std::all_of(jump.begin(), jump.end(), [](int j) { return j < 0; })) continue;
      for (const auto& [at, area_mm2] : whole_places(mesh, crossed, opened)) {
        bridges.push_back({crossed.cell, jump, at, area_mm2, bridged_mm(mesh, crossed.cell)});
      }
    }
  }
  return bridges;
}

VectorXd Opening::force_on_jumps_mN(const Loads& loads) const {
  VectorXd force_mN = VectorXd::Zero(3 * static_cast<Index>(state_->points.size()));
  for (const CutFront& front : fronts()) {
    std::vector<int> points;
    for (const int jump : front.jumps) points.push_back(state_->points[static_cast<std::size_t>(jump)]);
    const SurfaceInBody& along = *state_->surface_of_jump[static_cast<std::size_t>(front.jumps.front())];
    const VectorXd of_surface = load_on(state_->model.body(), along.crossing, loads, points);
    for (std::size_t i = 0; i < front.jumps.size(); ++i) {
      force_mN.segment<3>(3 * front.jumps[i]) += of_surface.segment<3>(static_cast<Index>(3 * i));
    }
  }
  return force_mN;
}

std::vector<Opening::JumpValues> Opening::jumps_at(const std::vector<PointInMesh>& places) const {
  const geometry::TetMesh& mesh = state_->model.mesh();
  std::vector<JumpValues> seen(places.size());
  for (const PartlyCut& cut : state_->cuts) {
    const std::vector<int> number = state_->jumps_along(*cut.along);
    for (std::size_t p = 0; p < places.size(); ++p) {
      for (const int point : mesh.cells[places[p].cell]) {
        if (number[point] < 0) continue;
        const double value = value_at(mesh, cut.along->crossing, point, places[p]);
        if (value != 0) seen[p].emplace_back(number[point], value);
      }
    }
  }
  return seen;
}

std::vector<CutFront> Opening::fronts() const {
  std::vector<CutFront> fronts;
  for (const PartlyCut& cut : state_->cuts) {
    CutFront front{cut.strips.back(), {}};
    for (std::size_t i = 0; i < state_->points.size(); ++i) {
      if (state_->surface_of_jump[i] == cut.along.get()) front.jumps.push_back(static_cast<int>(i));
    }
    if (!front.jumps.empty()) fronts.push_back(std::move(front));
  }
  return fronts;
}

}  // namespace glisson::mechanics
