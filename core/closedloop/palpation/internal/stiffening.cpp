#include "closedloop/palpation/internal/stiffening.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "closedloop/palpation/internal/stretch.h"

namespace glisson::closedloop {
namespace {

using mechanics::Matrix9d;
using mechanics::Vector9d;

// g and dg/dq. Beyond a thousandfold stiffness the law goes on with its slope there, so that a wild step of a search
// stays a number.
struct Growth {
  double factor;
  double slope;
};
Growth growth(const Stiffening& stiffening, double q) {
  q = std::max(q, 0.0);
  if (stiffening.law == StiffeningLaw::linear) {
    const double strain = std::sqrt(q + 1e-16);  // smooth at rest
    return {1.0 + stiffening.coefficient * strain, 0.5 * stiffening.coefficient / strain};
  }
  constexpr double largest = 7.0;
  const double exponent = stiffening.coefficient * q;
  if (exponent <= largest) return {std::exp(exponent), stiffening.coefficient * std::exp(exponent)};
  return {std::exp(largest) * (1.0 + exponent - largest), stiffening.coefficient * std::exp(largest)};
}

bool is_for_large_strain(StiffeningLaw law) { return law == StiffeningLaw::yeoh || law == StiffeningLaw::ogden; }

// One structure with its law: what a displacement meets.
class StiffeningBody {
 public:
  StiffeningBody(const SpecimenBody& specimen, const Structure& structure, const Stiffening& stiffening)
      : specimen_(specimen),
        structure_(structure),
        stiffening_(stiffening),
        factors_(modulus_factors(specimen, structure)),
        tangent_(unit_tangent(specimen, structure)) {
    if (!large_strain()) return;
    material_ = stretch_material(stiffening.law == StiffeningLaw::yeoh ? StretchLaw::yeoh : StretchLaw::ogden,
                                 stiffening.coefficient, specimen.body.options.poisson_ratio);
    tangent_ -= unit_tangent(specimen, {});  // what is left over is what the anisotropy adds
  }

  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::Ref<const Eigen::VectorXd>& u_mm) const {
    const auto small = [&](std::size_t c, std::size_t p, const Eigen::Matrix3d& gradient) {
      const Vector9d per_modulus = tangent_ * mechanics::as_vector(gradient);
      const double q = per_modulus.dot(mechanics::as_vector(gradient));
      return (modulus_kPa(c, p) * growth(stiffening_, q).factor * mechanics::as_matrix(per_modulus)).eval();
    };
    const auto large = [&](std::size_t c, std::size_t p, const Eigen::Matrix3d& gradient) {
      const Eigen::Matrix3d f = gradient + Eigen::Matrix3d::Identity();
      return (modulus_kPa(c, p) * (stress_of(principal_state(material_, f)) + added(gradient))).eval();
    };
    return surface_force_mN(specimen_, structure_, u_mm) + (large_strain()
                                                                ? internal_force_mN(specimen_.elements, u_mm, large)
                                                                : internal_force_mN(specimen_.elements, u_mm, small));
  }

