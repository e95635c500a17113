#include "closedloop/palpation/internal/stiffened_response.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <numeric>

#include "base/parallel.h"
#include "closedloop/palpation/internal/stiffening.h"

namespace glisson::closedloop {
namespace {

// Shots under the same load are one equilibrium, unless a creeping load parts them as soon as a parameter moves.
struct Distinct {
  Eigen::MatrixXd amounts;
  std::vector<Eigen::Index> first;  // a shot under each distinct load
  std::vector<Eigen::Index> which;  // the distinct load of each shot
};
Distinct distinct(const Acting& acting) {
  const Eigen::MatrixXd& all = acting.amounts;
  Distinct result;
  for (Eigen::Index c = 0; c < all.cols(); ++c) {
    const auto known = std::find_if(result.first.begin(), result.first.end(), [&](Eigen::Index other) {
      return acting.state.creep.empty() && all.col(other) == all.col(c);
    });
    result.which.push_back(known - result.first.begin());
    if (known == result.first.end()) result.first.push_back(c);
  }
  result.amounts = all(Eigen::all, result.first);
  return result;
}

bool same_effects(const Settings& a, const Settings& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Setting& x, const Setting& y) {
    return x.kind == y.kind && x.form == y.form && x.parameters.size() == y.parameters.size();
  });
}
bool same_settings(const Settings& a, const Settings& b) {
  return same_effects(a, b) && std::equal(a.begin(), a.end(), b.begin(), [](const Setting& x, const Setting& y) {
           return x.parameters == y.parameters;
         });
}

// The loads of one direction follow each other by size: the largest smaller one, or none.
std::vector<Eigen::Index> smaller_loads(const Eigen::MatrixXd& amounts) {
  std::vector<Eigen::Index> before(static_cast<std::size_t>(amounts.cols()), -1);
  const Eigen::VectorXd size = amounts.colwise().norm();
  for (Eigen::Index c = 0; c < amounts.cols(); ++c) {
    for (Eigen::Index other = 0; other < amounts.cols(); ++other) {
      const bool smaller = size[other] > 0 && size[other] < (1 - 1e-9) * size[c];
      const bool along = amounts.col(c).dot(amounts.col(other)) > (1 - 1e-12) * size[c] * size[other];
      auto& best = before[static_cast<std::size_t>(c)];
      if (smaller && along && (best < 0 || size[other] > size[best])) best = other;
    }
  }
  return before;
}

// Equilibria begun from nothing: small loads from the linear solution, larger ones from where smaller ones lead.
Result<Eigen::MatrixXd> along_the_load(const SpecimenBody& specimen, const PalpationSolver::Solution& linear,
                                       const Stiffening& stiffening, const Eigen::MatrixXd& amounts,
                                       const Eigen::MatrixXd& forces_mN, const Eigen::MatrixXd& linear_mm) {
  const std::vector<Eigen::Index> before = smaller_loads(amounts);
  const Eigen::VectorXd size = amounts.colwise().norm();
  Eigen::MatrixXd u_mm = linear_mm;
  std::vector<int> left(static_cast<std::size_t>(amounts.cols()));
  std::iota(left.begin(), left.end(), 0);
  std::vector<bool> done(left.size(), false);
  while (!left.empty()) {
    std::vector<int> now, later;
    for (const int c : left) {
      const Eigen::Index one = before[static_cast<std::size_t>(c)];
      (one < 0 || done[static_cast<std::size_t>(one)] ? now : later).push_back(c);
    }
    for (const int c : now) {
      const Eigen::Index one = before[static_cast<std::size_t>(c)];
      if (one < 0) continue;
      // Displacement by load, on a line through the last two loads (the linear response where there is but one).
      const Eigen::Index two = before[static_cast<std::size_t>(one)];
      const Eigen::VectorXd by_load = u_mm.col(one) / size[one];
      const Eigen::VectorXd earlier =
          two < 0 ? Eigen::VectorXd(linear_mm.col(c) / size[c]) : Eigen::VectorXd(u_mm.col(two) / size[two]);
      const double share = (size[c] - size[one]) / (size[one] - (two < 0 ? 0.0 : size[two]));
      u_mm.col(c) = size[c] * (by_load + std::min(share, 1.0) * (by_load - earlier));
    }
    auto found = stiffened_equilibria(specimen, linear, stiffening, forces_mN(Eigen::all, now), u_mm(Eigen::all, now));
    if (!found) return found;
    u_mm(Eigen::all, now) = *found;
    for (const int c : now) done[static_cast<std::size_t>(c)] = true;
    left = std::move(later);
  }
  return u_mm;
}

