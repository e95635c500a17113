// A probability for each explanation: its evidence against an independent estimate, and what it says of made-up tests.

#include "closedloop/inference/posterior.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <numbers>
#include <random>

#include "base/json.h"
#include "closedloop/explanation_file.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/inference/internal/rest_blocks.h"
#include "closedloop/inference/smooth_rest.h"
#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

using testing::HasSubstr;

const PosteriorOptions posterior_options;

double log_mean(const std::vector<double>& logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - highest);
  return highest + std::log(sum / double(logs.size()));
}

// ln of the likelihood whatever the noise's size, on a plain grid of it.
double log_likelihood(double chi2, double rows) {
  std::vector<double> logs;
  constexpr int count = 4001;
  constexpr double low = -1, high = 3;
  for (int i = 0; i < count; ++i) {
    const double log_scale = low + (high - low) * i / (count - 1);
    logs.push_back(-rows * log_scale - chi2 / 2 * std::exp(-2 * log_scale) +
                   log_density_of_noise_scale(log_scale, posterior_options).value);
  }
  return log_mean(logs) + std::log(high - low);
}

// By importance sampling from a broad Student's t of 4 degrees about `middle`: it needs no shape of the posterior.
double sampled_log_evidence(const ForwardModel& model, const Whitening& whitening, const LocalFit& middle,
                            int samples) {
  const ParameterPrior prior = prior_of(model, middle.settings, posterior_options);
  const Eigen::VectorXd at = prior.inward(values_of(middle.settings));
  const Eigen::VectorXd slope = prior.slope(values_of(middle.settings));
  const auto size = at.size();
  const Eigen::MatrixXd precision = (slope.asDiagonal() * middle.information * slope.asDiagonal()) /
                                        std::max(1.0, middle.chi2 / double(middle.rows)) +
                                    Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> covariance(1.5 * precision.inverse());
  const Eigen::MatrixXd root = covariance.matrixL();
  double log_mass = 0;
  for (Eigen::Index p = 0; p < size; ++p)
    log_mass += std::log(0.5 * (std::erf(prior.upper[p] / std::sqrt(2)) - std::erf(prior.lower[p] / std::sqrt(2))));
  constexpr double degrees = 4;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::chi_squared_distribution<double> chi_squared(degrees);
  std::vector<double> logs;
  for (int i = 0; i < samples; ++i) {
    Eigen::VectorXd z(size);
    for (double& value : z) value = normal(random);
    z *= std::sqrt(degrees / chi_squared(random));
    const Eigen::VectorXd u = at + root * z;
    if ((u.array() < prior.lower.array()).any() || (u.array() > prior.upper.array()).any()) {
      logs.push_back(-1e300);
      continue;
    }
    const auto predicted = model.predict(with_values(middle.settings, prior.outward(u)));
    if (!predicted) {
      logs.push_back(-1e300);
      continue;
    }
    const double chi2 = whitening.whiten(model.observations().measured - *predicted).squaredNorm();
    const double n = double(size);
    const double log_proposal = std::lgamma((degrees + n) / 2) - std::lgamma(degrees / 2) -
                                n / 2 * std::log(degrees * std::numbers::pi) - root.diagonal().array().log().sum() -
                                (degrees + n) / 2 * std::log1p(z.squaredNorm() / degrees);
    logs.push_back(log_likelihood(chi2, double(middle.rows)) - 0.5 * u.squaredNorm() -
                   n / 2 * std::log(2 * std::numbers::pi) - log_mass - log_proposal);
  }
  return log_mean(logs);
}

struct Weak {
  std::string kind, form;
  double tolerance;  // nats
};

