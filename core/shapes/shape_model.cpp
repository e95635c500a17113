#include "shapes/shape_model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "base/noise.h"
#include "base/parallel.h"
#include "registration/rigid.h"

namespace glisson::shapes {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Surface;

namespace {

// Places as one column.
VectorXd column_of(const Surface& surface) {
  VectorXd column(3 * static_cast<Index>(surface.points_mm.size()));
  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    column.segment<3>(3 * static_cast<Index>(p)) = surface.points_mm[p];
  }
  return column;
}

void place(const VectorXd& column, Surface& surface) {
  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    surface.points_mm[p] = column.segment<3>(3 * static_cast<Index>(p));
  }
}

// The principal components of the shapes that are kept: their directions, unit vectors, and variances, the largest
// first. By the matrix of products between livers, which are far fewer than points.
struct Components {
  VectorXd mean;
  MatrixXd directions;
  VectorXd variances;
};
Components components_of(const MatrixXd& shapes, const std::vector<int>& left_out) {
  std::vector<Index> kept;
  for (Index i = 0; i < shapes.cols(); ++i) {
    if (std::find(left_out.begin(), left_out.end(), static_cast<int>(i)) == left_out.end()) kept.push_back(i);
  }
  MatrixXd differences(shapes.rows(), static_cast<Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) differences.col(static_cast<Index>(i)) = shapes.col(kept[i]);
  Components found;
  found.mean = differences.rowwise().mean();
  differences.colwise() -= found.mean;
  const auto freedom = static_cast<double>(kept.size() - 1);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(differences.transpose() * differences / freedom);
  const double negligible = 1e-10 * std::max(solver.eigenvalues().maxCoeff(), 1e-30);
  std::vector<Index> used;
  for (Index k = solver.eigenvalues().size() - 1; k >= 0 && used.size() + 1 < kept.size(); --k) {
    if (solver.eigenvalues()[k] > negligible) used.push_back(k);
  }
  found.directions.resize(shapes.rows(), static_cast<Index>(used.size()));
  found.variances.resize(static_cast<Index>(used.size()));
  for (std::size_t k = 0; k < used.size(); ++k) {
    const auto to = static_cast<Index>(k);
    found.variances[to] = solver.eigenvalues()[used[k]];
    found.directions.col(to) =
        differences * solver.eigenvectors().col(used[k]) / std::sqrt(freedom * found.variances[to]);
  }
  return found;
}

double mean_point_distance(const VectorXd& difference) {
  return Eigen::Map<const Eigen::Matrix3Xd>(difference.data(), 3, difference.size() / 3).colwise().norm().mean();
}

}  // namespace

Surface ShapeModel::at(const VectorXd& coefficients) const {
  Surface surface = mean;
  place(column_of(mean) + modes_mm * coefficients, surface);
  return surface;
}

Result<AlignedShapes> align_shapes(const std::vector<Surface>& corresponding) {
  constexpr std::size_t fewest = 4;
  if (corresponding.size() < fewest) {
    return failure("shapes-too-few", GLISSON_TEXT("A shape model needs {0} shapes or more; there are {1}."),
                   {std::to_string(fewest), std::to_string(corresponding.size())});
  }
  const std::size_t points = corresponding.front().points_mm.size();
  for (const Surface& surface : corresponding) {
    if (surface.points_mm.size() == points && surface.triangles == corresponding.front().triangles) continue;
    return failure("shapes-do-not-correspond", GLISSON_TEXT("The shapes have different points or triangles."));
  }
  AlignedShapes aligned{corresponding.front(), MatrixXd(3 * static_cast<Index>(points), 0)};
  aligned.shapes_mm.resize(3 * static_cast<Index>(points), static_cast<Index>(corresponding.size()));
  constexpr int rounds = 6;  // the mean moves by less than 0.01 mm in the last
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < corresponding.size(); ++i) {
      const auto motion = registration::align_points(corresponding[i].points_mm, aligned.topology.points_mm);
      if (!motion) return failure(motion.error());
      aligned.shapes_mm.col(static_cast<Index>(i)) = column_of(registration::moved(corresponding[i], *motion));
    }
    place(aligned.shapes_mm.rowwise().mean(), aligned.topology);
  }
  aligned.topology.point_fields.clear();
  aligned.topology.cell_fields.clear();
  return aligned;
}

ShapeModel model_of(const AlignedShapes& shapes, int rank, const std::vector<int>& left_out) {
  Components all = components_of(shapes.shapes_mm, left_out);
  const Index modes = rank > 0 ? std::min<Index>(rank, all.variances.size()) : all.variances.size();
  ShapeModel model;
  model.mean = shapes.topology;
  place(all.mean, model.mean);
  model.modes_mm = all.directions.leftCols(modes) * all.variances.head(modes).cwiseSqrt().asDiagonal();
  model.residual_sd_mm = VectorXd::Zero(static_cast<Index>(model.mean.points_mm.size()));
  model.livers = static_cast<int>(shapes.shapes_mm.cols()) - static_cast<int>(left_out.size());
  return model;
}

