#include "closedloop/palpation/internal/search.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>

#include "base/parallel.h"
#include "base/units.h"
#include "closedloop/palpation/internal/effects.h"

namespace glisson::closedloop {
namespace {

std::vector<Start> compliance_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const ResidualField& left, const PalpationStartOptions& options);
std::vector<Start> capsule_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                  const ResidualField& left, const PalpationStartOptions& options);
std::vector<Start> anisotropy_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const ResidualField& left, const PalpationStartOptions& options);
std::vector<Start> inclusion_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                    const ResidualField& left, const PalpationStartOptions& options);

Match match_response(const ResidualField& left, const Eigen::MatrixXd& response_change) {
  return match(left, response_change * left.amounts);
}

}  // namespace

Match match(const ResidualField& left, const Eigen::MatrixXd& change_mm) {
  const Eigen::MatrixXd change = change_mm.cwiseProduct(left.seen);
  const double along = change.cwiseProduct(left.residual_mm).sum(), size = change.squaredNorm();
  if (!(size > 0)) return {};
  return {along / size, along * along / size};
}

bool bends_with_the_load(const ResidualField& left, double noise_mm, const PalpationStartOptions& options) {
  double gain_mm2 = 0, looked_at = 0;
  for (Eigen::Index load = 0; load < left.amounts.rows(); ++load) {
    const double largest = left.amounts.row(load).cwiseAbs().maxCoeff();
    for (Eigen::Index row = 0; row < left.seen.rows() && largest > 0; ++row) {
      std::vector<Eigen::Index> shots;
      for (Eigen::Index s = 0; s < left.seen.cols(); ++s) {
        if (left.seen(row, s) > 0 && left.amounts(load, s) != 0) shots.push_back(s);
      }
      if (shots.size() < options.fewest_shots) continue;
      const Eigen::VectorXd amount = left.amounts.row(load)(shots).transpose() / largest;
      Eigen::MatrixXd line(amount.size(), 2);
      line << Eigen::VectorXd::Ones(amount.size()), amount;
      const Eigen::VectorXd square = amount.cwiseAbs2();
      const Eigen::VectorXd bend = square - line * line.colPivHouseholderQr().solve(square);
      if (bend.squaredNorm() < options.minimum_curvature) continue;
      const double along = bend.dot(left.residual_mm.row(row)(shots).transpose());
      gain_mm2 += along * along / bend.squaredNorm();
      looked_at += 1;
    }
  }
  return gain_mm2 > noise_mm * noise_mm * (looked_at + options.bend_in_deviations * std::sqrt(2 * looked_at));
}

std::vector<Start> palpation_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                    const ResidualField& left, const PalpationStartOptions& options) {
  if (effect.kind == palpation::support_compliance) return compliance_starts(effect, solver, state, left, options);
  if (effect.kind == palpation::capsule) return capsule_starts(effect, solver, state, left, options);
  if (effect.kind == palpation::anisotropy) return anisotropy_starts(effect, solver, state, left, options);
  if (effect.kind == palpation::stiff_inclusion) return inclusion_starts(effect, solver, state, left, options);
  return {};
}

namespace {

double clamped(double value, const Parameter& parameter) { return std::clamp(value, parameter.lower, parameter.upper); }

Eigen::VectorXd one(double value) { return Eigen::VectorXd::Constant(1, value); }

// Springs as soft as usual, as a measure: what they change, and how much of that is left over.
std::vector<Start> compliance_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const ResidualField& left, const PalpationStartOptions& options) {
  Structure soft = state.scaled_structure();
  const double usual = 1.0 / effect.starts.front()[0];
  soft.compliance_mm_per_kPa += usual * state.stiffness_factor;
  const auto before = solver.at_markers(state.scaled_structure());
  const auto after = solver.at_markers(soft);
  if (!before || !after) return {};
  const Match found = match_response(left, *after - *before);
  const double compliance = usual * std::clamp(found.amount, options.minimum_compliance, options.maximum_compliance);
  return {{one(clamped(1.0 / compliance, effect.parameters[0])), found.gain_mm2}};
}