  // What the tangent needs of a state, at every quadrature point: at small strain g and the stress's direction times
  // sqrt(2 g'); at large strain the principal frame.
  struct State {
    std::vector<double> factor;
    std::vector<Vector9d> rank_one;
    std::vector<PrincipalState> principal;
  };
  [[nodiscard]] State state(const Eigen::Ref<const Eigen::VectorXd>& u_mm) const {
    State state;
    if (large_strain()) {
      state.principal.resize(factors_.size());
    } else {
      state.factor.resize(factors_.size());
      state.rank_one.resize(factors_.size());
    }
    const auto note = [&](std::size_t c, std::size_t p, const Eigen::Matrix3d& gradient) {
      if (large_strain()) {
        state.principal[p] = principal_state(material_, gradient + Eigen::Matrix3d::Identity());
      } else {
        const Vector9d per_modulus = tangent_ * mechanics::as_vector(gradient);
        const Growth at = growth(stiffening_, per_modulus.dot(mechanics::as_vector(gradient)));
        state.factor[p] = modulus_kPa(c, p) * at.factor;
        state.rank_one[p] = std::sqrt(2.0 * modulus_kPa(c, p) * at.slope) * per_modulus;
      }
      return Eigen::Matrix3d::Zero().eval();
    };
    internal_force_mN(specimen_.elements, u_mm, note);
    return state;
  }
  [[nodiscard]] Eigen::VectorXd tangent_times(const State& state, const Eigen::Ref<const Eigen::VectorXd>& d_mm) const {
    const auto small = [&](std::size_t, std::size_t p, const Eigen::Matrix3d& gradient) {
      const Vector9d moved = mechanics::as_vector(gradient);
      const Vector9d change = state.factor[p] * (tangent_ * moved) + state.rank_one[p].dot(moved) * state.rank_one[p];
      return mechanics::as_matrix(change);
    };
    const auto large = [&](std::size_t c, std::size_t p, const Eigen::Matrix3d& gradient) {
      return (modulus_kPa(c, p) * (stress_change(state.principal[p], gradient) + added(gradient))).eval();
    };
    return surface_force_mN(specimen_, structure_, d_mm) + (large_strain()
                                                                ? internal_force_mN(specimen_.elements, d_mm, large)
                                                                : internal_force_mN(specimen_.elements, d_mm, small));
  }

 private:
  [[nodiscard]] bool large_strain() const { return is_for_large_strain(stiffening_.law); }
  [[nodiscard]] double modulus_kPa(std::size_t cell, std::size_t point) const {
    return specimen_.body.youngs_kPa[cell] * factors_[point];
  }
  [[nodiscard]] Eigen::Matrix3d added(const Eigen::Matrix3d& gradient) const {
    if (!structure_.anisotropy) return Eigen::Matrix3d::Zero();
    return mechanics::as_matrix(tangent_ * mechanics::as_vector(gradient));
  }

  const SpecimenBody& specimen_;
  const Structure& structure_;
  Stiffening stiffening_;
  std::vector<double> factors_;
  Matrix9d tangent_;
  StretchMaterial material_;
};

template <typename OfColumn>
void for_each_column(Eigen::Index columns, const OfColumn& of_column) {
  parallel_for(static_cast<std::size_t>(columns), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) of_column(static_cast<Eigen::Index>(c));
  });
}

// The linear specimen's factor as a preconditioner; what is held stays zero.
class Preconditioner {
 public:
  Preconditioner(const SpecimenBody& specimen, const PalpationSolver::Solution& linear) : linear_(linear) {
    const auto& is_fixed = fixed_unknowns(specimen, linear.structure);
    for (std::size_t i = 0; i < is_fixed.size(); ++i) {
      if (!is_fixed[i]) free_.push_back(static_cast<int>(i));
    }
  }
  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& forces) const {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
    if (linear_.system.factor()) moved(free_, Eigen::all) = linear_.system.factor()->solve(forces(free_, Eigen::all));
    return moved;
  }
  [[nodiscard]] Eigen::MatrixXd free_values(const Eigen::MatrixXd& forces) const {
    Eigen::MatrixXd kept = Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
    kept(free_, Eigen::all) = forces(free_, Eigen::all);
    return kept;
  }

 private:
  const PalpationSolver::Solution& linear_;
  std::vector<int> free_;
};

