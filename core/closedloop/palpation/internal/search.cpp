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
SeenNumbers seen_numbers(const PalpationSolver& solver, const ResidualField& left, Eigen::Index maximum_places);

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
  if (effect.kind == palpation::stiff_inclusion) {
    return inclusion_starts(effect, solver, state, seen_numbers(solver, left, options.maximum_places), options);
  }
  return {};
}

namespace {

double clamped(double value, const Parameter& parameter) { return std::clamp(value, parameter.lower, parameter.upper); }

Eigen::VectorXd one(double value) { return Eigen::VectorXd::Constant(1, value); }

// Springs as soft as usual, as a measure: what they change, and how much of that is left over.
std::vector<Start> compliance_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const ResidualField& left, const PalpationStartOptions& options) {
  const Eigen::VectorXd usual = effect.starts.front().cwiseInverse();
  Structure soft = state.scaled_structure();
  soft.compliance_mm_per_kPa += usual[0] * state.stiffness_factor;
  soft.sideways_compliance_mm_per_kPa += usual[usual.size() - 1] * state.stiffness_factor;
  const auto before = solver.at_markers(state.scaled_structure());
  const auto after = solver.at_markers(soft);
  if (!before || !after) return {};
  const Match found = match_response(left, *after - *before);
  const double amount = std::clamp(found.amount, options.minimum_compliance, options.maximum_compliance);
  Eigen::VectorXd start = (amount * usual).cwiseInverse();
  for (Eigen::Index p = 0; p < start.size(); ++p)
    start[p] = clamped(start[p], effect.parameters[static_cast<std::size_t>(p)]);
  return {{start, found.gain}};
}

std::vector<Start> capsule_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                  const ResidualField& left, const PalpationStartOptions& options) {
  const auto slope = solver.derivatives_at_markers(state.scaled_structure(), {StructureParameter::capsule});
  if (!slope) return {};
  const Match found = match_response(left, slope->front());
  const double minimum = options.minimum_capsule * effect.starts.front()[0];
  const double size_N_per_mm = std::max(minimum, units::N_from_mN(found.amount * state.stiffness_factor));
  return {{one(clamped(size_N_per_mm, effect.parameters[0])), found.gain}};
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
  const mechanics::AnisotropyLaw law = anisotropy_law(effect.form);
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
            [&](std::size_t a, std::size_t b) { return matches[a].gain > matches[b].gain; });
  std::vector<Start> starts;
  for (const std::size_t a : order) {
    if (starts.size() == options.maximum_axes || matches[a].gain < options.worth_of_axis * matches[order.front()].gain)
      break;
    Eigen::VectorXd start = effect.starts.front();
    start.head<3>() = axes[a];
    start[3] =
        clamped(std::clamp(std::exp(matches[a].amount), options.minimum_fibre_ratio, options.maximum_fibre_ratio),
                effect.parameters[3]);
    const double away = options.away_from_isotropic;
    if (std::abs(start[3] - 1.0) < away) start[3] = matches[a].amount > 0 ? 1 + away : 1 - away;
    starts.push_back({std::move(start), matches[a].gain});
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

// A number a coordinate of a place.
SeenNumbers seen_numbers(const PalpationSolver& solver, const ResidualField& left, Eigen::Index maximum_places) {
  SeenNumbers seen;
  std::vector<Eigen::Index> rows;
  for (const Eigen::Index place : places_looked_at(left, maximum_places)) {
    for (int d = 0; d < 3; ++d) rows.push_back(3 * place + d);
  }
  for (Eigen::Index l = 0; l < left.amounts.rows(); ++l) {
    if (left.amounts.row(l).cwiseAbs().maxCoeff() > 0) seen.loads.push_back(l);
  }
  const auto numbers = static_cast<Eigen::Index>(rows.size());
  seen.weights = Eigen::MatrixXd::Zero(solver.loads_mN().rows(), numbers);
  seen.residual_by_load.resize(numbers, static_cast<Eigen::Index>(seen.loads.size()));
  const Eigen::MatrixXd amounts = left.amounts(seen.loads, Eigen::all);
  for (Eigen::Index n = 0; n < numbers; ++n) {
    const Eigen::Index row = rows[static_cast<std::size_t>(n)];
    solver.markers().add_transposed(row, 1.0, seen.weights.col(n));
    const Eigen::RowVectorXd seen_in = left.seen.row(row);
    seen.residual_by_load.row(n) = left.residual_mm.row(row) * amounts.transpose();
    seen.load_by_load.emplace_back(amounts * seen_in.asDiagonal() * amounts.transpose());
  }
  return seen;
}

// Of an effect whose parameters are a ball's and a size, which follows from the amount that matches.
template <typename SizeOf>
std::vector<Start> ball_starts(const Effect& effect, const PartsInfluence& parts, const SeenNumbers& seen,
                               double worth_if_negative, const PalpationStartOptions& options, const SizeOf& size_of) {
  const Parameter &radius = effect.parameters[3], &size = effect.parameters[4];
  std::vector<Start> starts;
  for (const FoundBall& ball :
       promising_balls(parts, seen, radius.lower, radius.upper, worth_if_negative, options.balls)) {
    Eigen::VectorXd start(5);
    for (int d = 0; d < 3; ++d) start[d] = clamped(ball.center_mm[d], effect.parameters[static_cast<std::size_t>(d)]);
    start[3] = clamped(ball.radius_mm, radius);
    start[4] = clamped(size_of(ball.match.amount), size);
    starts.push_back({std::move(start), ball.match.gain});
  }
  return starts;
}

}  // namespace

std::vector<Start> inclusion_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                    const SeenNumbers& seen, const PalpationStartOptions& options) {
  const auto solution = solver.solution(state.scaled_structure());
  if (!solution || seen.weights.cols() == 0 || seen.loads.empty()) return {};
  const PartsInfluence cells = influence_of_cells(solver, **solution, seen);
  return ball_starts(effect, cells, seen, options.worth_if_soft, options, [&](double amount) {
    const double ratio = std::exp(std::clamp(amount, options.minimum_log_ratio, options.maximum_log_ratio));
    return amount > 0 ? std::max(options.stiff_from, ratio) : std::min(options.soft_to, ratio);
  });
}

std::vector<Start> attachment_starts(const Effect& effect, const PalpationSolver& solver, const PalpationState& state,
                                     const SeenNumbers& seen, const PalpationStartOptions& options) {
  const auto solution = solver.solution(state.scaled_structure());
  if (!solution || seen.weights.cols() == 0 || seen.loads.empty()) return {};
  const PartsInfluence faces = influence_of_faces(solver, **solution, seen);
  return ball_starts(effect, faces, seen, 0, options,
                     [&](double amount) { return options.stiffer_than_first_order * amount * state.stiffness_factor; });
}

}  // namespace glisson::closedloop
