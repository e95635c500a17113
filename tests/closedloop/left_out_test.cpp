// A law that follows all trials and runs away from any that it did not see: no error is told of it, and it names
// nothing.

#include <gmock/gmock.h>

#include <cmath>

#include "base/json.h"
#include "closedloop/explanation_file.h"
#include "closedloop/inference/diagnosis.h"

namespace glisson::closedloop {
namespace {

// Measured is twice the load. Declared is the load itself, and either more of it or an exponential may be added.
class Runaway : public ForwardModel {
 public:
  Runaway() {
    observations_.unit = "mm";
    observations_.directions = {"x"};
    observations_.trials = {"a", "b", "c", "d", "e"};
    std::vector<Observation> rows;
    for (int trial = 0; trial < 5; ++trial) {
      for (int sample = 0; sample < 6; ++sample) {
        const double load = 0.2 * (trial + 1) - 0.01 * sample;
        const double noise = 0.01 * std::sin(37.0 * trial + 91.0 * sample * sample);
        rows.push_back({.measured = 2 * load + noise,
                        .noise = 0.01,
                        .trial = trial,
                        .sample = sample,
                        .point = static_cast<int>(rows.size()),
                        .load = load});
      }
    }
    observations_.add(rows);
    const Parameter factor{"factor", 1, 0.1, 10, 0.5, 2, Scale::logarithmic};
    catalogue_ = {{"stiffness-scale", "", {factor}, "stiffer", {numbers_of({1.5})}},
                  {"exponential", "", {factor, {"k", 0, -1, 1, -1, 1}}, "an exponential", {numbers_of({1.5, 0})}}};
  }

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] bool predicts_quickly() const override { return false; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override {
    return linearise(settings).map([](const Linearisation& linear) { return linear.predicted; });
  }
  [[nodiscard]] Result<Linearisation> linearise(const Settings& settings) const override {
    const Eigen::VectorXd& load = observations_.load;
    const Eigen::VectorXd steep = (30 * load.array().square()).exp() - 1;
    Linearisation linear{load, Eigen::MatrixXd(load.size(), parameter_count(settings))};
    Eigen::Index column = 0;
    for (const Setting& setting : settings) {
      linear.predicted += (setting.parameters[0] - 1) * load;
      linear.derivatives.col(column++) = load;
      if (setting.parameters.size() < 2) continue;
      linear.predicted += setting.parameters[1] * steep;
      linear.derivatives.col(column++) = steep;
    }
    return linear;
  }

 private:
  Observations observations_;
  std::vector<Effect> catalogue_;
};

TEST(LeftOut, NoErrorIsToldOfALawThatRunsAway) {
  const Explanation found = diagnose(Runaway()).value();
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].kind, "stiffness-scale");
  EXPECT_THAT(found.effects[0].alike, testing::IsEmpty());
  ASSERT_EQ(found.ranking.size(), 2u);
  for (const RankedCandidate& candidate : found.ranking) {
    EXPECT_EQ(candidate.predicts, candidate.kind == "stiffness-scale") << candidate.kind;
    EXPECT_EQ(candidate.held_out_rms.has_value(), candidate.predicts) << candidate.kind;
  }
  const Json report = report_json(found, Runaway().observations());
  for (const Json& candidate : report["ranking"]) {
    EXPECT_EQ(candidate.contains("held_out_rms_mm"), candidate["kind"] == "stiffness-scale") << candidate;
    EXPECT_EQ(candidate.contains("held_out"), candidate["kind"] == "exponential") << candidate;
  }
  EXPECT_THAT(report["notes"].dump(), testing::HasSubstr("predicts nothing beyond what it was fitted to"));
}

}  // namespace
}  // namespace glisson::closedloop