std::vector<Start> capsule_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                  const ResidualField& left, const PalpationStartOptions& options) {
  const auto slope = solver.derivatives_at_markers(state.scaled_structure(), {StructureParameter::capsule});
  if (!slope) return {};
  const Match found = match_response(left, slope->front());
  const double minimum = options.minimum_capsule * effect.starts.front()[0];
  const double size_N_per_mm = std::max(minimum, units::N_from_mN(found.amount * state.stiffness_factor));
  return {{one(clamped(size_N_per_mm, effect.parameters[0])), found.gain_mm2}};
}

// The axes of a cube through its faces, edges and corners: none is further than 27 degrees from any direction.
std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> all;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const bool first_of_pair = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
        if (first_of_pair) all.push_back(Eigen::Vector3d(x, y, z).normalized());
      }
    }
  }
  return all;
}

std::vector<Start> anisotropy_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const ResidualField& left, const PalpationStartOptions& options) {
  const Structure structure = state.scaled_structure();
  const auto solution = solver.solution(structure);
  if (!solution) return {};
  const Eigen::MatrixXd& u_mm = (*solution)->u_mm;
  const auto axes = directions();
  const mechanics::AnisotropyLaw law = effect.form == palpation::form_engineering
                                           ? mechanics::AnisotropyLaw::engineering
                                           : mechanics::AnisotropyLaw::fibres;
  Eigen::MatrixXd forces_mN(u_mm.rows(), u_mm.cols() * static_cast<Eigen::Index>(axes.size()));
  parallel_for(static_cast<std::size_t>(forces_mN.cols()), 1, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<Eigen::Index>(begin); c < static_cast<Eigen::Index>(end); ++c) {
      Structure anisotropic = structure;
      anisotropic.anisotropy = mechanics::TransverseIsotropy{law, axes[static_cast<std::size_t>(c / u_mm.cols())], 1.0};
      forces_mN.col(c) = -stiffness_derivative(solver.specimen(), anisotropic, StructureParameter::anisotropy_ratio,
                                               u_mm.col(c % u_mm.cols()));
    }
  });
  const Eigen::MatrixXd changes = solver.markers().at_places(PalpationSolver::solve(**solution, forces_mN));
  std::vector<Match> matches;
  std::vector<std::size_t> order(axes.size());
  for (std::size_t a = 0; a < axes.size(); ++a) {
    matches.push_back(
        match_response(left, changes.middleCols(static_cast<Eigen::Index>(a) * u_mm.cols(), u_mm.cols())));
  }
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return matches[a].gain_mm2 > matches[b].gain_mm2; });
  std::vector<Start> starts;
  for (const std::size_t a : order) {
    if (starts.size() == options.maximum_axes ||
        matches[a].gain_mm2 < options.worth_of_axis * matches[order.front()].gain_mm2)
      break;
    Eigen::VectorXd start(4);
    start << axes[a],
        clamped(std::clamp(std::exp(matches[a].amount), options.minimum_fibre_ratio, options.maximum_fibre_ratio),
                effect.parameters[3]);
    const double away = options.away_from_isotropic;
    if (std::abs(start[3] - 1.0) < away) start[3] = matches[a].amount > 0 ? 1 + away : 1 - away;
    starts.push_back({std::move(start), matches[a].gain_mm2});
  }
  return starts;
}

// The influence of a relative change of each cell's modulus on the markers, for each unit load: -(strain that a unit
// force at the marker makes) : (stress that the load makes), times the cell's volume.
struct Influence {
  std::vector<Eigen::Index> rows;  // of the markers' displacements, as many as are looked at
  std::vector<Eigen::Index> loads;
  std::vector<Eigen::MatrixXf> of_cell;  // rows x loads
};
Influence influence(const PalpationSolver& solver, const PalpationSolver::Solution& solution, const ResidualField& left,
                    Eigen::Index maximum_places);

