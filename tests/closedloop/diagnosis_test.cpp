// From made-up tests with a known undeclared effect back to the effect.

#include "closedloop/inference/diagnosis.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "closedloop/explanation_file.h"
#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

using test::Answer;
using testing::Contains;

Explanation explained(const Material& material, const DiagnosisOptions& options = {}) {
  const auto model = material_model(material).value();
  auto explanation = diagnose(*model, options);
  EXPECT_TRUE(explanation) << explanation.error().message();
  return std::move(*explanation);
}

// The kind, or one that is named as alike.
bool names(const Explanation& explanation, const std::string& kind) {
  return std::any_of(explanation.effects.begin(), explanation.effects.end(), [&](const FoundEffect& effect) {
    return effect.kind == kind || std::count(effect.alike.begin(), effect.alike.end(), kind) > 0;
  });
}

TEST(Diagnosis, NothingIsAddedToAModelThatIsRight) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Explanation e = explained(test::compression_tests(test::straight_line, 0.1, seed));
    EXPECT_EQ(e.verdict, Verdict::nothing_missing) << seed;
    EXPECT_TRUE(e.effects.empty());
    EXPECT_EQ(e.after.rms, e.before.rms);
  }
}

struct Case {
  std::string kind;
  double noise_kPa;
  Answer answer;
};

TEST(Diagnosis, OneUndeclaredEffectIsNamedAndPredictsTrialsLeftOut) {
  const std::vector<Case> cases{
      {"stiffness-scale", 0.1, [](const auto& trial) { return Eigen::VectorXd(1.25 * test::straight_line(trial)); }},
      {"strain-stiffening", 0.1,
       [](const auto& trial) {
         // Veronda and Westmann's exponential, which is in no form of the catalogue.
         const Eigen::ArrayXd l = trial.stretch.array();
         return Eigen::VectorXd(20.0 / 3 * (l - l.pow(-2)) * (1.5 * (l.square() + 2 / l - 3)).exp());
       }},
      {"viscoelastic-creep", 0.1,
       [](const auto& trial) { return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12); }},
      {"force-bias", 0.1, [](const auto& trial) { return Eigen::VectorXd(test::straight_line(trial).array() + 0.7); }},
      {"hysteresis", 0.1,
       [](const auto& trial) {
         Eigen::VectorXd stress = test::straight_line(trial);
         for (Eigen::Index i = 1; i < stress.size(); ++i)
           if (trial.stretch[i] > trial.stretch[i - 1]) stress[i] *= 0.7;
         return stress;
       }},
      {"softening", 0.02,
       [](const auto& trial) {
         Eigen::VectorXd stress = test::straight_line(trial);
         double lowest = 1;
         for (Eigen::Index i = 0; i < stress.size(); ++i) {
           if (trial.stretch[i] > lowest) stress[i] *= 1 - 0.3 * (1 - (1 - trial.stretch[i]) / (1 - lowest));
           lowest = std::min(lowest, trial.stretch[i]);
         }
         return stress;
       }},
  };
  for (const Case& one : cases) {
    const Explanation e = explained(test::compression_tests(one.answer, one.noise_kPa));
    EXPECT_EQ(e.verdict, Verdict::explained) << one.kind;
    EXPECT_EQ(e.effects.size(), 1u) << one.kind;
    EXPECT_TRUE(names(e, one.kind)) << one.kind << ", found " << (e.effects.empty() ? "-" : e.effects[0].kind);
    EXPECT_GT(e.before.rms, 2.5 * one.noise_kPa) << one.kind;
    EXPECT_LT(e.held_out->rms, 1.1 * one.noise_kPa) << one.kind;
  }
}

TEST(Diagnosis, ParametersComeWithAnUncertaintyThatHoldsTheTruth) {
  int inside = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Explanation e = explained(test::compression_tests(
        [](const auto& trial) { return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12); }, 0.1,
        seed));
    ASSERT_EQ(e.effects.size(), 1u);
    ASSERT_EQ(e.effects[0].kind, "viscoelastic-creep");
    const FoundParameter& time_s = e.effects[0].parameters[1];
    inside += time_s.low <= 12 && time_s.high >= 12 ? 1 : 0;
    EXPECT_NEAR(time_s.value, 12, 2);
  }
  EXPECT_GE(inside, 16);  // 19 of 20 are expected
}

TEST(Diagnosis, TwoEffectsThatActTogetherAreBothNamed) {
  const Explanation e = explained(test::compression_tests(
      [](const auto& trial) {
        const Eigen::ArrayXd strain = trial.stretch.array() - 1;
        return test::relaxing(20 * strain * (1 + 8 * strain.square()), trial.time_s, 0.35, 10);
      },
      0.08));
  EXPECT_EQ(e.verdict, Verdict::explained);
  EXPECT_TRUE(names(e, "strain-stiffening"));
  EXPECT_TRUE(names(e, "viscoelastic-creep"));
  ASSERT_EQ(e.effects.size(), 2u);
  EXPECT_GE(e.effects[0].removed_rms, e.effects[1].removed_rms);
}

