#include "closedloop/palpation/internal/ball_search.h"

#include <algorithm>

#include "base/parallel.h"

namespace glisson::closedloop {
namespace {

Match match_of(const Eigen::MatrixXd& change, const SeenNumbers& seen) {
  const double along = change.cwiseProduct(seen.residual_by_load).sum();
  double size = 0;
  for (Eigen::Index n = 0; n < change.rows(); ++n) {
    size += change.row(n) * seen.load_by_load[static_cast<std::size_t>(n)] * change.row(n).transpose();
  }
  return size > 0 ? Match{along / size, along * along / size} : Match{};
}

std::vector<Eigen::Vector3d> spread(const std::vector<Eigen::Vector3d>& places_mm, double spacing_mm) {
  std::vector<Eigen::Vector3d> chosen;
  for (const Eigen::Vector3d& place : places_mm) {
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const Eigen::Vector3d& other) {
      return (other - place).squaredNorm() > spacing_mm * spacing_mm;
    });
    if (apart) chosen.push_back(place);
  }
  return chosen;
}

}  // namespace

std::vector<FoundBall> promising_balls(const PartsInfluence& parts, const SeenNumbers& seen, double smallest_mm,
                                       double largest_mm, double worth_if_negative, const BallSearchOptions& options) {
  std::vector<FoundBall> balls;
  for (const Eigen::Vector3d& center_mm : spread(parts.centroids_mm, options.spacing * largest_mm))
    balls.push_back({center_mm, 0, {}});
  const auto worth = [&](const FoundBall& ball) {
    return ball.match.amount > 0 ? ball.match.gain : worth_if_negative * ball.match.gain;
  };
  parallel_for(balls.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (const double share : options.radii) {
        const double radius_mm = std::max(smallest_mm, share * largest_mm);
        Eigen::MatrixXf sum = Eigen::MatrixXf::Zero(seen.residual_by_load.rows(), seen.residual_by_load.cols());
        for (std::size_t p = 0; p < parts.centroids_mm.size(); ++p) {
          if ((parts.centroids_mm[p] - balls[b].center_mm).squaredNorm() < radius_mm * radius_mm)
            sum += parts.of_part[p];
        }
        const FoundBall ball{balls[b].center_mm, radius_mm, match_of(sum.cast<double>(), seen)};
        if (worth(ball) > worth(balls[b])) balls[b] = ball;
      }
    }
  });
  std::sort(balls.begin(), balls.end(), [&](const FoundBall& a, const FoundBall& b) { return worth(a) > worth(b); });
  std::vector<FoundBall> best;
  for (const FoundBall& ball : balls) {
    if (best.size() == options.maximum_balls || ball.radius_mm == 0 ||
        worth(ball) < options.worth_of_ball * worth(balls.front()))
      break;
    const bool apart = std::all_of(best.begin(), best.end(), [&](const FoundBall& other) {
      return (other.center_mm - ball.center_mm).norm() > std::max(other.radius_mm, ball.radius_mm);
    });
    if (apart) best.push_back(ball);
  }
  return best;
}

// -(strain that a unit force at the number makes) : (stress that the load makes), times the cell's volume. The strain
// of a quadratic cell is linear: its mean, at the centroid, stands for it here.
PartsInfluence influence_of_cells(const PalpationSolver& solver, const PalpationSolver::Solution& solution,
                                  const SeenNumbers& seen) {
  const SpecimenBody& specimen = solver.specimen();
  const Elements& elements = specimen.elements;
  const auto numbers = seen.weights.cols(), loads = static_cast<Eigen::Index>(seen.loads.size());
  const Eigen::MatrixXd adjoint_mm = PalpationSolver::solve(solution, seen.weights);
  const mechanics::Matrix9d tangent = unit_tangent(specimen, solution.structure);
  const std::vector<double> factors = modulus_factors(specimen, solution.structure);
  PartsInfluence influence;
  for (std::size_t c = 0; c < elements.cells.size(); ++c)
    influence.centroids_mm.push_back(geometry::cell_centroid_mm(specimen.body.mesh, c));
  influence.of_part.resize(elements.cells.size());
  parallel_for(elements.cells.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      Elements::Gradients gradients = Elements::Gradients::Zero();
      double stiffness_mN_mm = 0;  // modulus times volume
      for (std::size_t p = c * Elements::points_per_cell; p < (c + 1) * Elements::points_per_cell; ++p) {
        gradients += elements.points[p].gradients / Elements::points_per_cell;
        stiffness_mN_mm += specimen.body.youngs_kPa[c] * factors[p] * elements.points[p].volume_mm3;
      }
      const auto gradient_of = [&](const auto& u_mm) {
        Elements::Gradients moved;
        for (int i = 0; i < 10; ++i) moved.col(i) = u_mm.template segment<3>(3 * elements.cells[c][i]);
        return mechanics::as_vector((moved * gradients.transpose()).eval());
      };
      Eigen::Matrix<float, Eigen::Dynamic, 9> adjoint(numbers, 9);
      for (Eigen::Index n = 0; n < numbers; ++n) {
        adjoint.row(n) = gradient_of(adjoint_mm.col(n)).template cast<float>();
      }
      Eigen::Matrix<float, 9, Eigen::Dynamic> stress(9, loads);
      for (Eigen::Index l = 0; l < loads; ++l) {
        stress.col(l) =
            (-stiffness_mN_mm * (tangent * gradient_of(solution.u_mm.col(seen.loads[static_cast<std::size_t>(l)]))))
                .template cast<float>();
      }
      influence.of_part[c] = adjoint * stress;
    }
  });
  return influence;
}

// -(displacement that a unit force at the number makes) . (force of the springs under the load), over the face.
PartsInfluence influence_of_faces(const PalpationSolver& solver, const PalpationSolver::Solution& solution,
                                  const SeenNumbers& seen) {
  const mechanics::Body& body = solver.specimen().body;
  const std::vector<std::uint8_t>& fixed = fixed_unknowns(solver.specimen(), solution.structure);
  const Eigen::MatrixXd adjoint_mm = PalpationSolver::solve(solution, seen.weights);
  const Eigen::MatrixXd u_mm = solution.u_mm(Eigen::all, seen.loads);
  PartsInfluence influence;
  for (std::size_t f = 0; f < body.boundary.size(); ++f) {
    const auto& nodes = body.boundary[f].nodes;
    const bool held = std::all_of(nodes.begin(), nodes.end(),
                                  [&](int node) { return fixed[static_cast<std::size_t>(3 * node)] != 0; });
    if (held) continue;
    const Eigen::Matrix<double, 6, 6> springs = whole_face(body, f).springs;
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(seen.weights.cols(), u_mm.cols());
    for (int d = 0; d < 3; ++d) {
      std::array<Eigen::Index, 6> unknowns{};
      for (std::size_t i = 0; i < 6; ++i) unknowns[i] = 3 * nodes[i] + d;
      change -= adjoint_mm(unknowns, Eigen::all).transpose() * springs * u_mm(unknowns, Eigen::all);
    }
    influence.centroids_mm.push_back(body.boundary[f].centroid_mm);
    influence.of_part.emplace_back(change.cast<float>());
  }
  return influence;
}

}  // namespace glisson::closedloop
