// The solvers of the matching field: `trws` against every labelling there is, `trwls` against `trws` and itself.

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "problems.h"
#include "registration/trws.h"

namespace glisson::registration {
namespace {

using test::least_energy;
using test::shuffled_points;

constexpr SolverOptions fixed_passes{.stopping = Stopping::fixed_passes};

TEST(MatchingProblem, WritesOutTheSameEnergyThatItStandsFor) {
  const MatchingProblem problem = shuffled_points(12, 4, 1).problem;
  const StoredMrf mrf = store(problem).value();
  const MatchingEnergy energy(problem);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any_label(0, problem.labels() - 1);
  for (int trial = 0; trial < 50; ++trial) {
    Labelling labels(12);
    for (int& label : labels) label = any_label(random);
    EXPECT_NEAR(energy(labels), mrf.energy(labels), 1e-12 * mrf.energy(labels));
  }
}

TEST(MatchingProblem, RefusesWhatIsNoMetric) {
  MatchingProblem problem = shuffled_points(5, 0, 1).problem;
  problem.source_mm(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(problem).error().code, "matching-distances");
  problem = shuffled_points(5, 0, 1).problem;
  problem.target_mm(0, 1) += 1;
  EXPECT_EQ(check(problem).error().code, "matching-distances");
  problem = shuffled_points(5, 0, 1).problem;
  problem.tau_mm = 0;
  EXPECT_EQ(check(problem).error().code, "matching-constants");
  problem = shuffled_points(5, 0, 1).problem;
  problem.seed = Eigen::MatrixXd::Zero(5, 4);
  EXPECT_EQ(check(problem).error().code, "matching-seed");
  EXPECT_EQ(check(MatchingProblem{}).error().code, "matching-too-few-points");
}

TEST(MatchingProblem, IsNotWrittenOutBeyondTheLimit) {
  EXPECT_EQ(store(shuffled_points(40, 0, 1).problem, 1 << 20).error().code, "mrf-too-large");
}

// 5 nodes of 5 labels have 3125 labellings. The bound may stay below the least energy (TRW-S is a relaxation), the
// labelling found may stay above it; it never crosses, and on most such small problems both meet.
TEST(Trws, BracketsTheLeastEnergy) {
  int met = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const MatchingProblem problem = shuffled_points(5, 5, seed).problem;
    const double least = least_energy(problem);
    const MatchingSolution solution = trws(store(problem).value(), {.passes = 100, .stopping = Stopping::fixed_passes});
    EXPECT_LE(solution.lower_bound, least + 1e-9);
    EXPECT_GE(solution.energy, least - 1e-9);
    EXPECT_NEAR(MatchingEnergy(problem)(solution.labels), solution.energy, 1e-9);
    if (solution.energy < least + 1e-9) ++met;
  }
  EXPECT_GE(met, 15);
}

TEST(Trws, NeverLowersItsBound) {
  const MatchingSolution solution = trws(store(shuffled_points(20, 6, 3).problem).value(), fixed_passes);
  ASSERT_EQ(solution.passes.size(), 20u);
  for (std::size_t pass = 1; pass < solution.passes.size(); ++pass) {
    EXPECT_GE(solution.passes[pass].lower_bound, solution.passes[pass - 1].lower_bound - 1e-9) << pass;
    EXPECT_GE(solution.passes[pass].energy, solution.lower_bound - 1e-9) << pass;
  }
}

TEST(Trws, FindsPointsAgainWhereverTheyWereShuffled) {
  const auto [problem, truth] = shuffled_points(24, 0, 7);
  const MatchingSolution solution = trws(store(problem).value());
  EXPECT_EQ(solution.labels, truth);
  EXPECT_EQ(solution.energy, 0.0);
  EXPECT_EQ(solution.stopped, StopReason::bound_met);
}

TEST(Trws, TakesItsSeedIntoAccount) {
  auto [problem, truth] = shuffled_points(8, 0, 2);
  problem.seed = Eigen::MatrixXd::Zero(8, 8);
  problem.seed(0, truth[0]) = 1e6;  // forbidden
  const MatchingSolution solution = trws(store(problem).value());
  EXPECT_NE(solution.labels[0], truth[0]);
  EXPECT_GT(solution.energy, 0);
}

}  // namespace
}  // namespace glisson::registration