// Conjugate gradients on all columns in step, each with its own numbers; a column that is done stands still.
struct NewtonResult {
  Eigen::MatrixXd u;
  double worst = 0;  // relative residual
};
NewtonResult conjugate_gradients(const StiffeningBody& body, const Preconditioner& precondition,
                                 const std::vector<StiffeningBody::State>& states,
                                 const std::vector<Eigen::Index>& state_of_column, const Eigen::MatrixXd& forces,
                                 double relative_tolerance, int maximum_steps) {
  const Eigen::Index columns = forces.cols();
  Eigen::MatrixXd residual = precondition.free_values(forces);
  NewtonResult result{Eigen::MatrixXd::Zero(forces.rows(), columns)};
  const Eigen::VectorXd scale = residual.colwise().norm();
  Eigen::MatrixXd direction = precondition(residual), product(forces.rows(), columns);
  Eigen::VectorXd energy = residual.cwiseProduct(direction).colwise().sum();
  for (int step = 0; step < maximum_steps; ++step) {
    std::vector<int> going;
    result.worst = 0;
    for (Eigen::Index c = 0; c < columns; ++c) {
      const double relative = scale[c] > 0 ? residual.col(c).norm() / scale[c] : 0.0;
      result.worst = std::max(result.worst, relative);
      if (relative > relative_tolerance && energy[c] > 0) going.push_back(static_cast<int>(c));
    }
    if (going.empty()) return result;
    for_each_column(static_cast<Eigen::Index>(going.size()), [&](Eigen::Index i) {
      const Eigen::Index c = going[static_cast<std::size_t>(i)];
      const auto& state = states[static_cast<std::size_t>(state_of_column[static_cast<std::size_t>(c)])];
      product.col(c) = body.tangent_times(state, direction.col(c));
    });
    for (const Eigen::Index c : going) {
      const double curvature = direction.col(c).dot(product.col(c));
      if (!(curvature > 0)) {  // beyond what is stable: what was gained so far has to do
        energy[c] = 0;
        continue;
      }
      const double length = energy[c] / curvature;
      result.u.col(c) += length * direction.col(c);
      residual.col(c) -= length * product.col(c);
    }
    residual(Eigen::all, going) = precondition.free_values(residual(Eigen::all, going));
    const Eigen::MatrixXd next = precondition(residual(Eigen::all, going));
    for (std::size_t i = 0; i < going.size(); ++i) {
      const Eigen::Index c = going[i];
      const auto column = next.col(static_cast<Eigen::Index>(i));
      if (energy[c] == 0) continue;
      const double now = residual.col(c).dot(column);
      direction.col(c) = column + now / energy[c] * direction.col(c);
      energy[c] = now;
    }
  }
  return result;
}

Failure diverged() {
  return failure("stiffening-diverged",
                 GLISSON_TEXT("No equilibrium of a specimen that stiffens so strongly was found under these loads."));
}

std::vector<Eigen::Index> one_each(Eigen::Index columns) {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(columns));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

Eigen::VectorXd resisting_force_mN(const SpecimenBody& specimen, const Structure& structure,
                                   const Stiffening& stiffening, const Eigen::Ref<const Eigen::VectorXd>& u_mm) {
  return StiffeningBody(specimen, structure, stiffening).force_mN(u_mm);
}

