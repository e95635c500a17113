#include "shapes/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>

#include "base/parallel.h"
#include "geometry/nearest.h"

namespace glisson::shapes {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Surface;

constexpr int motions = 6;  // three shifts and three turns, beside the modes
constexpr double shift_prior_mm = 50, turn_prior = 0.3;

// A place on the model's surface and where it was seen.
struct Pair {
  std::array<int, 3> points{};
  Vector3d weights{1, 0, 0};
  Vector3d seen_mm{0, 0, 0};
  Vector3d normal{0, 0, 1};
};

// At most so many of the points, evenly by their numbers.
std::vector<std::size_t> some_of(std::size_t points, std::size_t most) {
  std::vector<std::size_t> some;
  const double step = std::max(1.0, static_cast<double>(points) / static_cast<double>(most));
  for (double at = 0; at < static_cast<double>(points); at += step) some.push_back(static_cast<std::size_t>(at));
  return some;
}

Vector3d weights_in(const Surface& surface, const std::array<int, 3>& triangle, const Vector3d& at_mm) {
  const Vector3d a = surface.points_mm[static_cast<std::size_t>(triangle[0])];
  const Vector3d ab = surface.points_mm[static_cast<std::size_t>(triangle[1])] - a;
  const Vector3d ac = surface.points_mm[static_cast<std::size_t>(triangle[2])] - a;
  const Vector3d normal = ab.cross(ac);
  if (normal.squaredNorm() <= 0) return {1, 0, 0};
  const double b = (at_mm - a).cross(ac).dot(normal) / normal.squaredNorm();
  const double c = ab.cross(at_mm - a).dot(normal) / normal.squaredNorm();
  return {1 - b - c, b, c};
}

// Each seen point with its nearest place on the model, where both face the same way.
std::vector<Pair> pairs_of(const Surface& model, const Surface& seen, const std::vector<Vector3d>& seen_normals,
                           const std::vector<std::size_t>& some, double farthest_mm) {
  const geometry::SurfaceDistance distance(model);
  const std::vector<Vector3d> normals = geometry::point_normals(model);
  std::vector<Pair> pairs(some.size());
  std::vector<std::uint8_t> alike(some.size());
  parallel_for(some.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto closest = distance.closest(seen.points_mm[some[n]]);
      if (closest.distance_mm > farthest_mm) continue;
      Pair& pair = pairs[n];
      pair.points = model.triangles[static_cast<std::size_t>(closest.triangle)];
      pair.weights = weights_in(model, pair.points, closest.point_mm);
      pair.seen_mm = seen.points_mm[some[n]];
      pair.normal = Vector3d::Zero();
      for (int c = 0; c < 3; ++c) {
        pair.normal += pair.weights[c] * normals[static_cast<std::size_t>(pair.points[static_cast<std::size_t>(c)])];
      }
      pair.normal.normalize();
      alike[n] = pair.normal.dot(seen_normals[some[n]]) > 0.5 ? 1 : 0;
    }
  });
  std::size_t kept = 0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    if (alike[n] != 0) pairs[kept++] = pairs[n];
  }
  pairs.resize(kept);
  return pairs;
}

// The posterior of modes and a small motion about the present pose.
struct Posterior {
  VectorXd mean;  // modes, then shift and turn over their priors' deviations
  MatrixXd covariance;
};

class Fitting {
 public:
  Fitting(const ShapeModel& model, const FitOptions& options) : model_(model), options_(options) {}

  // Rows of one point: what each unknown adds to where it lies, in the patient's frame.
  [[nodiscard]] MatrixXd rows_of(int point, const Eigen::Isometry3d& pose, const Vector3d& about_mm,
                                 const Vector3d& placed_mm) const {
    MatrixXd rows(3, model_.rank() + motions);
    rows.leftCols(model_.rank()) = pose.linear() * model_.modes_mm.middleRows(3 * point, 3);
    rows.middleCols(model_.rank(), 3) = shift_prior_mm * Matrix3d::Identity();
    const Vector3d arm = placed_mm - about_mm;
    Matrix3d turn;
    turn << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    rows.rightCols(3) = turn_prior * turn;
    return rows;
  }

  [[nodiscard]] Posterior solve(const std::vector<Pair>& pairs, const Eigen::Isometry3d& pose, const Vector3d& about_mm,
                                const Surface& placed, double noise_mm, double count_as) const {
    const Index unknowns = model_.rank() + motions;
    MatrixXd whitened(3 * static_cast<Index>(pairs.size()), unknowns);
    VectorXd right(whitened.rows());
    parallel_for(pairs.size(), 32, [&](std::size_t begin, std::size_t end) {
      MatrixXd rows(3, unknowns);
      for (std::size_t i = begin; i < end; ++i) {
        const Pair& pair = pairs[i];
        rows.setZero();
        Vector3d mean = Vector3d::Zero();
        double rest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const double weight = pair.weights[static_cast<Index>(c)];
          const auto point = static_cast<std::size_t>(pair.points[c]);
          rows += weight * rows_of(pair.points[c], pose, about_mm, placed.points_mm[point]);
          mean += weight * (pose * model_.mean.points_mm[point]);
          rest += weight * model_.residual_sd_mm[pair.points[c]];
        }
        // Across the surface the noise is that of the places and of what no mode follows; along it, wider.
        const double across = std::hypot(noise_mm, rest), along = std::hypot(options_.along_mm, rest);
        const Matrix3d flat = pair.normal * pair.normal.transpose();
        const Matrix3d whiten = std::sqrt(count_as) * (flat / across + (Matrix3d::Identity() - flat) / along);
        whitened.middleRows(3 * static_cast<Index>(i), 3) = whiten * rows;
        right.segment<3>(3 * static_cast<Index>(i)) = whiten * (pair.seen_mm - mean);
      }
    });
    MatrixXd precision = whitened.transpose() * whitened;
    precision.diagonal().array() += 1;
    const Eigen::LLT<MatrixXd> factor(precision);
    return {factor.solve(whitened.transpose() * right), factor.solve(MatrixXd::Identity(unknowns, unknowns))};
  }

 private:
  const ShapeModel& model_;
  const FitOptions& options_;
};

}  // namespace