RanksJudged judge_ranks(const AlignedShapes& shapes, const Progress& progress) {
  const Index livers = shapes.shapes_mm.cols(), rows = shapes.shapes_mm.rows();
  const Index ranks = livers - 2;  // one is left out, one is the mean's
  MatrixXd distance(ranks, livers), squared(ranks, livers);
  std::vector<Eigen::MatrixXf> rest_mm2(static_cast<std::size_t>(livers));  // points x ranks
  parallel_for(static_cast<std::size_t>(livers), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      rest_mm2[i] = Eigen::MatrixXf::Zero(rows / 3, ranks);
      if (progress.cancelled()) continue;
      const auto column = static_cast<Index>(i);
      const Components from = components_of(shapes.shapes_mm, {static_cast<int>(i)});
      VectorXd rest = shapes.shapes_mm.col(column) - from.mean;
      for (Index k = 0; k < ranks; ++k) {
        squared(k, column) = 1;
        if (k < from.variances.size()) {
          const double along = from.directions.col(k).dot(rest);
          rest -= along * from.directions.col(k);
          squared(k, column) = along * along / from.variances[k];
        }
        distance(k, column) = mean_point_distance(rest);
        rest_mm2[i].col(k) = (Eigen::Map<const Eigen::Matrix3Xd>(rest.data(), 3, rows / 3).colwise().squaredNorm() / 3)
                                 .transpose()
                                 .cast<float>();
      }
    }
  });
  const Components all = components_of(shapes.shapes_mm, {});
  RanksJudged judged;
  const double best_mm = distance.rowwise().mean().minCoeff();
  for (Index k = 0; k < ranks; ++k) {
    const Index held = std::min(k + 1, all.variances.size());
    judged.by_modes.push_back({static_cast<int>(k) + 1, all.variances.head(held).sum() / all.variances.sum(),
                               distance.row(k).mean(), squared.row(k).mean()});
    if (judged.rank == 0 && distance.row(k).mean() <= 1.02 * best_mm) judged.rank = static_cast<int>(k) + 1;
  }
  judged.squared_coefficients = squared.topRows(judged.rank);
  judged.rest_mm2.resize(rows / 3, livers);
  for (Index i = 0; i < livers; ++i) {
    judged.rest_mm2.col(i) = rest_mm2[static_cast<std::size_t>(i)].col(judged.rank - 1).cast<double>();
  }
  return judged;
}

ShapeModel calibrated(ShapeModel model, const RanksJudged& judged, int without) {
  VectorXd weights = VectorXd::Ones(judged.rest_mm2.cols());
  if (without >= 0) weights[without] = 0;
  weights /= weights.sum();
  model.residual_sd_mm = (judged.rest_mm2 * weights).cwiseSqrt();
  const VectorXd shown = judged.squared_coefficients * weights;
  constexpr Index beside = 3;
  for (Index k = 0; k < std::min<Index>(model.rank(), shown.size()); ++k) {
    const Index first = std::max<Index>(0, k - beside), last = std::min<Index>(shown.size() - 1, k + beside);
    model.modes_mm.col(k) *= std::sqrt(std::max(1e-3, shown.segment(first, last - first + 1).mean()));
  }
  return model;
}

double specificity_mm(const ShapeModel& model, const AlignedShapes& shapes, int draws, std::uint64_t seed) {
  const VectorXd mean = column_of(model.mean);
  VectorXd nearest_mm(draws);
  parallel_for(static_cast<std::size_t>(draws), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t draw = begin; draw < end; ++draw) {
      VectorXd coefficients(model.rank());
      for (Index k = 0; k < coefficients.size(); ++k) {
        coefficients[k] = normal_pair(mixed(seed, draw), static_cast<std::uint64_t>(k)).x();
      }
      const VectorXd drawn = mean + model.modes_mm * coefficients;
      double nearest = std::numeric_limits<double>::max();
      for (Index i = 0; i < shapes.shapes_mm.cols(); ++i) {
        nearest = std::min(nearest, mean_point_distance(drawn - shapes.shapes_mm.col(i)));
      }
      nearest_mm[static_cast<Index>(draw)] = nearest;
    }
  });
  return nearest_mm.mean();
}

Result<ShapeModel> honest_model(const std::vector<Surface>& corresponding, const Progress& progress) {
  const auto aligned = align_shapes(corresponding);
  if (!aligned) return failure(aligned.error());
  const RanksJudged judged = judge_ranks(*aligned, progress);
  if (progress.cancelled()) return cancelled();
  return calibrated(model_of(*aligned, judged.rank), judged);
}

}  // namespace glisson::shapes