// Equilibria near those of other effects under other loads: of each load the one known under the load nearest to it,
// scaled.
Eigen::MatrixXd from_others(const Eigen::MatrixXd& amounts, const Eigen::MatrixXd& known_amounts,
                            const Eigen::MatrixXd& known_mm) {
  Eigen::MatrixXd start_mm = Eigen::MatrixXd::Zero(known_mm.rows(), amounts.cols());
  for (Eigen::Index c = 0; c < amounts.cols(); ++c) {
    const double size = amounts.col(c).norm();
    if (size == 0) continue;
    Eigen::Index nearest = -1;
    double apart = 0.5 * size;  // what is farther says nothing
    for (Eigen::Index k = 0; k < known_amounts.cols(); ++k) {
      const double distance = (known_amounts.col(k) - amounts.col(c)).norm();
      if (distance < apart) {
        apart = distance;
        nearest = k;
      }
    }
    if (nearest < 0) continue;
    start_mm.col(c) = size / known_amounts.col(nearest).norm() * known_mm.col(nearest);
  }
  return start_mm;
}

// Several parameters may load a specimen alike (creep's amplitudes and times, a gain): of columns of forces on one
// state that are multiples of each other one is solved for.
struct Alike {
  std::vector<Eigen::Index> solved;  // columns
  std::vector<Eigen::Index> which;   // of `solved`, for each column
  std::vector<double> factor;
};
Alike alike_columns(const Eigen::MatrixXd& forces_mN, const std::vector<Eigen::Index>& load_of_column) {
  Alike alike;
  const Eigen::VectorXd squared = forces_mN.colwise().squaredNorm();
  for (Eigen::Index c = 0; c < forces_mN.cols(); ++c) {
    Eigen::Index found = static_cast<Eigen::Index>(alike.solved.size());
    double factor = 1;
    for (std::size_t s = 0; s < alike.solved.size(); ++s) {
      const Eigen::Index other = alike.solved[s];
      if (load_of_column[static_cast<std::size_t>(other)] != load_of_column[static_cast<std::size_t>(c)]) continue;
      if (squared[other] == 0) continue;
      const double along = forces_mN.col(c).dot(forces_mN.col(other)) / squared[other];
      if (squared[c] - along * along * squared[other] > 1e-12 * squared[c]) continue;
      found = static_cast<Eigen::Index>(s);
      factor = along;
      break;
    }
    if (found == static_cast<Eigen::Index>(alike.solved.size())) alike.solved.push_back(c);
    alike.which.push_back(found);
    alike.factor.push_back(factor);
  }
  return alike;
}

}  // namespace

// Equilibria at all nodes, one a distinct load, and their derivatives where they were asked for.
struct StiffenedResponse::Nodal {
  Settings settings;
  Acting acting;
  Distinct loads;
  Eigen::MatrixXd u_mm;
  std::vector<Eigen::MatrixXd> by_parameter;

  [[nodiscard]] Eigen::MatrixXd at_shots(const Interpolation& markers, const Eigen::MatrixXd& nodal) const {
    return markers.at_places(nodal)(Eigen::all, loads.which);
  }
};

// The last few at all nodes, many at the markers.
struct StiffenedResponse::Memory {
  struct Entry {
    Settings settings;
    Eigen::MatrixXd at_markers;
    std::vector<Eigen::MatrixXd> by_parameter;  // empty where not asked for
  };
  static constexpr std::size_t maximum_entries = 512, maximum_nodal = 8;
  std::mutex guard;
  std::deque<Entry> entries;
  std::deque<std::shared_ptr<const Nodal>> nodal;

  [[nodiscard]] const Entry* find(const Settings& settings) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return same_settings(entry.settings, settings); });
    return found == entries.end() ? nullptr : &*found;
  }
  void note(Entry entry) {
    std::erase_if(entries, [&](const Entry& other) { return same_settings(other.settings, entry.settings); });
    entries.push_front(std::move(entry));
    if (entries.size() > maximum_entries) entries.pop_back();
  }
  void note(std::shared_ptr<const Nodal> solved) {
    // Of the same effects two are kept: the last with slopes, from where the next begins best, and the last.
    std::erase_if(nodal, [&](const auto& other) {
      return same_effects(other->settings, solved->settings) &&
             (other->by_parameter.empty() == solved->by_parameter.empty() ||
              same_settings(other->settings, solved->settings));
    });
    nodal.push_front(std::move(solved));
    if (nodal.size() > maximum_nodal) nodal.pop_back();
  }
};

