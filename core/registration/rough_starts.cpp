#include <algorithm>
#include <random>

#include "base/parallel.h"
#include "registration/internal/rough_starts.h"
#include "registration/trwls.h"

namespace glisson::registration {
namespace {

constexpr int few_nodes = 20, few_labels = 48, starts = 16;

// Each as far as can be from those before it; the first is the one farthest from the rest.
std::vector<int> far_apart(const Eigen::MatrixXd& between_mm, int count) {
  Eigen::Index next = 0;
  between_mm.colwise().sum().maxCoeff(&next);
  Eigen::VectorXd nearest_mm = between_mm.col(next);
  std::vector<int> chosen;
  while (static_cast<int>(chosen.size()) < std::min<int>(count, static_cast<int>(between_mm.rows()))) {
    chosen.push_back(static_cast<int>(next));
    nearest_mm = nearest_mm.cwiseMin(between_mm.col(next));
    nearest_mm.maxCoeff(&next);
  }
  return chosen;
}

}  // namespace

std::vector<RoughStart> rough_starts(const MatchingProblem& problem) {
  const std::vector<int> nodes = far_apart(problem.source_mm, few_nodes);
  const std::vector<int> labels = far_apart(problem.target_mm, few_labels);
  MatchingProblem rough = problem;
  rough.source_mm = problem.source_mm(nodes, nodes);
  rough.target_mm = problem.target_mm(labels, labels);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  rough.seed = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(labels.size()));
  if (problem.seed.size() > 0)
    rough.seed = problem.seed(nodes, labels) * (static_cast<double>(count) / problem.nodes());
  // As much as a third of what a node's pairs can cost: enough to lead elsewhere.
  const double maximum_noise = 0.3 * problem.q * problem.tau_mm * static_cast<double>(count - 1);

  std::vector<RoughStart> found(starts);
  parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t start = begin; start < end; ++start) {
      std::mt19937 random(20151207 + static_cast<unsigned>(start));
      std::uniform_real_distribution<double> noise(0, maximum_noise);
      MatchingProblem noisy = rough;
      if (start > 0) {
        for (double& cost : noisy.seed.reshaped()) cost += noise(random);
      }
      TrwlsOptions solving;
      solving.passes = 4;
      solving.starts = Starts::one;
      const auto solution = trwls(noisy, solving);
      if (!solution) continue;
      found[start].nodes = nodes;
      for (const int label : solution->labels) found[start].labels.push_back(labels[static_cast<std::size_t>(label)]);
    }
  });
  return found;
}

}  // namespace glisson::registration