struct Ball {
  Eigen::Vector3d center_mm;
  double radius_mm = 0;  // 0: not matched
  Match match;
};

std::vector<Start> inclusion_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                    const ResidualField& left, const PalpationStartOptions& options) {
  const auto solution = solver.solution(state.scaled_structure());
  if (!solution) return {};
  const Influence on = influence(solver, **solution, left, options.maximum_places);
  const auto rows = static_cast<Eigen::Index>(on.rows.size()), loads = static_cast<Eigen::Index>(on.loads.size());
  if (rows == 0 || loads == 0) return {};

  // Of each row, over the shots that saw it: residual times loads, and loads times loads.
  const Eigen::MatrixXd amounts = left.amounts(on.loads, Eigen::all);
  Eigen::MatrixXd residual_by_load(rows, loads);
  std::vector<Eigen::MatrixXd> load_by_load;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const Eigen::RowVectorXd seen = left.seen.row(on.rows[static_cast<std::size_t>(r)]);
    residual_by_load.row(r) = left.residual_mm.row(on.rows[static_cast<std::size_t>(r)]) * amounts.transpose();
    load_by_load.emplace_back(amounts * seen.asDiagonal() * amounts.transpose());
  }
  const auto match_of = [&](const Eigen::MatrixXd& change) {
    const double along = change.cwiseProduct(residual_by_load).sum();
    double size = 0;
    for (Eigen::Index r = 0; r < rows; ++r) {
      size += change.row(r) * load_by_load[static_cast<std::size_t>(r)] * change.row(r).transpose();
    }
    return size > 0 ? Match{along / size, along * along / size} : Match{};
  };

  // Spheres about the centroids of cells, spread evenly.
  const geometry::TetMesh& mesh = solver.specimen().body.mesh;
  const double largest_mm = effect.parameters[3].upper, smallest_mm = effect.parameters[3].lower;
  std::vector<Eigen::Vector3d> centroids;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) centroids.push_back(geometry::cell_centroid_mm(mesh, c));
  std::vector<Ball> balls;
  const double spacing_mm = options.ball_spacing * largest_mm;
  for (const Eigen::Vector3d& centroid : centroids) {
    const bool apart = std::all_of(balls.begin(), balls.end(), [&](const Ball& other) {
      return (other.center_mm - centroid).squaredNorm() > spacing_mm * spacing_mm;
    });
    if (apart) balls.push_back({centroid, 0, {}});
  }
  const auto worth_mm2 = [&](const Ball& ball) {
    return ball.match.amount > 0 ? ball.match.gain_mm2 : options.worth_if_soft * ball.match.gain_mm2;
  };
  parallel_for(balls.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (const double share : options.ball_radii) {
        const double radius_mm = std::max(smallest_mm, share * largest_mm);
        Eigen::MatrixXf sum = Eigen::MatrixXf::Zero(rows, loads);
        for (std::size_t c = 0; c < centroids.size(); ++c) {
          if ((centroids[c] - balls[b].center_mm).squaredNorm() < radius_mm * radius_mm) sum += on.of_cell[c];
        }
        const Ball ball{balls[b].center_mm, radius_mm, match_of(sum.cast<double>())};
        if (worth_mm2(ball) > worth_mm2(balls[b])) balls[b] = ball;
      }
    }
  });
  std::sort(balls.begin(), balls.end(), [&](const Ball& a, const Ball& b) { return worth_mm2(a) > worth_mm2(b); });
  std::vector<Ball> best;
  for (const Ball& ball : balls) {
    if (best.size() == options.maximum_balls || ball.radius_mm == 0 ||
        worth_mm2(ball) < options.worth_of_ball * worth_mm2(balls.front()))
      break;
    const bool apart = std::all_of(best.begin(), best.end(), [&](const Ball& other) {
      return (other.center_mm - ball.center_mm).norm() > std::max(other.radius_mm, ball.radius_mm);
    });
    if (apart) best.push_back(ball);
  }
  std::vector<Start> starts;
  for (const Ball& ball : best) {
    Eigen::VectorXd start(5);
    const double ratio = std::exp(std::clamp(ball.match.amount, options.minimum_log_ratio, options.maximum_log_ratio));
    start << ball.center_mm, clamped(ball.radius_mm, effect.parameters[3]),
        clamped(ball.match.amount > 0 ? std::max(options.stiff_from, ratio) : std::min(options.soft_to, ratio),
                effect.parameters[4]);
    for (int d = 0; d < 3; ++d) start[d] = clamped(start[d], effect.parameters[static_cast<std::size_t>(d)]);
    starts.push_back({std::move(start), ball.match.gain_mm2});
  }
  return starts;
}

