#include "closedloop/guidance/internal/grouped_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace glisson::closedloop {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_numbers = 180;  // as a palpation's search looks at: 60 places of three coordinates

// Frames under the same loads, up to their size.
struct LoadPattern {
  Eigen::VectorXd amounts;  // the largest is 1
  std::vector<Eigen::Index> shots;
};
std::vector<LoadPattern> patterns_of(const Eigen::MatrixXd& amounts);

// Places of rows of one direction, far from each other; each row belongs to the nearest.
std::vector<Vector3d> spread(const std::vector<Vector3d>& places_mm, std::size_t count);
std::size_t nearest(const std::vector<Vector3d>& seeds_mm, const Vector3d& place_mm);

}  // namespace

SeenNumbers grouped_rows(const std::vector<SeenRow>& rows, const Observations& observations,
                         const Eigen::VectorXd& residual, const Eigen::MatrixXd& amounts, const Eigen::Matrix3d& turn,
                         const PalpationSolver& solver) {
  const std::vector<LoadPattern> patterns = patterns_of(amounts);
  SeenNumbers seen;
  for (Eigen::Index l = 0; l < amounts.rows(); ++l) {
    if (amounts.row(l).cwiseAbs().maxCoeff() > 0) seen.loads.push_back(l);
  }
  if (patterns.empty()) return seen;
  std::vector<std::size_t> pattern_of(static_cast<std::size_t>(amounts.cols()), patterns.size());
  for (std::size_t p = 0; p < patterns.size(); ++p) {
    for (const Eigen::Index shot : patterns[p].shots) pattern_of[static_cast<std::size_t>(shot)] = p;
  }
  const auto place_of = [&](std::size_t r) -> Vector3d {
    return observations.place_mm.row(static_cast<Eigen::Index>(r)).transpose();
  };
  std::vector<std::vector<Vector3d>> places_mm(observations.directions.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    places_mm[static_cast<std::size_t>(observations.direction[r])].push_back(place_of(r));
  std::vector<std::vector<Vector3d>> seeds_mm;
  for (const auto& of_direction : places_mm) {
    const std::size_t share = most_numbers * of_direction.size() / (rows.size() * patterns.size());
    seeds_mm.push_back(spread(of_direction, std::max<std::size_t>(1, share)));
  }

  struct Number {
    Eigen::VectorXd weights;
    std::size_t pattern = 0;
    double left = 0, square = 0;
  };
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Number> numbers;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    const std::size_t pattern = pattern_of[static_cast<std::size_t>(rows[r].shot)];
    if (pattern == patterns.size() || !std::isfinite(residual[row])) continue;
    Eigen::Index largest = 0;
    patterns[pattern].amounts.cwiseAbs().maxCoeff(&largest);
    const double size = amounts(largest, rows[r].shot);
    const auto direction = static_cast<std::size_t>(observations.direction[r]);
    Number& number = numbers[{pattern, direction, nearest(seeds_mm[direction], place_of(r))}];
    if (number.weights.size() == 0) number.weights = Eigen::VectorXd::Zero(solver.loads_mN().rows());
    number.pattern = pattern;
    const double by = size / (observations.noise[row] * observations.noise[row]);
    number.left += by * residual[row];
    number.square += by * size;
    const Vector3d along = by * size * (turn.transpose() * rows[r].direction);
    for (std::size_t i = 0; i < 6; ++i) {
      const double weight = rows[r].weights[static_cast<Eigen::Index>(i)];
      if (weight == 0) continue;
      for (int d = 0; d < 3; ++d)
        solver.markers().add_transposed(3 * rows[r].places[i] + d, weight * along[d], number.weights);
    }
  }

  const auto count = static_cast<Eigen::Index>(numbers.size());
  seen.weights.resize(solver.loads_mN().rows(), count);
  seen.residual_by_load.resize(count, static_cast<Eigen::Index>(seen.loads.size()));
  Eigen::Index n = 0;
  for (const auto& [key, number] : numbers) {
    const double to_noise = 1 / std::sqrt(number.square);
    const Eigen::VectorXd of_pattern = patterns[number.pattern].amounts(seen.loads);
    seen.weights.col(n) = to_noise * number.weights;
    seen.residual_by_load.row(n) = to_noise * number.left * of_pattern.transpose();
    seen.load_by_load.emplace_back(of_pattern * of_pattern.transpose());
    ++n;
  }
  return seen;
}

namespace {

std::vector<LoadPattern> patterns_of(const Eigen::MatrixXd& amounts) {
  constexpr double same = 1e-6;
  std::vector<LoadPattern> patterns;
  for (Eigen::Index shot = 0; shot < amounts.cols(); ++shot) {
    Eigen::Index largest = 0;
    if (!(amounts.col(shot).cwiseAbs().maxCoeff(&largest) > 0))
      continue;  // an unloaded frame tells nothing of stiffness
    const Eigen::VectorXd shape = amounts.col(shot) / amounts(largest, shot);
    const auto known = std::find_if(patterns.begin(), patterns.end(), [&](const LoadPattern& pattern) {
      return (pattern.amounts - shape).cwiseAbs().maxCoeff() < same;
    });
    if (known == patterns.end()) {
      patterns.push_back({shape, {shot}});
    } else {
      known->shots.push_back(shot);
    }
  }
  return patterns;
}

std::vector<Vector3d> spread(const std::vector<Vector3d>& places_mm, std::size_t count) {
  std::vector<Vector3d> seeds;
  std::vector<double> gap(places_mm.size(), std::numeric_limits<double>::infinity());
  for (std::size_t next = 0; seeds.size() < count && !places_mm.empty();) {
    seeds.push_back(places_mm[next]);
    for (std::size_t p = 0; p < places_mm.size(); ++p)
      gap[p] = std::min(gap[p], (places_mm[p] - seeds.back()).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(gap.begin(), gap.end()) - gap.begin());
    if (gap[next] == 0) break;
  }
  return seeds;
}

std::size_t nearest(const std::vector<Vector3d>& seeds_mm, const Vector3d& place_mm) {
  const auto found = std::min_element(seeds_mm.begin(), seeds_mm.end(), [&](const Vector3d& a, const Vector3d& b) {
    return (a - place_mm).squaredNorm() < (b - place_mm).squaredNorm();
  });
  return static_cast<std::size_t>(found - seeds_mm.begin());
}

}  // namespace
}  // namespace glisson::closedloop