StiffenedResponse::StiffenedResponse(PalpationSolver solver, std::function<Acting(const Settings&)> acting,
                                     std::function<Eigen::MatrixXd(const Acting&)> mesh_error_mm)
    : solver_(std::move(solver)),
      acting_(std::move(acting)),
      mesh_error_mm_(std::move(mesh_error_mm)),
      memory_(std::make_shared<Memory>()) {}

Result<Eigen::MatrixXd> StiffenedResponse::at_markers(const Settings& settings) const {
  {
    const std::lock_guard lock(memory_->guard);
    if (const auto* known = memory_->find(settings)) return known->at_markers;
  }
  const auto solved = equilibria(settings);
  if (!solved) return failure(solved.error());
  Eigen::MatrixXd at_markers =
      (*solved)->at_shots(solver_.markers(), (*solved)->u_mm) + mesh_error_mm_((*solved)->acting);
  const std::lock_guard lock(memory_->guard);
  memory_->note({settings, at_markers, {}});
  return at_markers;
}

// With springs and a membrane that do not scale, everything is divided by the stiffness factor: `amounts` are already.
Result<std::shared_ptr<const StiffenedResponse::Nodal>> StiffenedResponse::equilibria(const Settings& settings) const {
  std::shared_ptr<const Nodal> last, other;
  {
    const std::lock_guard lock(memory_->guard);
    for (const auto& known : memory_->nodal) {
      if (same_settings(known->settings, settings)) return known;
      if (same_effects(known->settings, settings)) {
        if (!last || last->by_parameter.empty()) last = known;
      } else if (!other) {
        other = known;
      }
    }
  }

  auto solved = std::make_shared<Nodal>();
  solved->settings = settings;
  solved->acting = acting_(settings);
  solved->loads = distinct(solved->acting);
  const PalpationState& at = solved->acting.state;
  const auto linear = solver_.solution(at.scaled_structure());
  if (!linear) return failure(linear.error());
  const Eigen::MatrixXd linear_mm = (*linear)->u_mm * solved->loads.amounts;
  if (at.stiffening->coefficient == 0) {
    solved->u_mm = linear_mm;
    return std::shared_ptr<const Nodal>(std::move(solved));
  }
  const Eigen::MatrixXd forces_mN = solver_.loads_mN() * solved->loads.amounts;
  Result<Eigen::MatrixXd> found = failure("stiffening-diverged", "");
  if (last && last->loads.which == solved->loads.which) {
    Eigen::MatrixXd start_mm = last->u_mm;
    std::size_t column = 0;
    for (std::size_t s = 0; s < settings.size() && !last->by_parameter.empty(); ++s) {
      const Eigen::VectorXd step = settings[s].parameters - last->settings[s].parameters;
      for (Eigen::Index p = 0; p < step.size(); ++p) start_mm += step[p] * last->by_parameter[column++];
    }
    found = stiffened_equilibria(solver_.specimen(), **linear, *at.stiffening, forces_mN, start_mm);
  }
  if (!found && other && other->acting.state.stiffening->law == at.stiffening->law) {
    found = stiffened_equilibria(solver_.specimen(), **linear, *at.stiffening, forces_mN,
                                 from_others(solved->loads.amounts, other->loads.amounts, other->u_mm));
  }
  if (!found) {
    found = along_the_load(solver_.specimen(), **linear, *at.stiffening, solved->loads.amounts, forces_mN, linear_mm);
  }
  if (!found) return failure(std::move(found.error()));
  solved->u_mm = std::move(*found);
  const std::lock_guard lock(memory_->guard);
  memory_->note(std::shared_ptr<const Nodal>(solved));
  return std::shared_ptr<const Nodal>(std::move(solved));
}

