// TRWL-S on an OpenCL device against the processors: the same to the last bit (PoCL where there is no GPU).

#include <gtest/gtest.h>

#include "problems.h"
#include "registration/trwls.h"
#include "support/opencl.h"

namespace glisson::registration {
namespace {

void expect_the_same_on_a_device(const MatchingProblem& problem, TrwlsOptions options) {
  const auto here = trwls(problem, options).value();
  options.device = "";
  const auto there = trwls(problem, options);
  ASSERT_TRUE(there) << there.error().message();
  EXPECT_EQ(there->labels, here.labels);
  EXPECT_EQ(there->energy, here.energy);
  EXPECT_EQ(there->lower_bound, here.lower_bound);
  EXPECT_EQ(there->stopped, here.stopped);
  ASSERT_EQ(there->passes.size(), here.passes.size());
  for (std::size_t pass = 0; pass < here.passes.size(); ++pass) {
    EXPECT_EQ(there->passes[pass].energy, here.passes[pass].energy) << pass;
    EXPECT_EQ(there->passes[pass].lower_bound, here.passes[pass].lower_bound) << pass;
  }
}

TEST(TrwlsOnADevice, AnswersTheSameToTheLastBit) {
  GLISSON_NEEDS_OPENCL();
  TrwlsOptions fixed;
  fixed.passes = 4;
  fixed.stopping = Stopping::fixed_passes;
  for (const int count : {2, 3, 5, 31, 64, 97, 130}) {
    SCOPED_TRACE(count);
    expect_the_same_on_a_device(test::shuffled_points(count, 6, static_cast<unsigned>(count)).problem, fixed);
  }
}

TEST(TrwlsOnADevice, TakesAsManyLabelsAsThereAreAndSeeds) {
  GLISSON_NEEDS_OPENCL();
  MatchingProblem problem = test::shuffled_points(70, 6, 3).problem;
  problem.source_mm = test::shuffled_points(40, 6, 1).problem.source_mm;  // 40 nodes, 70 labels
  problem.seed = Eigen::MatrixXd::Random(40, 70).cwiseAbs() * 40;
  expect_the_same_on_a_device(problem, {});
  problem.source_mm = test::shuffled_points(90, 6, 1).problem.source_mm;
  problem.seed.resize(0, 0);
  expect_the_same_on_a_device(problem, {});
}

TEST(TrwlsOnADevice, IsCancelledBetweenSweeps) {
  GLISSON_NEEDS_OPENCL();
  std::stop_source stop;
  TrwlsOptions options;
  options.passes = 1000;
  options.stopping = Stopping::fixed_passes;
  options.device = "";
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  const auto solution = trwls(test::shuffled_points(40, 6, 3).problem, options, progress);
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->stopped, StopReason::cancelled);
  EXPECT_EQ(solution->passes.size(), 1u);
}

TEST(TrwlsOnADevice, AnUnknownDeviceIsRefused) {
  GLISSON_NEEDS_OPENCL();
  TrwlsOptions options;
  options.device = "no such device";
  EXPECT_EQ(trwls(test::shuffled_points(5, 6, 3).problem, options).error().code, "opencl-no-device");
}

}  // namespace
}  // namespace glisson::registration
