#include "closedloop/palpation/internal/error_at_strain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "closedloop/palpation/internal/stiffening.h"

namespace glisson::closedloop {
namespace {

// One tool, pulled or pressed. Its error is square x^2 + cube x^3 with x the share of its largest load.
struct Branch {
  Eigen::Index load = 0;  // the declared solver's column
  Eigen::Index tool = 0;  // the finer solver's
  double largest_mN = 0;  // with its sign
};
struct Polynomial {
  Eigen::VectorXd square, cube;
};

std::vector<Branch> branches_of(const std::vector<FaceLoad>& tools, const std::vector<LoadRange>& ranges) {
  std::vector<Branch> branches;
  constexpr double counts = 0.1;  // of the other side's load: less is what an idle load cell reads
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const auto& [pulled_mN, pressed_mN] = ranges[t];
    const auto tool = static_cast<Eigen::Index>(t);
    if (-pulled_mN > counts * pressed_mN) branches.push_back({tools[t].load, tool, pulled_mN});
    if (pressed_mN > -counts * pulled_mN) branches.push_back({tools[t].load, tool, pressed_mN});
  }
  return branches;
}

// Of one body under half of each branch's load, then all of it: forces, and displacements at all nodes by its linear
// equations.
struct Linear {
  Eigen::MatrixXd forces_mN, u_mm;
};
Linear linear_response(const PalpationSolver& solver, const PalpationSolver::Solution& solution,
                       const std::vector<Branch>& branches, Eigen::Index Branch::*column) {
  const auto count = static_cast<Eigen::Index>(branches.size());
  Linear linear{Eigen::MatrixXd(solver.loads_mN().rows(), 2 * count),
                Eigen::MatrixXd(solver.loads_mN().rows(), 2 * count)};
  for (Eigen::Index b = 0; b < 2 * count; ++b) {
    const auto branch = static_cast<std::size_t>(b % count);
    const double load_mN = (b < count ? 0.5 : 1.0) * branches[branch].largest_mN;
    linear.forces_mN.col(b) = load_mN * solver.loads_mN().col(branches[branch].*column);
    linear.u_mm.col(b) = load_mN * solution.u_mm.col(branches[branch].*column);
  }
  return linear;
}

}  // namespace

// The lock is held for looking up and noting down alone: what is solved runs on all threads, which may ask here too.
struct ErrorAtStrain::Fine {
  Fine(PalpationSolver solver, std::vector<Eigen::Vector3d> places_mm, std::vector<FaceLoad> loads,
       const std::vector<LoadRange>& ranges)
      : declared(std::move(solver)),
        marker_places_mm(std::move(places_mm)),
        tools(std::move(loads)),
        branches(branches_of(tools, ranges)) {}

  PalpationSolver declared;
  std::vector<Eigen::Vector3d> marker_places_mm;
  std::vector<FaceLoad> tools;
  std::vector<Branch> branches;

  struct Refined {
    PalpationSolver solver;
    Interpolation from_declared;  // displacements of all its nodes
  };
  using Polynomials = std::vector<Polynomial>;  // one a branch; none where nothing was found

  // Made when it is first asked for; nothing where it cannot be solved.
  std::shared_ptr<const Refined> refined();
  // At a power of two of the law's coefficient.
  std::shared_ptr<const Polynomials> at(StiffeningLaw law, int power);

 private:
  [[nodiscard]] Polynomials solved_at(const Stiffening& stiffening);

  std::mutex guard_;
  std::optional<std::shared_ptr<const Refined>> refined_;
  std::map<std::pair<StiffeningLaw, int>, std::shared_ptr<const Polynomials>> known_;
};

namespace {

// Coefficients that the error is solved at: powers of two.
double coefficient_at(int power) { return std::ldexp(1.0, power); }

}  // namespace

ErrorAtStrain::ErrorAtStrain(PalpationSolver solver, std::vector<Eigen::Vector3d> marker_places_mm,
                             std::vector<FaceLoad> tools, const std::vector<LoadRange>& ranges)
    : fine_(std::make_shared<Fine>(std::move(solver), std::move(marker_places_mm), std::move(tools), ranges)) {}

