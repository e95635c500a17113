#include "closedloop/palpation/internal/solver.h"

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.h"

namespace glisson::closedloop {

// Lately used structures come first. All keep what happened at their markers, the first few their factors too, and the
// declared one always does. The lock is held for looking up and noting down alone: two structures are solved at once.
struct PalpationSolver::Memory {
  struct Entry {
    Structure structure;
    std::shared_ptr<const Solution> solution;  // may have been let go
    Eigen::MatrixXd at_markers;
    std::vector<std::pair<StructureParameter, Eigen::MatrixXd>> derivatives;

    [[nodiscard]] const Eigen::MatrixXd* by(StructureParameter parameter) const {
      const auto found = std::find_if(derivatives.begin(), derivatives.end(),
                                      [&](const auto& known) { return known.first == parameter; });
      return found == derivatives.end() ? nullptr : &found->second;
    }
  };
  static constexpr std::size_t maximum_entries = 1024, maximum_factors = 4;

  std::mutex guard;
  std::deque<Entry> entries;
  std::shared_ptr<const Solution> declared;
  // Soft supports free unknowns, and a membrane couples others: structures that have the same of these have one
  // pattern.
  using Pattern = std::tuple<bool, bool, std::optional<std::size_t>>;
  std::map<Pattern, std::shared_ptr<const mechanics::EliminationOrder>> orders;

  std::shared_ptr<const mechanics::EliminationOrder>& order_of(const Structure& structure) {
    const bool all_soft = structure.compliance_mm_per_kPa > 0;
    const bool one_soft = !all_soft && structure.loosened;
    return orders[{all_soft, structure.capsule_mN_per_mm > 0,
                   one_soft ? std::optional(structure.loosened->support) : std::nullopt}];
  }

  Entry* find(const Structure& structure) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.structure == structure; });
    if (found == entries.end()) return nullptr;
    if (found != entries.begin()) {
      Entry moved = std::move(*found);
      entries.erase(found);
      entries.push_front(std::move(moved));
    }
    return &entries.front();
  }
  Entry& find_or_add(const std::shared_ptr<const Solution>& solution, const Interpolation& markers) {
    Entry* entry = find(solution->structure);
    if (entry == nullptr) {
      entries.push_front({solution->structure, {}, markers.at_places(solution->u_mm), {}});
      if (entries.size() > maximum_entries) entries.pop_back();
      entry = &entries.front();
    }
    entry->solution = solution;
    std::size_t kept = 0;
    for (Entry& other : entries) {
      if (other.solution && other.solution != declared && ++kept > maximum_factors) other.solution.reset();
    }
    return *entry;
  }
};

namespace {

// Far below what measurements can see; what is reached is usually 1e-12.
constexpr mechanics::Refinement refinement{.target = 1e-9, .tolerance = 1e-6, .max_refinements = 3};

Result<std::shared_ptr<const PalpationSolver::Solution>> solve_structure(
    const SpecimenBody& specimen, const Structure& structure, const Eigen::MatrixXd& loads_mN, const Progress& progress,
    std::shared_ptr<const mechanics::EliminationOrder> order) {
  auto system =
      mechanics::ConstrainedSystem::create(stiffness(specimen, structure), fixed_unknowns(specimen, structure),
                                           specimen.body.options.memory_limit_bytes, progress, std::move(order));
  if (!system) return failure(std::move(system.error()));
  auto solution = std::make_shared<PalpationSolver::Solution>(
      PalpationSolver::Solution{structure, std::move(*system), Eigen::MatrixXd()});
  const auto columns = solution->system.solve(loads_mN, {}, refinement);
  solution->u_mm.resize(loads_mN.rows(), loads_mN.cols());
  for (std::size_t l = 0; l < columns.size(); ++l) {
    if (!columns[l].converged) {
      return failure("solve-inexact", GLISSON_TEXT("The specimen's equations are too badly conditioned to be solved."));
    }
    solution->u_mm.col(static_cast<Eigen::Index>(l)) = columns[l].u;
  }
  return std::shared_ptr<const PalpationSolver::Solution>(std::move(solution));
}

}  // namespace

