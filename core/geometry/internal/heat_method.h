#pragma once
// The heat method's arithmetic (Crane, Weischedel, Wardetzky 2013), many sources at once.

#include <array>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "geometry/internal/intrinsic_delaunay.h"

namespace glisson::geometry {

// Sources that are answered together: each number of a factor that is read then serves them all.
inline constexpr int sources_together = 8;

// A column a source.
template <int Count>
using SourceColumns = Eigen::Matrix<double, Eigen::Dynamic, Count, Count == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

// L L^T of a sparse symmetric matrix, in an order that keeps L sparse.
class SparseFactor {
 public:
  // From the lower triangle; nothing where the matrix is not positive definite.
  static std::optional<SparseFactor> of(const Eigen::SparseMatrix<double>& lower);
  template <int Count>
  void solve(SourceColumns<Count>& values) const;

 private:
  Eigen::SparseMatrix<double> l_;
  Eigen::VectorXi place_;  // of each row in that order
};

class HeatMethod {
 public:
  // Nothing where heat cannot spread: a triangle is flat.
  static std::optional<HeatMethod> on(const std::vector<IntrinsicTriangle>& triangles, Eigen::Index points);

  [[nodiscard]] Eigen::Index points() const { return points_; }
  // Of every point from each of `count` sources; further columns mean nothing. Count is 1 or sources_together.
  template <int Count>
  [[nodiscard]] SourceColumns<Count> distances_mm(const int* sources, int count) const;

 private:
  // A triangle laid in a plane.
  struct Flat {
    std::array<int, 3> points;
    std::array<Eigen::Vector2d, 3> gradients;  // of each point's hat function, 1/mm
    double area_mm2;
  };
  static Flat laid_flat(const IntrinsicTriangle& triangle);

  HeatMethod(std::vector<Flat> triangles, Eigen::Index points, SparseFactor heat, SparseFactor laplace)
      : triangles_(std::move(triangles)), points_(points), heat_(std::move(heat)), laplace_(std::move(laplace)) {}

  std::vector<Flat> triangles_;
  Eigen::Index points_;
  SparseFactor heat_;     // of lumped masses and t times the cotangent Laplacian, t being the mean edge squared
  SparseFactor laplace_;  // without the first point, where the potential is zero
};

}  // namespace glisson::geometry