TEST(Evidence, LaplacesMethodComesToWhatSamplingDoes) {
  // Creep of about half the noise, as each candidate sees it: one parameter, two, one with a bound at nothing, and a
  // law that is far from linear in its parameters. Where an explanation is hundreds of nats worse than another, Laplace
  // may be off by one or two (Ogden's law here), which matters to no probability.
  const auto model = material_model(test::compression_tests(
                                        [](const auto& trial) {
                                          return test::relaxing(test::straight_line(trial), trial.time_s, 0.15, 12);
                                        },
                                        1.0))
                         .value();
  const Whitening whitening(model->observations().noise, {}, all_rows(model->observations()));
  for (const Weak& one : {Weak{"stiffness-scale", "", 0.1}, Weak{"viscoelastic-creep", "", 0.4},
                          Weak{"force-bias", "", 0.1}, Weak{"strain-stiffening", "exponential", 0.3},
                          Weak{"softening", "drop", 0.3}, Weak{"hysteresis", "friction", 0.7}}) {
    const auto effect = std::find_if(model->catalogue().begin(), model->catalogue().end(), [&](const Effect& known) {
      return known.kind == one.kind && known.form == one.form;
    });
    ASSERT_NE(effect, model->catalogue().end()) << one.kind;
    std::optional<Fit> best;
    for (const Eigen::VectorXd& start : effect->starts) {
      auto fitted = fit(*model, {{one.kind, one.form, start}}, whitening);
      ASSERT_TRUE(fitted) << fitted.error().message();
      if (!best || fitted->chi2 < best->chi2) best = std::move(*fitted);
    }
    const LocalFit middle = at_maximum(*model, whitening, local_fit(*best, whitening), 1, posterior_options);
    const double laplace = log_evidence(*model, middle, 1, posterior_options).evidence;
    EXPECT_NEAR(laplace, sampled_log_evidence(*model, whitening, middle, 6000), one.tolerance) << one.kind;
  }
}

TEST(Evidence, OfAnEffectThatTheDataDoNotShowIsThatOfTheModelWithoutIt) {
  // Its parameters stay as open as they were, and cost nothing.
  const auto model = material_model(test::compression_tests(test::straight_line, 200)).value();
  const Whitening whitening(model->observations().noise, {}, all_rows(model->observations()));
  const auto evidence_of = [&](const Settings& settings) {
    return log_evidence(*model, local_fit(without_fitting(*model, settings, whitening).value(), whitening), 1,
                        posterior_options)
        .evidence;
  };
  EXPECT_NEAR(evidence_of({{"stiffness-scale", "", Eigen::VectorXd::Ones(1)}}), evidence_of({}), 0.05);
}

// As of a plate: displacements at a thousand points, and the forces at its borders, which alone may tell a stiffness.
TEST(SmoothEvidence, RestsOnAFewForcesAmongManyPointsToo) {
  Observations all;
  all.directions = {"x", "force"};
  all.quantities = {0, 1};
  all.trials = {"pull"};
  std::vector<Observation> rows;
  for (int n = 0; n < 1005; ++n) {
    Observation row;
    row.noise = 1;
    row.direction = n < 1000 ? 0 : 1;
    row.point = n;
    row.place_mm = Eigen::Vector3d(n, 0, 0);
    rows.push_back(row);
  }
  all.add(rows);
  const Grouping groups = grouped(all, 240);
  EXPECT_LE(groups.size(), 240u);
  EXPECT_EQ(std::count_if(groups.begin(), groups.end(), [](const auto& group) { return group.front() >= 1000; }), 5);
}

TEST(SmoothEvidence, FindsASmoothFunctionAndNoneInNoise) {
  const auto of = [](const test::Answer& answer) {
    const auto model = material_model(test::compression_tests(answer, 0.2)).value();
    const Observations& all = model->observations();
    const SmoothEvidence evidence = smooth_evidence(all, {}, all.measured - 20 * all.load, posterior_options);
    return evidence.smooth - evidence.noise;
  };
  EXPECT_LT(of(test::straight_line), -1);
  EXPECT_GT(of([](const auto& trial) { return Eigen::VectorXd(test::straight_line(trial) + 0.02 * trial.time_s); }),
            50);
}

TEST(SmoothEvidence, TakesNoiseThatRepeatsItselfForNoiseAndNotRipplesThatDo) {
  const auto of = [](const std::function<double(double time_s, double& state)>& added) {
    test::Answer answer = [&](const auto& trial) {
      Eigen::VectorXd stress = test::straight_line(trial);
      double state = 0;
      for (Eigen::Index i = 0; i < stress.size(); ++i) stress[i] += added(trial.time_s[i], state);
      return stress;
    };
    const auto model = material_model(test::compression_tests(answer, 0.2)).value();
    const Observations& all = model->observations();
    const SmoothEvidence evidence = smooth_evidence(all, {}, all.measured - 20 * all.load, posterior_options);
    return evidence.smooth - evidence.noise;
  };
  // The helper's own noise of 0.2 is added to what stands here.
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  EXPECT_LT(of([&](double, double& state) { return state = 0.7 * state + 0.08 * normal(random); }), 3);
  EXPECT_GT(of([](double time_s, double&) { return 0.25 * (std::fmod(time_s, 12) < 6 ? 1 : -1); }), 10);
}

const WeighedExplanation& likeliest(const Explanation& explanation) { return explanation.posterior.front(); }

