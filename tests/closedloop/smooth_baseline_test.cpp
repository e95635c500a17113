// What an explanation has to beat: a smooth function of what was done.

#include "closedloop/inference/smooth_baseline.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

Observations observations_of(const test::Answer& answer, double noise_kPa, unsigned seed) {
  return material_model(test::compression_tests(answer, noise_kPa, seed)).value()->observations();
}

TEST(SmoothBaseline, ALawThatIsRightIsBetterEvidenceThanASmoothFunction) {
  const auto stiffer = [](const MaterialTrial& trial) { return Eigen::VectorXd(1.2 * test::straight_line(trial)); };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Observations all = observations_of(stiffer, 0.2, seed);
    const Eigen::VectorXd declared = all.measured - 20 * all.load, explained = all.measured - 24 * all.load;
    EXPECT_GT(evidence_over_smooth(all, declared, explained, 1, 1), 10) << seed;
  }
}

TEST(SmoothBaseline, ALawThatIsWrongIsNot) {
  // Drift with time, "explained" by the stiffness that comes nearest to it.
  const auto drifting = [](const MaterialTrial& trial) {
    return Eigen::VectorXd(test::straight_line(trial) + 0.02 * trial.time_s);
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Observations all = observations_of(drifting, 0.2, seed);
    const Eigen::VectorXd declared = all.measured - 20 * all.load;
    const Eigen::VectorXd explained = declared - declared.dot(all.load) / all.load.squaredNorm() * all.load;
    EXPECT_LT(evidence_over_smooth(all, declared, explained, 1, 1), -10) << seed;
  }
}

TEST(SmoothBaseline, OfNothingButNoiseNeitherIsEvidence) {
  const Observations all = observations_of(test::straight_line, 0.2, 1);
  const Eigen::VectorXd noise = all.measured - 20 * all.load;
  // The baseline's function vanishes; what is left between the two is what their numbers cost: 1 amplitude and 5
  // lengths (load, rate, way, time, largest load) of ln 400 against none.
  EXPECT_NEAR(evidence_over_smooth(all, noise, noise, 0, 1), 6 * std::log(400.0), 6);
}

}  // namespace
}  // namespace glisson::closedloop
