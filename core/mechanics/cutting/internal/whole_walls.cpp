#include "mechanics/cutting/internal/whole_walls.h"

#include <algorithm>

#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {

namespace {

using Corners = Eigen::Matrix<double, 3, 4>;
Corners corners_of(const geometry::TetMesh& mesh, int cell) {
  Corners corner_mm;
  for (int i = 0; i < 4; ++i) corner_mm.col(i) = mesh.points_mm[mesh.cells[cell][i]];
  return corner_mm;
}

}  // namespace

double bridged_mm(const geometry::TetMesh& mesh, int cell) {
  return regular_edge_mm(geometry::cell_volume_mm3(mesh, static_cast<std::size_t>(cell))) / bridge_stiffness;
}

std::vector<std::pair<Eigen::Vector4d, double>> whole_places(const geometry::TetMesh& mesh, const CrossedCell& crossed,
                                                             const CutSoFar& opened) {
  const Corners corner_mm = corners_of(mesh, crossed.cell);
  auto places = places_on_wall(crossed, corner_mm);
  std::erase_if(places, [&](const auto& place) { return opened.covers(corner_mm * place.first); });
  return places;
}

std::vector<WholeWall> whole_walls(const geometry::TetMesh& mesh, const Crossing& crossing,
                                   const std::vector<CutStrip>& strips) {
  const CutSoFar opened(strips);
  std::vector<WholeWall> walls;
  for (const CrossedCell& crossed : crossing.cells) {
    WholeWall wall;
    for (const auto& [at, area_mm2] : places_on_wall(crossed, corners_of(mesh, crossed.cell))) {
      wall.all_mm2 += area_mm2 * at;
    }
    for (const auto& [at, area_mm2] : whole_places(mesh, crossed, opened)) {
      wall.whole_mm2 += area_mm2 * at;
      wall.products_mm2 += area_mm2 * at * at.transpose();
    }
    walls.push_back(wall);
  }
  return walls;
}

double whole_area_mm2(const std::vector<WholeWall>& walls) {
  double sum_mm2 = 0;
  for (const WholeWall& wall : walls) sum_mm2 += wall.whole_mm2.sum();
  return sum_mm2;
}

double all_area_mm2(const std::vector<WholeWall>& walls) {
  double sum_mm2 = 0;
  for (const WholeWall& wall : walls) sum_mm2 += wall.all_mm2.sum();
  return sum_mm2;
}

double cut_share(const geometry::TetMesh& mesh, const Crossing& crossing, const std::vector<WholeWall>& walls,
                 const std::vector<int>& points) {
  double all_mm2 = 0, whole_mm2 = 0;
  for (const int point : points) {
    for (const int c : crossing.cells_of_point[point]) {
      const auto& corners = mesh.cells[crossing.cells[c].cell];
      const auto local = std::find(corners.begin(), corners.end(), point) - corners.begin();
      all_mm2 += walls[c].all_mm2[local];
      whole_mm2 += walls[c].whole_mm2[local];
    }
  }
  return 1.0 - whole_mm2 / all_mm2;
}

void add_bridges(const Body& body, const Crossing& crossing, const std::vector<WholeWall>& walls,
                 const std::vector<int>& number, std::vector<Eigen::Triplet<double>>& between) {
  for (std::size_t c = 0; c < walls.size(); ++c) {
    const auto cell = static_cast<std::size_t>(crossing.cells[c].cell);
    const double bridge = body.youngs_kPa[cell] / bridged_mm(body.mesh, crossing.cells[c].cell);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const int row = number[body.mesh.cells[cell][i]], column = number[body.mesh.cells[cell][j]];
        if (row < 0 || column < 0 || walls[c].products_mm2(i, j) == 0) continue;
        between.emplace_back(row, column, bridge * walls[c].products_mm2(i, j));
      }
    }
  }
}

}  // namespace glisson::mechanics