TEST(Posterior, SaysWhatTheVerdictSaysWhereTheAnswerIsClear) {
  const auto explained = [](const test::Answer& answer, double noise_kPa) {
    return diagnose(*material_model(test::compression_tests(answer, noise_kPa)).value()).value();
  };
  const Explanation nothing = explained(test::straight_line, 0.1);
  EXPECT_EQ(nothing.verdict, Verdict::nothing_missing);
  EXPECT_EQ(name_of(likeliest(nothing)), "nothing is missing");
  EXPECT_GT(likeliest(nothing).probability, 0.8);
  EXPECT_THAT(posterior_sentence(nothing).message(), HasSubstr("nothing is missing"));

  const Explanation creep = explained(
      [](const auto& trial) { return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12); }, 0.1);
  EXPECT_EQ(creep.verdict, Verdict::explained);
  EXPECT_EQ(likeliest(creep).kinds, std::vector<std::string>{"viscoelastic-creep"});
  EXPECT_GT(likeliest(creep).probability, 0.9);

  const Explanation ringing = explained(
      [](const auto& trial) {
        return Eigen::VectorXd(test::straight_line(trial).array() + 0.5 * (1.7 * trial.time_s.array()).sin());
      },
      0.1);
  EXPECT_EQ(ringing.verdict, Verdict::unexplained) << posterior_sentence(ringing).message();
  EXPECT_TRUE(likeliest(ringing).something_else);

  // A load cell that reads a fifth too much is as probable as a specimen that is a fifth stiffer.
  const Explanation either =
      explained([](const auto& trial) { return Eigen::VectorXd(1.2 * test::straight_line(trial)); }, 0.1);
  EXPECT_EQ(either.verdict, Verdict::explained) << posterior_sentence(either).message();
  EXPECT_LT(likeliest(either).probability, 0.9);
  EXPECT_GT(either.of_effects, likeliest(either).probability);
  double sum = 0;
  for (const WeighedExplanation& weighed : either.posterior) sum += weighed.probability;
  EXPECT_NEAR(sum, 1, 0.02);
}

TEST(Posterior, OfWhatThePredictionsOwnErrorHidesIsThatOfNothing) {
  // Creep fits best, a softer specimen far worse and yet far better than nothing: neither shows anything.
  Material material = test::compression_tests(
      [](const auto& trial) { return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12); }, 0.1);
  material.trials.resize(2);
  const auto model = material_model(material).value();
  const Whitening whitening(model->observations().noise, {}, all_rows(model->observations()));
  const auto fitted = [&](const std::string& kind) {
    const auto& catalogue = model->catalogue();
    const auto effect =
        std::find_if(catalogue.begin(), catalogue.end(), [&](const Effect& e) { return e.kind == kind; });
    return local_fit(fit(*model, {{kind, effect->form, effect->starts.front()}}, whitening).value(), whitening);
  };
  const std::vector<LocalFit> considered{fitted("viscoelastic-creep"), fitted("stiffness-scale")};
  ASSERT_LT(considered[0].chi2, considered[1].chi2 - 100);
  const auto leading = [&](double indistinct) {
    SystematicUncertainty systematic;
    systematic.indistinct = indistinct;
    return posterior({*model, systematic, whitening, 1}, considered, posterior_options).value().front();
  };
  EXPECT_EQ(name_of(leading(0)), "viscoelastic-creep");
  EXPECT_EQ(name_of(leading(1e4)), "nothing is missing");
}

TEST(Posterior, StandsInTheReport) {
  const auto model = material_model(test::compression_tests(test::straight_line, 0.1)).value();
  const Explanation explanation = diagnose(*model).value();
  const Json report = report_json(explanation, model->observations());
  const Json& posterior = report["posterior"];
  EXPECT_EQ(posterior["explanations"].size(), explanation.posterior.size());
  EXPECT_EQ(posterior["explanations"][0]["kinds"], Json::array());
  EXPECT_EQ(posterior["of_effects"], 0);
  EXPECT_EQ(posterior["sentence"], posterior_sentence(explanation).message());
}

TEST(Posterior, WhereNothingIsProbableEnoughTheLikeliestAreTold) {
  Explanation e;
  e.verdict = Verdict::unexplained;
  e.posterior = {{{"hysteresis"}, false, 0.5}, {{"softening"}, false, 0.4}, {{}, true, 0.1}};
  EXPECT_EQ(posterior_sentence(e).message(),
            "Nothing is probable enough to be named. Probability of hysteresis: 50 %; next comes: softening, 40 %.");
}

}  // namespace
}  // namespace glisson::closedloop