TEST(Diagnosis, WhatTheseDataCannotTellApartIsNamedTogether) {
  const Explanation e = explained(test::compression_tests(
      [](const auto& trial) { return Eigen::VectorXd(1.2 * test::straight_line(trial)); }, 0.1));
  EXPECT_TRUE(names(e, "stiffness-scale"));
  EXPECT_TRUE(names(e, "force-bias"));  // a load cell that reads a fifth too much
}

TEST(Diagnosis, WhatIsInNoCatalogueIsNotGivenAName) {
  const std::vector<Answer> answers{
      [](const auto& trial) {  // a machine that rings
        return Eigen::VectorXd(test::straight_line(trial).array() + 0.5 * (1.7 * trial.time_s.array()).sin());
      },
      [](const auto& trial) {  // one specimen that slips out of its seat
        Eigen::VectorXd stress = test::straight_line(trial);
        if (trial.id == "held-far") stress.tail(40) *= 0.7;
        return stress;
      }};
  for (const Answer& answer : answers) {
    const Explanation e = explained(test::compression_tests(answer, 0.1));
    EXPECT_EQ(e.verdict, Verdict::unexplained);
    EXPECT_FALSE(e.residual_after.shape().empty());
  }
}

// A slider of friction that gives way at `width` of strain, behind a straight line `factor` times as stiff as declared.
Eigen::VectorXd with_friction(const MaterialTrial& trial, double factor, double friction_kPa, double width) {
  Eigen::VectorXd stress = factor * test::straight_line(trial);
  double slider = 0;
  for (Eigen::Index i = 1; i < stress.size(); ++i) {
    slider = std::clamp(slider + (trial.stretch[i] - trial.stretch[i - 1]) / width, -1.0, 1.0);
    stress[i] += friction_kPa * slider;
  }
  return stress;
}

TEST(Diagnosis, WhatFitsBestAloneMakesWayForTwoThatAreThere) {
  // A wide slider looks like more stiffness: alone it does best, and the steps from there do not reach the narrow one.
  for (const double factor : {0.6, 1.8}) {
    const Explanation e = explained(
        test::compression_tests([&](const auto& trial) { return with_friction(trial, factor, 1.2, 0.015); }, 0.15));
    EXPECT_EQ(e.verdict, Verdict::explained) << factor;
    EXPECT_EQ(e.effects.size(), 2u) << factor;
    EXPECT_TRUE(names(e, "stiffness-scale")) << factor;
    EXPECT_TRUE(names(e, "hysteresis")) << factor;
    EXPECT_LT(e.held_out->rms, 1.1 * 0.15) << factor;
  }
}

TEST(Diagnosis, CausesThatASmoothFunctionReplacesAreNotNamedWithConfidence) {
  // A grip that loses 0.8 % of strain each time the stress passes a further 1.2 kPa, at about twice the noise: three
  // causes of the catalogue bent together come as near to it as anything.
  const auto slipping = [](const MaterialTrial& trial) {
    Eigen::VectorXd stress(trial.stretch.size());
    double lost = 0, passed = 0;
    for (Eigen::Index i = 0; i < stress.size(); ++i) {
      stress[i] = 20 * (trial.stretch[i] - 1 + lost);
      while (-stress[i] > passed + 1.2) {
        passed += 1.2;
        lost += 0.008;
      }
    }
    return stress;
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Explanation e = explained(test::compression_tests(slipping, 0.25, seed));
    EXPECT_EQ(e.verdict, Verdict::unexplained) << seed;
  }
}

TEST(Diagnosis, ASingleTrialIsExplainedWithoutClaimsAboutOthers) {
  Material material =
      test::compression_tests([](const auto& trial) { return Eigen::VectorXd(1.3 * test::straight_line(trial)); }, 0.1);
  material.trials.resize(1);
  const Explanation e = explained(material);
  EXPECT_TRUE(names(e, "stiffness-scale"));
  EXPECT_FALSE(e.held_out.has_value());
}

// A candidate that cannot be solved goes with its reason, and the others stay.
class WithoutSolution : public ForwardModel {
 public:
  explicit WithoutSolution(std::unique_ptr<ForwardModel> model)
      : model_(std::move(model)), catalogue_(model_->catalogue()) {
    catalogue_.push_back({"anisotropy", "", {{"ratio", 1, 0.1, 10, 0.5, 2}}, "", {Eigen::VectorXd::Ones(1)}});
  }
  [[nodiscard]] const Observations& observations() const override { return model_->observations(); }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override {
    for (const Setting& setting : settings) {
      if (setting.kind == "anisotropy") return failure("no-solution", "The matrix is singular.");
    }
    return model_->predict(settings);
  }

