#include "mechanics/contact/internal/contact_forces.h"

#include <algorithm>
#include <Eigen/LU>
#include <limits>
#include <vector>

namespace glisson::mechanics {
namespace {

struct Trial {
  Eigen::VectorXd force, advance, gap;
};

// Each contact gives a little by itself: a thousandth of what the body gives there. More contacts than the surface has
// ways to move under them then share their force evenly, where they would push and pull at each other without bounds.
Eigen::VectorXd give_of(const ContactProblem& problem) {
  const Eigen::VectorXd own = problem.compliance.diagonal().cwiseAbs();
  Eigen::VectorXd give = 1e-3 * own;
  give.tail(problem.two_sided).setConstant(1e-10 * (own.size() > 0 ? own.maxCoeff() : 0.0));
  return give;
}

Trial with_touching(const ContactProblem& problem, const std::vector<bool>& touching) {
  const Eigen::Index contacts = problem.start.size(), drives = problem.drives.cols();
  std::vector<Eigen::Index> active;
  for (Eigen::Index c = 0; c < contacts; ++c) {
    if (touching[static_cast<std::size_t>(c)]) active.push_back(c);
  }
  const auto count = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + drives, count + drives);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count + drives);
  system.topLeftCorner(count, count) = problem.compliance(active, active);
  const Eigen::VectorXd give = give_of(problem);
  system.topLeftCorner(count, count).diagonal() += give(active);
  right.head(count) = -problem.start(active);
  if (drives > 0) {
    system.topRightCorner(count, drives) = -problem.drives(active, Eigen::all);
    system.bottomLeftCorner(drives, count) = problem.drives(active, Eigen::all).transpose();
    right.tail(drives) = problem.drive_force;
  }
  Eigen::VectorXd solved = system.partialPivLu().solve(right);
  if (!solved.allFinite()) solved = system.fullPivLu().solve(right);  // a pushed tool that no contact stops
  Trial trial{Eigen::VectorXd::Zero(contacts), solved.tail(drives), {}};
  for (Eigen::Index i = 0; i < count; ++i) trial.force[active[static_cast<std::size_t>(i)]] = solved[i];
  trial.gap = problem.start + problem.compliance * trial.force + give.cwiseProduct(trial.force);
  if (drives > 0) trial.gap -= problem.drives * trial.advance;
  return trial;
}

}  // namespace

ContactForces solve_contact(const ContactProblem& problem) {
  const Eigen::Index contacts = problem.start.size(), one_sided = contacts - problem.two_sided;
  std::vector<bool> touching(static_cast<std::size_t>(contacts));
  for (Eigen::Index c = 0; c < contacts; ++c) touching[c] = c >= one_sided || problem.start[c] < 0;
  // A drive without a contact has no answer: its first is the one that it reaches first.
  for (Eigen::Index k = 0; k < problem.drives.cols(); ++k) {
    Eigen::Index first = -1;
    double way = std::numeric_limits<double>::infinity();
    bool has_one = false;
    for (Eigen::Index c = 0; c < one_sided; ++c) {
      if (problem.drives(c, k) <= 1e-3) continue;
      has_one |= touching[c];
      if (problem.start[c] / problem.drives(c, k) < way) {
        way = problem.start[c] / problem.drives(c, k);
        first = c;
      }
    }
    if (!has_one && first >= 0) touching[first] = true;
  }

  ContactForces answer{Eigen::VectorXd::Zero(contacts), Eigen::VectorXd::Zero(problem.drives.cols()), 0, false};
  if (contacts == 0) {
    answer.converged = problem.drives.cols() == 0;
    return answer;
  }
  int patience = 3;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  const double length = problem.start.cwiseAbs().maxCoeff() + 1.0;
  const double rounding_gap = 1e-9 * length;
  const int maximum_exchanges = 50 + 10 * static_cast<int>(contacts);
  for (; answer.exchanges < maximum_exchanges; ++answer.exchanges) {
    const Trial trial = with_touching(problem, touching);
    const double rounding_force = 1e-9 * (trial.force.cwiseAbs().maxCoeff() + 1e-9);
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index c = 0; c < one_sided; ++c) {
      if (touching[c] ? trial.force[c] < -rounding_force : trial.gap[c] < -rounding_gap) wrong.push_back(c);
    }
    answer.force = trial.force;
    answer.advance = trial.advance;
    if (wrong.empty()) {
      answer.converged = trial.force.allFinite() && trial.advance.allFinite();
      answer.force.head(one_sided) = answer.force.head(one_sided).cwiseMax(0.0);
      // What a drive asks for must be what its contacts give.
      for (Eigen::Index k = 0; k < problem.drives.cols(); ++k) {
        const double given = problem.drives.col(k).dot(answer.force);
        if (std::abs(given - problem.drive_force[k]) > 1e-6 * std::abs(problem.drive_force[k]))
          answer.converged = false;
      }
      return answer;
    }
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      patience = 3;
    } else if (patience-- <= 0) {
      wrong = {wrong.back()};
    }
    for (const Eigen::Index c : wrong) touching[c] = !touching[c];
  }
  return answer;
}

}  // namespace glisson::mechanics