// From what is in balance, R(u; parameters) = 0: du = -(tangent)^-1 dR, with dR by central differences, which are cheap
// and lose nothing that matters (1e-9 of R).
Result<std::vector<Eigen::MatrixXd>> StiffenedResponse::derivatives_at_markers(const Settings& settings) const {
  {
    const std::lock_guard lock(memory_->guard);
    const auto* known = memory_->find(settings);
    if (known != nullptr && !known->by_parameter.empty()) return known->by_parameter;
  }
  const auto solved = equilibria(settings);
  if (!solved) return failure(solved.error());
  const Nodal& here = **solved;
  const auto linear = solver_.solution(here.acting.state.scaled_structure());
  if (!linear) return failure(linear.error());

  const Eigen::Index loads = here.u_mm.cols(), parameters = parameter_count(settings);
  // What the body resists changes with what it is made of alone; most parameters only load it.
  const auto resisted_mN = [&](const Acting& there) {
    const Structure structure = there.state.scaled_structure();
    Eigen::MatrixXd force_mN(here.u_mm.rows(), loads);
    parallel_for(static_cast<std::size_t>(loads), 1, [&](std::size_t begin, std::size_t end) {
      for (auto l = static_cast<Eigen::Index>(begin); l < static_cast<Eigen::Index>(end); ++l) {
        force_mN.col(l) = resisting_force_mN(solver_.specimen(), structure, *there.state.stiffening, here.u_mm.col(l));
      }
    });
    return force_mN;
  };
  const auto imbalance_between_mN = [&](const Acting& behind, const Acting& ahead) {
    Eigen::MatrixXd force_mN = solver_.loads_mN() * (behind.amounts - ahead.amounts)(Eigen::all, here.loads.first);
    const bool same_body = behind.state.scaled_structure() == ahead.state.scaled_structure() &&
                           behind.state.stiffening->coefficient == ahead.state.stiffening->coefficient;
    if (!same_body) force_mN += resisted_mN(ahead) - resisted_mN(behind);
    return force_mN;
  };
  Eigen::MatrixXd forces_mN(here.u_mm.rows(), loads * parameters);
  std::vector<Eigen::MatrixXd> error_slopes;
  std::vector<Eigen::Index> load_of_column;
  Settings moved = settings;
  Eigen::Index column = 0;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    for (Eigen::Index p = 0; p < settings[s].parameters.size(); ++p, ++column) {
      const double value = settings[s].parameters[p], step = 1e-5 * std::max(1e-2, std::abs(value));
      moved[s].parameters[p] = value + step;
      const Acting ahead = acting_(moved);
      moved[s].parameters[p] = value - step;
      const Acting behind = acting_(moved);
      forces_mN.middleCols(column * loads, loads) = -imbalance_between_mN(behind, ahead) / (2 * step);
      error_slopes.emplace_back((mesh_error_mm_(ahead) - mesh_error_mm_(behind)) / (2 * step));
      moved[s].parameters[p] = value;
      for (Eigen::Index l = 0; l < loads; ++l) load_of_column.push_back(l);
    }
  }
  constexpr double tolerance = 1e-3;  // a search needs no more of its slopes
  const Alike alike = alike_columns(forces_mN, load_of_column);
  std::vector<Eigen::Index> load_of_solved;
  for (const Eigen::Index c : alike.solved) load_of_solved.push_back(load_of_column[static_cast<std::size_t>(c)]);
  const auto solved_slopes = solve_tangent(solver_.specimen(), **linear, *here.acting.state.stiffening, here.u_mm,
                                           forces_mN(Eigen::all, alike.solved), load_of_solved, tolerance);
  if (!solved_slopes) return failure(solved_slopes.error());
  Eigen::MatrixXd slopes(forces_mN.rows(), forces_mN.cols());
  for (Eigen::Index c = 0; c < slopes.cols(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    slopes.col(c) = alike.factor[i] * solved_slopes->col(alike.which[i]);
  }

  auto with_slopes = std::make_shared<Nodal>(here);
  Memory::Entry entry{settings, here.at_shots(solver_.markers(), here.u_mm) + mesh_error_mm_(here.acting), {}};
  for (Eigen::Index i = 0; i < parameters; ++i) {
    with_slopes->by_parameter.emplace_back(slopes.middleCols(i * loads, loads));
    entry.by_parameter.push_back(here.at_shots(solver_.markers(), with_slopes->by_parameter.back()) +
                                 error_slopes[static_cast<std::size_t>(i)]);
  }
  std::vector<Eigen::MatrixXd> derivatives = entry.by_parameter;
  const std::lock_guard lock(memory_->guard);
  memory_->note(std::move(entry));
  memory_->note(std::shared_ptr<const Nodal>(std::move(with_slopes)));
  return derivatives;
}

}  // namespace glisson::closedloop