Result<Eigen::MatrixXd> stiffened_equilibria(const SpecimenBody& specimen, const PalpationSolver::Solution& linear,
                                             const Stiffening& stiffening, const Eigen::MatrixXd& forces_mN,
                                             const Eigen::MatrixXd& start_mm, double tolerance) {
  constexpr int maximum_steps = 40, maximum_halvings = 12;
  const StiffeningBody body(specimen, linear.structure, stiffening);
  const Preconditioner precondition(specimen, linear);
  const Eigen::Index columns = forces_mN.cols();
  const auto residual_of = [&](const Eigen::MatrixXd& u_mm, const std::vector<int>& which) {
    Eigen::MatrixXd residual(forces_mN.rows(), static_cast<Eigen::Index>(which.size()));
    for_each_column(residual.cols(), [&](Eigen::Index i) {
      residual.col(i) = forces_mN.col(which[static_cast<std::size_t>(i)]) - body.force_mN(u_mm.col(i));
    });
    return precondition.free_values(residual);
  };

  Eigen::MatrixXd u_mm = precondition.free_values(start_mm);  // it may come from where other supports gave way
  std::vector<int> all(static_cast<std::size_t>(columns));
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixXd residual = residual_of(u_mm, all);
  // A linear start may turn cells inside out: a part of it does not.
  for (int halving = 0; halving < maximum_halvings && !residual.allFinite(); ++halving) {
    for (Eigen::Index c = 0; c < columns; ++c) {
      if (!residual.col(c).allFinite()) u_mm.col(c) *= 0.5;
    }
    residual = residual_of(u_mm, all);
  }
  const Eigen::VectorXd scale = precondition.free_values(forces_mN).colwise().norm();
  for (int step = 0; step < maximum_steps; ++step) {
    std::vector<int> going;
    double worst = 0;
    for (Eigen::Index c = 0; c < columns; ++c) {
      if (scale[c] == 0) continue;  // nothing loads it; it starts at rest
      const double relative = residual.col(c).norm() / scale[c];
      if (!std::isfinite(relative)) return diverged();
      if (relative > tolerance) going.push_back(static_cast<int>(c));
      worst = std::max(worst, relative);
    }
    if (going.empty()) return u_mm;

    // Far from the end a rough direction serves as well as an exact one (Eisenstat and Walker 1996).
    const Eigen::MatrixXd here = u_mm(Eigen::all, going);
    std::vector<StiffeningBody::State> states(going.size());
    for_each_column(here.cols(),
                    [&](Eigen::Index i) { states[static_cast<std::size_t>(i)] = body.state(here.col(i)); });
    const auto newton = conjugate_gradients(body, precondition, states, one_each(here.cols()),
                                            residual(Eigen::all, going), std::clamp(worst, 1e-4, 0.05), 60);
    // Halve what makes the residual grow.
    std::vector<int> trying = going;
    Eigen::MatrixXd move = newton.u, from = here;
    for (int halving = 0; !trying.empty(); ++halving) {
      if (halving > maximum_halvings) return diverged();
      const Eigen::MatrixXd trial = from + move;
      const Eigen::MatrixXd trial_residual = residual_of(trial, trying);
      std::vector<int> again, again_index;
      for (std::size_t i = 0; i < trying.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        if (trial_residual.col(column).norm() < residual.col(trying[i]).norm()) {
          u_mm.col(trying[i]) = trial.col(column);
          residual.col(trying[i]) = trial_residual.col(column);
        } else {
          again.push_back(trying[i]);
          again_index.push_back(static_cast<int>(i));
        }
      }
      from = Eigen::MatrixXd(from(Eigen::all, again_index));
      move = Eigen::MatrixXd(0.5 * move(Eigen::all, again_index));
      trying = std::move(again);
    }
  }
  return diverged();
}

Result<Eigen::MatrixXd> solve_tangent(const SpecimenBody& specimen, const PalpationSolver::Solution& linear,
                                      const Stiffening& stiffening, const Eigen::MatrixXd& equilibria_mm,
                                      const Eigen::MatrixXd& forces_mN,
                                      const std::vector<Eigen::Index>& state_of_column, double relative_tolerance) {
  const StiffeningBody body(specimen, linear.structure, stiffening);
  const Preconditioner precondition(specimen, linear);
  Eigen::MatrixXd u_mm(forces_mN.rows(), forces_mN.cols());
  constexpr Eigen::Index at_once = 16;  // what a state remembers at every quadrature point is large
  for (Eigen::Index first = 0; first < equilibria_mm.cols(); first += at_once) {
    std::vector<StiffeningBody::State> states(
        static_cast<std::size_t>(std::min(at_once, equilibria_mm.cols() - first)));
    for_each_column(static_cast<Eigen::Index>(states.size()), [&](Eigen::Index c) {
      states[static_cast<std::size_t>(c)] = body.state(equilibria_mm.col(first + c));
    });
    std::vector<Eigen::Index> columns, state_of;
    for (Eigen::Index c = 0; c < forces_mN.cols(); ++c) {
      const Eigen::Index state = state_of_column[static_cast<std::size_t>(c)] - first;
      if (state < 0 || state >= static_cast<Eigen::Index>(states.size())) continue;
      columns.push_back(c);
      state_of.push_back(state);
    }
    const auto solved = conjugate_gradients(body, precondition, states, state_of, forces_mN(Eigen::all, columns),
                                            relative_tolerance, 300);
    if (!solved.u.allFinite() || solved.worst > 1e2 * relative_tolerance) return diverged();
    u_mm(Eigen::all, columns) = solved.u;
  }
  return u_mm;
}

}  // namespace glisson::closedloop