Eigen::MatrixXd ErrorAtStrain::beyond_linear_mm(const Stiffening& stiffening, const Eigen::MatrixXd& amounts) const {
  Eigen::MatrixXd error_mm = Eigen::MatrixXd::Zero(fine_->declared.markers().rows(), amounts.cols());
  const double coefficient = stiffening.coefficient;
  if (!(coefficient > 0) || fine_->branches.empty() ||
      fine_->declared.specimen().body.mesh.cells.size() > maximum_cells_strained) {
    return error_mm;
  }
  constexpr int weakest = -6;  // what stiffens less is linear
  const double power = std::log2(coefficient);
  const int below = static_cast<int>(std::floor(power));
  if (below < weakest) return error_mm;
  const double share = power - below;
  const auto lower = fine_->at(stiffening.law, below), upper = fine_->at(stiffening.law, below + 1);
  if (lower->empty() || upper->empty()) return error_mm;

  constexpr double reach = 1.25;  // a polynomial says little far beyond the loads that it was solved at
  for (std::size_t b = 0; b < fine_->branches.size(); ++b) {
    const Branch& branch = fine_->branches[b];
    const Eigen::VectorXd square = (1 - share) * (*lower)[b].square + share * (*upper)[b].square;
    const Eigen::VectorXd cube = (1 - share) * (*lower)[b].cube + share * (*upper)[b].cube;
    for (Eigen::Index c = 0; c < amounts.cols(); ++c) {
      const double relative = std::min(amounts(branch.load, c) / branch.largest_mN, reach);
      if (relative > 0) error_mm.col(c) += relative * relative * (square + relative * cube);
    }
  }
  return error_mm;
}

std::shared_ptr<const ErrorAtStrain::Fine::Refined> ErrorAtStrain::Fine::refined() {
  {
    const std::lock_guard lock(guard_);
    if (refined_) return *refined_;
  }
  std::shared_ptr<const Refined> made;
  if (auto solver = refined_solver(declared, marker_places_mm, tools)) {
    const mechanics::Body& body = declared.specimen().body;
    Interpolation from_declared(body.layout,
                                mechanics::locate_points(body.mesh, solver->specimen().body.layout.positions_mm));
    made = std::make_shared<const Refined>(Refined{std::move(*solver), std::move(from_declared)});
  }
  const std::lock_guard lock(guard_);
  if (!refined_) refined_ = std::move(made);
  return *refined_;
}

std::shared_ptr<const ErrorAtStrain::Fine::Polynomials> ErrorAtStrain::Fine::at(StiffeningLaw law, int power) {
  {
    const std::lock_guard lock(guard_);
    if (const auto found = known_.find({law, power}); found != known_.end()) return found->second;
  }
  auto solved = std::make_shared<const Polynomials>(solved_at({law, coefficient_at(power)}));
  const std::lock_guard lock(guard_);
  return known_.try_emplace({law, power}, std::move(solved)).first->second;
}

ErrorAtStrain::Fine::Polynomials ErrorAtStrain::Fine::solved_at(const Stiffening& stiffening) {
  const auto finer = refined();
  if (!finer) return {};
  const auto solution = declared.solution({}), fine_solution = finer->solver.solution({});
  if (!solution || !fine_solution) return {};
  const Linear coarse = linear_response(declared, **solution, branches, &Branch::load);
  const Linear fine = linear_response(finer->solver, **fine_solution, branches, &Branch::tool);
  constexpr double tolerance = 3e-4;  // of the load: far below what a mesh's error matters
  const auto coarse_mm =
      stiffened_equilibria(declared.specimen(), **solution, stiffening, coarse.forces_mN, coarse.u_mm, tolerance);
  if (!coarse_mm) return {};
  // The finer body begins where the coarse one ends, and its own linear equations beside it.
  const Eigen::MatrixXd start_mm = fine.u_mm + finer->from_declared.at_places(*coarse_mm - coarse.u_mm);
  const auto fine_mm =
      stiffened_equilibria(finer->solver.specimen(), **fine_solution, stiffening, fine.forces_mN, start_mm, tolerance);
  if (!fine_mm) return {};
  const Eigen::MatrixXd error_mm = error_of_first_step * (finer->solver.markers().at_places(*fine_mm - fine.u_mm) -
                                                          declared.markers().at_places(*coarse_mm - coarse.u_mm));
  Polynomials polynomials;
  const auto count = static_cast<Eigen::Index>(branches.size());
  for (Eigen::Index b = 0; b < count; ++b) {
    // square + cube = whole, square / 4 + cube / 8 = half.
    const Eigen::VectorXd half = error_mm.col(b), whole = error_mm.col(count + b);
    polynomials.push_back({8 * half - whole, 2 * whole - 8 * half});
  }
  return polynomials;
}

}  // namespace glisson::closedloop
