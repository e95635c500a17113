#include "mechanics/materials/material_data.h"

#include <cmath>
#include <Eigen/Dense>

#include "geometry/nearest.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector2d;

double slope_through_origin_kPa(const std::vector<StressStrain>& measured) {
  double products = 0, squares = 0;
  for (const auto& [strain, stress_kPa] : measured) {
    products += strain * stress_kPa;
    squares += strain * strain;
  }
  return squares > 0 ? products / squares : 0.0;
}

}  // namespace

struct MaterialData::Points {
  geometry::NearestPoint tree;  // (sqrt(mu) strain, stress / (2 sqrt(mu)), 0)
};

Result<MaterialData> MaterialData::create(const std::vector<StressStrain>& measured,
                                          const MaterialDataOptions& options) {
  const auto invalid = [](const char* text) { return failure("data-invalid", text); };
  if (measured.size() < 3)
    return invalid(GLISSON_TEXT("A material needs at least 3 measurements of strain and stress."));
  for (const auto& [strain, stress_kPa] : measured) {
    if (!std::isfinite(strain) || !std::isfinite(stress_kPa)) {
      return invalid(GLISSON_TEXT("A measurement of strain and stress is not a finite number."));
    }
  }
  if (!(options.poisson_ratio > -1 && options.poisson_ratio < 0.5) || options.neighbours < 1 || options.slope_kPa < 0) {
    return invalid(
        GLISSON_TEXT("Poisson's ratio must lie between -1 and 0.5, and one neighbour or more is needed for a hull."));
  }
  MaterialData data;
  data.options_ = options;
  data.measurements_ = measured.size();
  data.slope_kPa_ = options.slope_kPa > 0 ? options.slope_kPa : slope_through_origin_kPa(measured);
  if (!(data.slope_kPa_ > 0) || !std::isfinite(data.slope_kPa_)) {
    return invalid(GLISSON_TEXT("The measured stress does not grow with the strain."));
  }
  const double root = std::sqrt(data.shear_kPa());
  std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Zero()};
  for (const auto& [strain, stress_kPa] : measured) {
    const double length = std::sqrt(1.5) * (strain - stress_kPa / (9.0 * data.bulk_kPa()));
    const Eigen::Vector3d point(root * length, std::sqrt(2.0 / 3.0) * stress_kPa / (2.0 * root), 0.0);
    data.largest_deviator_strain_ = std::max(data.largest_deviator_strain_, std::abs(length));
    points.push_back(point);
    points.emplace_back(-point);
  }
  data.points_ = std::make_shared<const Points>(Points{geometry::NearestPoint(std::move(points))});
  return data;
}

MaterialData::State MaterialData::nearest(const State& state) const {
  const double root = std::sqrt(shear_kPa());
  const Vector2d here(root * state.strain, state.stress_kPa / (2.0 * root));
  const auto found = points_->tree.nearest({here.x(), here.y(), 0.0}, options_.neighbours);
  const auto count = static_cast<Eigen::Index>(found.size());
  // Weights that sum to 1: an equation that outweighs the others.
  Eigen::MatrixXd a(3, count);
  double size = here.norm();
  for (Eigen::Index i = 0; i < count; ++i) {
    a.col(i).head<2>() = points_->tree.points_mm()[found[static_cast<std::size_t>(i)].point].head<2>();
    size = std::max(size, a.col(i).head<2>().norm());
  }
  const double heavy = 1e4 * std::max(size, 1e-12);
  a.row(2).setConstant(heavy);
  Eigen::VectorXd weights = non_negative_least_squares(a, Eigen::Vector3d(here.x(), here.y(), heavy));
  weights /= weights.sum();
  const Vector2d there = a.topRows<2>() * weights;
  return {there.x() / root, there.y() * 2.0 * root};
}

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = a.cols();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
  std::vector<bool> passive(static_cast<std::size_t>(n), false);
  const double enough = 1e-12 * a.cwiseAbs().maxCoeff() * std::max(b.cwiseAbs().maxCoeff(), 1e-300);
  const auto solve_passive = [&] {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (passive[static_cast<std::size_t>(i)]) columns.push_back(i);
    }
    const Eigen::MatrixXd part = a(Eigen::all, columns);
    const Eigen::VectorXd solved = part.completeOrthogonalDecomposition().solve(b);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < columns.size(); ++k) z[columns[k]] = solved[static_cast<Eigen::Index>(k)];
    return z;
  };
  for (int round = 0; round < 3 * n + 10; ++round) {
    const Eigen::VectorXd slope = a.transpose() * (b - a * w);
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!passive[static_cast<std::size_t>(i)] && slope[i] > enough && (best < 0 || slope[i] > slope[best])) best = i;
    }
    if (best < 0) break;
    passive[static_cast<std::size_t>(best)] = true;
    for (Eigen::VectorXd z = solve_passive();; z = solve_passive()) {
      double step = 1.0;
      for (Eigen::Index i = 0; i < n; ++i) {
        if (passive[static_cast<std::size_t>(i)] && z[i] <= 0) step = std::min(step, w[i] / (w[i] - z[i]));
      }
      if (step >= 1.0) {
        w = z;
        break;
      }
      w += step * (z - w);
      bool any = false;
      for (Eigen::Index i = 0; i < n; ++i) {
        if (passive[static_cast<std::size_t>(i)] && w[i] <= 1e-15) {
          passive[static_cast<std::size_t>(i)] = false;
          w[i] = 0;
        }
        any |= passive[static_cast<std::size_t>(i)];
      }
      if (!any) break;
    }
  }
  return w;
}

}  // namespace glisson::mechanics
