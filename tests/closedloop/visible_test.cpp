// From which size on an effect would have been seen, against planting it there many times.

#include "closedloop/inference/visible.h"

#include <gmock/gmock.h>

#include "base/json.h"
#include "closedloop/explanation_file.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

constexpr double noise_kPa = 0.3;

std::vector<SmallestVisible> visible_in(const Material& material) {
  const auto model = material_model(material).value();
  const Whitening whitening(model->observations().noise, {}, all_rows(model->observations()));
  return smallest_visible(*model, {}, whitening, {}).value();
}

const SmallestVisible& of(const std::vector<SmallestVisible>& all, const std::string& kind) {
  return *std::find_if(all.begin(), all.end(), [&](const SmallestVisible& one) { return one.kind == kind; });
}

// The effect is planted by what the tests' own formulas make of it.
int seen(const test::Answer& answer, int repetitions) {
  int count = 0;
  for (int seed = 0; seed < repetitions; ++seed) {
    const auto model = material_model(test::compression_tests(answer, noise_kPa, 100 + unsigned(seed))).value();
    count += diagnose(*model).value().verdict == Verdict::nothing_missing ? 0 : 1;
  }
  return count;
}

TEST(SmallestVisible, IsFoundInNineOfTenAndHalfOfItSeldomAndTwiceAlways) {
  const auto all = visible_in(test::compression_tests(test::straight_line, noise_kPa));
  const double factor = of(all, "stiffness-scale").value.value();
  const double amplitude = of(all, "viscoelastic-creep").value.value();
  const double time_s = [&] {
    const auto model = material_model(test::compression_tests(test::straight_line, noise_kPa)).value();
    for (const Effect& effect : model->catalogue())
      if (effect.kind == "viscoelastic-creep" && effect.form.empty()) return effect.parameters[1].no_effect;
    return 0.0;
  }();
  const auto stiffer = [&](double times) {
    return [=](const MaterialTrial& trial) {
      return Eigen::VectorXd(std::pow(factor, times) * test::straight_line(trial));
    };
  };
  const auto creeping = [&](double times) {
    return [=](const MaterialTrial& trial) {
      return test::relaxing(test::straight_line(trial), trial.time_s, times * amplitude, time_s);
    };
  };
  constexpr int repetitions = 6;                          // each weighs all explanations
  EXPECT_GE(seen(stiffer(1), repetitions), 4) << factor;  // 5.4 expected
  EXPECT_LE(seen(stiffer(0.5), repetitions), 4) << factor;
  EXPECT_EQ(seen(stiffer(2), repetitions), repetitions) << factor;
  EXPECT_GE(seen(creeping(1), repetitions), 4) << amplitude;
  EXPECT_LE(seen(creeping(0.5), repetitions), 4) << amplitude;
  EXPECT_EQ(seen(creeping(2), repetitions), repetitions) << amplitude;
}

TEST(SmallestVisible, GrowsWithTheNoiseAndStandsWithNothingMissing) {
  const auto factor_at = [](double noise) {
    return of(visible_in(test::compression_tests(test::straight_line, noise)), "stiffness-scale").value.value();
  };
  EXPECT_NEAR((factor_at(0.4) - 1) / (factor_at(0.1) - 1), 4, 0.4);

  const auto model = material_model(test::compression_tests(test::straight_line, 0.1)).value();
  const Explanation explanation = diagnose(*model).value();
  ASSERT_EQ(explanation.verdict, Verdict::nothing_missing);
  const Json report = report_json(explanation, model->observations());
  ASSERT_EQ(report["smallest_visible"].size(), explanation.smallest_visible.size());
  EXPECT_EQ(report["smallest_visible"][0]["kind"], "stiffness-scale");
  EXPECT_GT(report["smallest_visible"][0]["value"], 1.0);
  EXPECT_THAT(visible_sentence(explanation), testing::HasSubstr("stiffness-scale (factor) from 1.0"));
}

}  // namespace
}  // namespace glisson::closedloop