// Places that tell most: up to `most` of those seen, spread evenly.
std::vector<Eigen::Index> places_looked_at(const ResidualField& left, Eigen::Index maximum) {
  std::vector<Eigen::Index> seen;
  for (Eigen::Index p = 0; p < left.seen.rows() / 3; ++p) {
    if (left.seen.row(3 * p).maxCoeff() > 0) seen.push_back(p);
  }
  const auto count = static_cast<Eigen::Index>(seen.size());
  if (count <= maximum) return seen;
  std::vector<Eigen::Index> spread;
  for (Eigen::Index i = 0; i < maximum; ++i) spread.push_back(seen[static_cast<std::size_t>(i * count / maximum)]);
  return spread;
}

Influence influence(const PalpationSolver& solver, const PalpationSolver::Solution& solution, const ResidualField& left,
                    Eigen::Index maximum_places) {
  Influence on;
  for (const Eigen::Index place : places_looked_at(left, maximum_places)) {
    for (int d = 0; d < 3; ++d) on.rows.push_back(3 * place + d);
  }
  for (Eigen::Index l = 0; l < left.amounts.rows(); ++l) {
    if (left.amounts.row(l).cwiseAbs().maxCoeff() > 0) on.loads.push_back(l);
  }
  const auto rows = static_cast<Eigen::Index>(on.rows.size()), loads = static_cast<Eigen::Index>(on.loads.size());
  Eigen::MatrixXd unit_forces_mN = Eigen::MatrixXd::Zero(solution.u_mm.rows(), rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    solver.markers().add_transposed(on.rows[static_cast<std::size_t>(r)], 1.0, unit_forces_mN.col(r));
  }
  const Eigen::MatrixXd adjoint_mm = PalpationSolver::solve(solution, unit_forces_mN);

  // The strain of a quadratic cell is linear: its mean, at the centroid, stands for it here.
  const SpecimenBody& specimen = solver.specimen();
  const Elements& elements = specimen.elements;
  const mechanics::Matrix9d tangent = unit_tangent(specimen, solution.structure);
  const std::vector<double> factors = modulus_factors(specimen, solution.structure);
  on.of_cell.resize(elements.cells.size());
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
      Eigen::Matrix<float, Eigen::Dynamic, 9> adjoint(rows, 9);
      for (Eigen::Index r = 0; r < rows; ++r) {
        adjoint.row(r) = gradient_of(adjoint_mm.col(r)).template cast<float>();
      }
      Eigen::Matrix<float, 9, Eigen::Dynamic> stress(9, loads);
      for (Eigen::Index l = 0; l < loads; ++l) {
        stress.col(l) =
            (-stiffness_mN_mm * (tangent * gradient_of(solution.u_mm.col(on.loads[static_cast<std::size_t>(l)]))))
                .template cast<float>();
      }
      on.of_cell[c] = adjoint * stress;
    }
  });
  return on;
}

}  // namespace
}  // namespace glisson::closedloop
