#include "registration/mrf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::registration {
namespace {

constexpr int maximum_points = 4096;  // 16.8 million distances a surface; the message store would take 128 GB

Result<void> check_distances(const Eigen::MatrixXd& distances_mm, const char* whose) {
  if (distances_mm.rows() != distances_mm.cols()) {
    return failure("matching-distances", GLISSON_TEXT("The distances between the points of the {0} are not square."),
                   {whose});
  }
  if (distances_mm.rows() < 2) {
    return failure("matching-too-few-points", GLISSON_TEXT("The {0} has fewer than two points to match."), {whose});
  }
  if (distances_mm.rows() > maximum_points) {
    return failure("matching-too-many-points", GLISSON_TEXT("The {0} has {1} points to match; {2} is the most."),
                   {whose, std::to_string(distances_mm.rows()), std::to_string(maximum_points)});
  }
  if (!distances_mm.allFinite()) {
    return failure(Error{"matching-distances",
                         GLISSON_TEXT("Some points of the {0} are not connected over the surface."),
                         {whose},
                         GLISSON_TEXT("Keep the largest connected piece, or bridge the gap before matching."),
                         {}});
  }
  const double tolerance_mm = 1e-9 * std::max(1.0, distances_mm.maxCoeff());
  if (distances_mm.minCoeff() < 0 || distances_mm.diagonal().maxCoeff() > 0 ||
      (distances_mm - distances_mm.transpose()).cwiseAbs().maxCoeff() > tolerance_mm) {
    return failure("matching-distances",
                   GLISSON_TEXT("The distances between the points of the {0} are not those of a metric."), {whose});
  }
  return {};
}

std::size_t pair_index(int i, int j, int nodes) {  // i < j, row by row
  const auto row = static_cast<std::size_t>(i);
  return row * static_cast<std::size_t>(nodes) - row * (row + 1) / 2 + static_cast<std::size_t>(j - i - 1);
}

}  // namespace

std::size_t MatchingProblem::pairs_of_nodes() const {
  return static_cast<std::size_t>(nodes()) * static_cast<std::size_t>(nodes() - 1) / 2;
}

Result<void> check(const MatchingProblem& problem) {
  if (auto source = check_distances(problem.source_mm, "source"); !source) return source;
  if (auto target = check_distances(problem.target_mm, "target"); !target) return target;
  const bool seeded = problem.seed.size() > 0;
  if (seeded && (problem.seed.rows() != problem.nodes() || problem.seed.cols() != problem.labels() ||
                 !problem.seed.allFinite())) {
    return failure("matching-seed",
                   GLISSON_TEXT("The seed must hold one finite cost a source point and target point."));
  }
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!positive(problem.sigma_mm) || !positive(problem.tau_mm) || !positive(problem.q)) {
    return failure("matching-constants", GLISSON_TEXT("sigma, tau and q must be positive."));
  }
  return {};
}

MatchingEnergy::MatchingEnergy(const MatchingProblem& problem)
    : problem_(problem),
      source_weight_(problem.q * (-problem.source_mm / problem.sigma_mm).array().exp()),
      target_weight_(problem.q * (-problem.target_mm / problem.sigma_mm).array().exp()) {}

double MatchingEnergy::of_pair(int i, int j, int k, int l) const {
  return std::max(source_weight_(i, j), target_weight_(k, l)) *
         std::min(std::abs(problem_.source_mm(i, j) - problem_.target_mm(k, l)), problem_.tau_mm);
}

double MatchingEnergy::operator()(const Labelling& labelling) const {
  GLISSON_ASSERT(static_cast<int>(labelling.size()) == problem_.nodes());
  const auto label = [&](int node) { return labelling[static_cast<std::size_t>(node)]; };
  double energy = 0;
  for (int j = 0; j < problem_.nodes(); ++j) {
    if (problem_.seed.size() > 0) energy += problem_.seed(j, label(j));
    for (int i = 0; i < j; ++i) energy += of_pair(i, j, label(i), label(j));
  }
  return energy;
}

const double* StoredMrf::pair(int i, int j) const {
  const auto cells = static_cast<std::size_t>(labels) * static_cast<std::size_t>(labels);
  return &pairwise[pair_index(i, j, nodes) * cells];
}

double StoredMrf::energy(const Labelling& labelling) const {
  const auto label = [&](int node) { return labelling[static_cast<std::size_t>(node)]; };
  double energy = 0;
  for (int i = 0; i < nodes; ++i) {
    energy += unary[static_cast<std::size_t>(i * labels + label(i))];
    for (int j = i + 1; j < nodes; ++j) energy += pair(i, j)[label(i) * labels + label(j)];
  }
  return energy;
}

Result<StoredMrf> store(const MatchingProblem& problem, std::uint64_t limit_bytes, const Progress& progress) {
  if (auto good = check(problem); !good) return tl::unexpected(good.error());
  const int nodes = problem.nodes();
  const int labels = problem.labels();
  const auto cells = static_cast<std::uint64_t>(labels) * static_cast<std::uint64_t>(labels);
  const std::uint64_t bytes = sizeof(double) * cells * problem.pairs_of_nodes();  // below 2^51 by check()
  if (bytes > limit_bytes) {
    return failure("mrf-too-large", GLISSON_TEXT("The written-out field needs {0} MB; {1} MB are allowed."),
                   {std::to_string(bytes >> 20), std::to_string(limit_bytes >> 20)});
  }

  StoredMrf mrf{nodes, labels, std::vector<double>(static_cast<std::size_t>(nodes * labels), 0.0), {}};
  if (problem.seed.size() > 0) {
    for (int node = 0; node < nodes; ++node)
      for (int label = 0; label < labels; ++label)
        mrf.unary[static_cast<std::size_t>(node * labels + label)] = problem.seed(node, label);
  }
  mrf.pairwise.resize(cells * problem.pairs_of_nodes());
  double* cell = mrf.pairwise.data();
  for (int i = 0; i < nodes; ++i) {
    for (int j = i + 1; j < nodes; ++j) {
      if (progress.cancelled()) return cancelled();
      const double x = problem.source_mm(i, j);
      for (int k = 0; k < labels; ++k) {
        for (int l = 0; l < labels; ++l) {
          const double y = problem.target_mm(k, l);
          *cell++ =
              problem.q * std::exp(-std::min(x, y) / problem.sigma_mm) * std::min(std::abs(x - y), problem.tau_mm);
        }
      }
    }
  }
  return mrf;
}

StopReason reason_to_stop(const std::vector<SolverPass>& passes, const SolverOptions& options) {
  if (options.stopping == Stopping::dynamic && !passes.empty()) {
    const auto better = [](const SolverPass& a, const SolverPass& b) { return a.energy < b.energy; };
    const auto best = std::min_element(passes.begin(), passes.end(), better);
    double bound = -std::numeric_limits<double>::infinity();
    for (const SolverPass& pass : passes) bound = std::max(bound, pass.lower_bound);
    if (best->energy - bound <= options.relative_gap * std::abs(best->energy)) return StopReason::bound_met;
    if (passes.end() - best > options.patience) return StopReason::energy_stopped_falling;
  }
  return static_cast<int>(passes.size()) >= options.passes ? StopReason::all_passes_done : StopReason::not_run;
}

}  // namespace glisson::registration
