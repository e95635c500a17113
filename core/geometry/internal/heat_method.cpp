#include "geometry/internal/heat_method.h"

#include <cmath>
#include <Eigen/SparseCholesky>

namespace glisson::geometry {

std::optional<HeatMethod> HeatMethod::on(const std::vector<IntrinsicTriangle>& triangles, Eigen::Index points) {
  double lengths_mm = 0;
  std::vector<Flat> flat;
  for (const IntrinsicTriangle& triangle : triangles) {
    flat.push_back(laid_flat(triangle));
    if (!(flat.back().area_mm2 > 0)) return std::nullopt;
    for (const double length_mm : triangle.lengths_mm) lengths_mm += length_mm;
  }
  const double mean_mm = lengths_mm / (3.0 * static_cast<double>(triangles.size()));
  const double time_mm2 = mean_mm * mean_mm;

  std::vector<Eigen::Triplet<double>> heat, laplace;
  for (const Flat& triangle : flat) {
    for (int a = 0; a < 3; ++a) {
      const int row = triangle.points[a];
      heat.emplace_back(row, row, triangle.area_mm2 / 3);
      for (int b = 0; b < 3; ++b) {
        const int column = triangle.points[b];
        if (row < column) continue;
        const double stiffness = triangle.area_mm2 * triangle.gradients[a].dot(triangle.gradients[b]);
        heat.emplace_back(row, column, time_mm2 * stiffness);
        if (column > 0) laplace.emplace_back(row - 1, column - 1, stiffness);
      }
    }
  }
  Eigen::SparseMatrix<double> of_heat(points, points), of_laplace(points - 1, points - 1);
  of_heat.setFromTriplets(heat.begin(), heat.end());
  of_laplace.setFromTriplets(laplace.begin(), laplace.end());
  auto heat_factor = SparseFactor::of(of_heat), laplace_factor = SparseFactor::of(of_laplace);
  if (!heat_factor || !laplace_factor) return std::nullopt;
  return HeatMethod(std::move(flat), points, std::move(*heat_factor), std::move(*laplace_factor));
}

// Heat flows from each source for a short time. In each triangle a step of length 1 goes down its slope. The potential
// whose slopes are most like these steps is the distance.
template <int Count>
SourceColumns<Count> HeatMethod::distances_mm(const int* sources, int count) const {
  using Row = Eigen::Array<double, 1, Count>;
  constexpr double nothing = 1e-300;
  SourceColumns<Count> heat = SourceColumns<Count>::Zero(points_, Count);
  for (int c = 0; c < count; ++c) heat(sources[c], c) = 1;
  heat_.solve<Count>(heat);

  SourceColumns<Count> divergence = SourceColumns<Count>::Zero(points_, Count);
  for (const Flat& triangle : triangles_) {
    std::array<Row, 3> at;
    for (int k = 0; k < 3; ++k) at[k] = heat.row(triangle.points[k]).array();
    // Far away heat is as small as numbers can be: the triangle's largest is its unit.
    const Row unit = at[0].abs().max(at[1].abs()).max(at[2].abs()).max(nothing).inverse();
    Row x = Row::Zero(), y = Row::Zero();
    for (int k = 0; k < 3; ++k) {
      at[k] *= unit;
      x -= triangle.gradients[k].x() * at[k];
      y -= triangle.gradients[k].y() * at[k];
    }
    const Row step = triangle.area_mm2 * (x.square() + y.square()).max(nothing).rsqrt();
    x *= step;
    y *= step;
    for (int k = 0; k < 3; ++k) {
      divergence.row(triangle.points[k]).array() += triangle.gradients[k].x() * x + triangle.gradients[k].y() * y;
    }
  }
  SourceColumns<Count> potential = divergence.bottomRows(points_ - 1);
  laplace_.solve<Count>(potential);
  SourceColumns<Count> distances(points_, Count);
  distances << SourceColumns<Count>::Zero(1, Count), potential;
  Row at_source = Row::Zero();
  for (int c = 0; c < count; ++c) at_source[c] = distances(sources[c], c);
  distances.array().rowwise() -= at_source;
  return distances.cwiseAbs();
}

template SourceColumns<1> HeatMethod::distances_mm<1>(const int*, int) const;
template SourceColumns<sources_together> HeatMethod::distances_mm<sources_together>(const int*, int) const;

HeatMethod::Flat HeatMethod::laid_flat(const IntrinsicTriangle& triangle) {
  const std::array<Eigen::Vector2d, 3> corners{
      Eigen::Vector2d(0, 0), Eigen::Vector2d(triangle.lengths_mm[0], 0),
      third_corner_mm(triangle.lengths_mm[0], triangle.lengths_mm[1], triangle.lengths_mm[2])};
  const double twice_area_mm2 = corners[1].x() * corners[2].y();
  Flat flat{triangle.points, {}, 0.5 * twice_area_mm2};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d across = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    flat.gradients[k] = Eigen::Vector2d(-across.y(), across.x()) / twice_area_mm2;
  }
  return flat;
}

std::optional<SparseFactor> SparseFactor::of(const Eigen::SparseMatrix<double>& lower) {
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor(lower);
  if (factor.info() != Eigen::Success) return std::nullopt;
  SparseFactor kept;
  kept.l_ = factor.matrixL().nestedExpression();
  kept.l_.makeCompressed();
  kept.place_ = factor.permutationP().indices();
  return kept;
}

template <int Count>
void SparseFactor::solve(SourceColumns<Count>& values) const {
  using Row = Eigen::Matrix<double, 1, Count>;
  const int* starts = l_.outerIndexPtr();
  const int* rows = l_.innerIndexPtr();
  const double* entries = l_.valuePtr();  // of a column, the diagonal first
  SourceColumns<Count> x(values.rows(), Count);
  for (Eigen::Index i = 0; i < values.rows(); ++i) x.row(place_[i]) = values.row(i);
  for (Eigen::Index j = 0; j < x.rows(); ++j) {
    const Row at = x.row(j) / entries[starts[j]];
    x.row(j) = at;
    for (int p = starts[j] + 1; p < starts[j + 1]; ++p) x.row(rows[p]) -= entries[p] * at;
  }
  for (Eigen::Index j = x.rows() - 1; j >= 0; --j) {
    Row at = x.row(j);
    for (int p = starts[j] + 1; p < starts[j + 1]; ++p) at -= entries[p] * x.row(rows[p]);
    x.row(j) = at / entries[starts[j]];
  }
  for (Eigen::Index i = 0; i < values.rows(); ++i) values.row(i) = x.row(place_[i]);
}

}  // namespace glisson::geometry