 private:
  std::unique_ptr<ForwardModel> model_;
  std::vector<Effect> catalogue_;
};

TEST(Diagnosis, ACandidateThatCannotBeSolvedLeavesAloneAndSaysWhy) {
  const WithoutSolution model(
      material_model(test::compression_tests(
                         [](const auto& trial) { return Eigen::VectorXd(1.3 * test::straight_line(trial)); }, 0.1))
          .value());
  const auto e = diagnose(model);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->verdict, Verdict::explained);
  const auto gone = std::find_if(e->ranking.begin(), e->ranking.end(),
                                 [](const RankedCandidate& candidate) { return candidate.kind == "anisotropy"; });
  ASSERT_NE(gone, e->ranking.end());
  EXPECT_FALSE(gone->removed.empty());
}

TEST(Explanation, ItsReportIsTheContractsAndItsModelPredictsWhatWasFitted) {
  const TemporaryFolder folder;
  const Material material = test::compression_tests(
      [](const auto& trial) { return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12); }, 0.1);
  const Experiment experiment{"e.json", "creep", material};
  const auto model = material_model(material).value();
  const Explanation e = diagnose(*model).value();
  const Json report = report_json(e, model->observations());
  EXPECT_EQ(report["verdict"], "explained");
  EXPECT_EQ(report["unit"], "kPa");
  for (const char* key : {"before", "after", "effects", "ranking", "next_measurement"})
    EXPECT_TRUE(report.contains(key));
  EXPECT_GT(report["before"]["reduced_chi2"], 5);
  EXPECT_LT(report["after"]["held_out_rms"], 0.12);
  const Json& creep = report["effects"][0];
  EXPECT_NEAR(creep["parameters"]["amplitude"]["value"], 0.3, 0.02);
  EXPECT_LT(creep["evidence"]["delta_bic"], -100);

  ASSERT_TRUE(write_text_file(folder.path() / "model.json", model_text(e, *model, experiment)));
  const auto better = read_model(folder.path() / "model.json", *model, experiment);
  ASSERT_TRUE(better) << better.error().message();
  EXPECT_LT((predict_with(*model, *better).value() - e.predicted_after).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Explanation, AModelIsReadForTrialsThatCouldNotHaveShownIt) {
  // Hysteresis learnt from cycles, for a specimen that is only loaded.
  const TemporaryFolder folder;
  Material ramps = test::compression_tests(test::straight_line, 0.1);
  ramps.trials.resize(2);
  const auto model = material_model(ramps).value();
  ASSERT_FALSE(std::any_of(model->catalogue().begin(), model->catalogue().end(),
                           [](const Effect& effect) { return effect.kind == "hysteresis"; }));
  ASSERT_TRUE(write_text_file(folder.path() / "m.json",
                              R"({"format": "glisson-closedloop-model/1", "kind": "material",
                                  "effects": [{"kind": "hysteresis", "law": "friction",
                                               "parameters": {"friction_kPa": 1.5, "slip_strain": 0.01}}]})"));
  const auto better = read_model(folder.path() / "m.json", *model, {"e.json", "", ramps});
  ASSERT_TRUE(better) << better.error().message();
  const Eigen::VectorXd more = predict_with(*model, *better).value() - model->predict({}).value();
  EXPECT_NEAR(more[59], -1.5, 0.05);  // at the end of the first ramp all of it slides
}

TEST(Explanation, AModelThatKnowsOtherEffectsIsRefused) {
  const TemporaryFolder folder;
  const Material material = test::compression_tests(test::straight_line, 0.1);
  const auto model = material_model(material).value();
  const Experiment experiment{"e.json", "", material};
  const auto refusal = [&](const std::string& text) {
    EXPECT_TRUE(write_text_file(folder.path() / "m.json", text));
    const auto read = read_model(folder.path() / "m.json", *model, experiment);
    return read ? "it was read" : read.error().code;
  };
  EXPECT_EQ(refusal("{}"), "model-invalid");
  EXPECT_EQ(refusal(R"({"format": "glisson-closedloop-model/1", "kind": "palpation", "effects": []})"),
            "model-invalid");
  EXPECT_EQ(refusal(R"({"format": "glisson-closedloop-model/1", "kind": "material",
                        "effects": [{"kind": "capsule", "parameters": {}}]})"),
            "model-invalid");
  EXPECT_EQ(refusal(R"({"format": "glisson-closedloop-model/1", "kind": "material",
                        "effects": [{"kind": "stiffness-scale", "parameters": {}}]})"),
            "model-invalid");
}

}  // namespace
}  // namespace glisson::closedloop