Result<PalpationSolver> PalpationSolver::create(SpecimenBody specimen, Eigen::MatrixXd loads_mN, Interpolation markers,
                                                const Progress& progress) {
  auto declared = solve_structure(specimen, {}, loads_mN, progress, nullptr);
  if (!declared) return failure(std::move(declared.error()));
  PalpationSolver solver;
  solver.specimen_ = std::make_shared<const SpecimenBody>(std::move(specimen));
  solver.loads_mN_ = std::make_shared<const Eigen::MatrixXd>(std::move(loads_mN));
  solver.markers_ = std::make_shared<const Interpolation>(std::move(markers));
  solver.memory_ = std::make_shared<Memory>();
  solver.memory_->order_of({}) = (*declared)->system.order();
  solver.memory_->declared = *declared;
  return solver;
}

// A lump as stiff as what is around it is none, wherever it lies.
Result<Eigen::MatrixXd> PalpationSolver::at_markers(const Structure& structure) const {
  Structure plain = structure;
  if (plain.inclusion && plain.inclusion->ratio == 1) plain.inclusion.reset();
  {
    const std::lock_guard lock(memory_->guard);
    if (const auto* known = memory_->find(plain)) return known->at_markers;
  }
  auto solved = solution(plain);
  if (!solved) return failure(std::move(solved.error()));
  const std::lock_guard lock(memory_->guard);
  return memory_->find_or_add(*solved, *markers_).at_markers;
}

Result<std::shared_ptr<const PalpationSolver::Solution>> PalpationSolver::solution(const Structure& structure) const {
  std::shared_ptr<const mechanics::EliminationOrder> order;
  {
    const std::lock_guard lock(memory_->guard);
    if (const auto* known = memory_->find(structure); known != nullptr && known->solution) return known->solution;
    order = memory_->order_of(structure);
  }
  Result<std::shared_ptr<const Solution>> solved = memory_->declared;
  if (!(structure == Structure{})) solved = solve_structure(*specimen_, structure, *loads_mN_, {}, std::move(order));
  if (!solved) return failure(std::move(solved.error()));
  const std::lock_guard lock(memory_->guard);
  memory_->order_of(structure) = (*solved)->system.order();
  memory_->find_or_add(*solved, *markers_);
  return solved;
}

Result<std::vector<Eigen::MatrixXd>> PalpationSolver::derivatives_at_markers(
    const Structure& structure, const std::vector<StructureParameter>& parameters) const {
  std::vector<Eigen::MatrixXd> derivatives(parameters.size());
  std::vector<std::size_t> unknown;
  {
    const std::lock_guard lock(memory_->guard);
    const auto* entry = memory_->find(structure);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Eigen::MatrixXd* known = entry == nullptr ? nullptr : entry->by(parameters[i]);
      if (known != nullptr) {
        derivatives[i] = *known;
      } else {
        unknown.push_back(i);
      }
    }
  }
  if (unknown.empty()) return derivatives;

  auto solved = solution(structure);
  if (!solved) return failure(std::move(solved.error()));
  // K u = f with f fixed: K du = -dK u.
  const Eigen::MatrixXd& u_mm = (*solved)->u_mm;
  const Eigen::Index loads = u_mm.cols();
  Eigen::MatrixXd forces_mN(u_mm.rows(), loads * static_cast<Eigen::Index>(unknown.size()));
  parallel_for(static_cast<std::size_t>(forces_mN.cols()), 1, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<Eigen::Index>(begin); c < static_cast<Eigen::Index>(end); ++c) {
      const StructureParameter parameter = parameters[unknown[static_cast<std::size_t>(c / loads)]];
      forces_mN.col(c) = -stiffness_derivative(*specimen_, structure, parameter, u_mm.col(c % loads));
    }
  });
  const Eigen::MatrixXd moved = markers_->at_places(solve(**solved, forces_mN));
  const std::lock_guard lock(memory_->guard);
  auto& entry = memory_->find_or_add(*solved, *markers_);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    const StructureParameter parameter = parameters[unknown[i]];
    derivatives[unknown[i]] = moved.middleCols(static_cast<Eigen::Index>(i) * loads, loads);
    if (entry.by(parameter) == nullptr) entry.derivatives.emplace_back(parameter, derivatives[unknown[i]]);
  }
  return derivatives;
}

Eigen::MatrixXd PalpationSolver::solve(const Solution& solution, const Eigen::MatrixXd& forces_mN) {
  return solution.system.respond(forces_mN).u;
}

}  // namespace glisson::closedloop