Result<ShapeFit> fit_model(const ShapeModel& model, const Surface& seen, const FitOptions& options,
                           const Progress& progress) {
  if (auto good = geometry::check_surface(seen); !good) return failure(good.error());
  const Fitting fitting(model, options);
  const std::vector<Vector3d> seen_normals = geometry::point_normals(seen);
  const std::vector<std::size_t> some = some_of(seen.points_mm.size(), 1500);
  const double whole_mm2 = geometry::area_mm2(model.mean);
  const double independent = options.independent * std::min(1.0, geometry::area_mm2(seen) / whole_mm2);

  ShapeFit fit;
  fit.pose = options.pose.value_or(
      Eigen::Isometry3d(Eigen::Translation3d(geometry::mean_point_mm(seen) - geometry::mean_point_mm(model.mean))));
  fit.coefficients = VectorXd::Zero(model.rank());
  Posterior posterior;
  Vector3d about_mm;
  Surface placed;
  const auto place = [&] {
    placed = model.at(fit.coefficients);
    for (Vector3d& point : placed.points_mm) point = fit.pose * point;
  };
  place();
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(iteration) / options.iterations, GLISSON_TEXT("fitting the shape"));
    // From afar to near: what counts as a pair, and how well it is believed.
    const double eagerness = std::pow(0.8, iteration);
    const std::vector<Pair> pairs = pairs_of(placed, seen, seen_normals, some, 15 + 60 * eagerness);
    constexpr std::size_t fewest = 30;
    if (pairs.size() < fewest) {
      return failure(Error{"shapes-no-overlap",
                           GLISSON_TEXT("What is seen of the liver does not come to lie on the model anywhere."),
                           {},
                           GLISSON_TEXT("Look whether it is in the patient's frame (LPS, mm) and is a liver."),
                           {}});
    }
    about_mm = geometry::mean_point_mm(placed);
    const double count_as = std::min(1.0, independent / static_cast<double>(pairs.size()));
    posterior = fitting.solve(pairs, fit.pose, about_mm, placed, options.noise_mm + 10 * eagerness, count_as);
    fit.coefficients = posterior.mean.head(model.rank());
    const Vector3d shift = shift_prior_mm * posterior.mean.segment<3>(model.rank());
    const Vector3d turn = turn_prior * posterior.mean.tail<3>();
    Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
    if (turn.norm() > 1e-12) step.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    step.translation() = about_mm + shift - step.linear() * about_mm;
    fit.pose = step * fit.pose;
    const std::vector<Vector3d> before = placed.points_mm;
    place();
    double moved_mm = 0;
    for (std::size_t p = 0; p < before.size(); ++p) {
      moved_mm = std::max(moved_mm, (before[p] - placed.points_mm[p]).norm());
    }
    if (iteration > 20 && moved_mm < 0.05) break;
  }

  fit.surface = placed;
  fit.mean_square = model.rank() > 0 ? fit.coefficients.squaredNorm() / model.rank() : 0;
  // The volume's derivative by a point is a third of the area around it times its normal: half the sum of the crosses.
  std::vector<Vector3d> outward_mm2(placed.points_mm.size(), Vector3d::Zero());
  for (const auto& [a, b, c] : placed.triangles) {
    const auto at = [&](int point) { return placed.points_mm[static_cast<std::size_t>(point)]; };
    const Vector3d share = (at(b) - at(a)).cross(at(c) - at(a)) / 6;
    for (const int point : {a, b, c}) outward_mm2[static_cast<std::size_t>(point)] += share;
  }
  const std::size_t points = placed.points_mm.size();
  const auto rows_at = [&](std::size_t p) {
    return fitting.rows_of(static_cast<int>(p), fit.pose, about_mm, placed.points_mm[p]);
  };
  Eigen::RowVectorXd volume_row = Eigen::RowVectorXd::Zero(model.rank() + motions);
  for (std::size_t p = 0; p < points; ++p) volume_row += outward_mm2[p].transpose() * rows_at(p);
  fit.covariance_mm2.resize(points);
  fit.sd_mm.resize(points);
  parallel_for(points, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const MatrixXd rows = rows_at(p);
      const double rest = model.residual_sd_mm[static_cast<Index>(p)];
      fit.covariance_mm2[p] = rows * posterior.covariance * rows.transpose();
      fit.covariance_mm2[p].diagonal().array() += rest * rest;
      fit.sd_mm[p] = std::sqrt(fit.covariance_mm2[p].trace() / 3);
    }
  });
  fit.volume_ml = geometry::volume_mm3(placed) / 1000;
  fit.volume_sd_ml = std::sqrt((volume_row * posterior.covariance * volume_row.transpose()).value()) / 1000;
  const geometry::SurfaceDistance distance(placed);
  double sum = 0;
  for (const std::size_t point : some) sum += std::pow(distance.closest(seen.points_mm[point]).distance_mm, 2);
  fit.residual_mm = std::sqrt(sum / static_cast<double>(some.size()));
  return fit;
}

}  // namespace glisson::shapes
