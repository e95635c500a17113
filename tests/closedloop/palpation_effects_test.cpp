// Every effect of a palpation: absent at its default, differentiated exactly, found again from what it does.

#include "closedloop/palpation/internal/effects.h"

#include <gmock/gmock.h>
#include <Eigen/Dense>

#include "closedloop/palpation/model.h"
#include "closedloop/palpation_bodies.h"

namespace glisson::closedloop {
namespace {

using test::measured_as;
using test::pad;

std::unique_ptr<ForwardModel> checked_model_of(const Palpation& experiment) {
  auto model = palpation_model(experiment);
  if (!model) throw std::runtime_error(model.error().message());
  return std::move(*model);
}

const Effect& effect_named(const ForwardModel& model, const std::string& kind, const std::string& form = "") {
  for (const Effect& effect : model.catalogue()) {
    if (effect.kind == kind && (form.empty() || effect.form == form)) return effect;
  }
  throw std::runtime_error("no effect " + kind);
}

Setting setting(const ForwardModel& model, const std::string& kind, const std::string& form,
                std::initializer_list<double> values) {
  const Effect& effect = effect_named(model, kind, form);
  return {effect.kind, effect.form,
          Eigen::Map<const Eigen::VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()))};
}

// Each effect, strong enough to be seen.
Settings examples(const ForwardModel& model) {
  return {setting(model, palpation::stiffness_scale, "", {1.3}),
          setting(model, palpation::strain_stiffening, "exponential", {8}),
          setting(model, palpation::strain_stiffening, "linear", {3}),
          setting(model, palpation::strain_stiffening, "yeoh", {3}),
          setting(model, palpation::strain_stiffening, "ogden", {9}),
          setting(model, palpation::support_compliance, "", {0.6}),
          setting(model, palpation::stiff_inclusion, "", {36, 26, 17, 9, 5}),
          setting(model, palpation::viscoelastic_creep, "prony-1", {0.4, 3}),
          setting(model, palpation::viscoelastic_creep, "prony-2", {0.2, 0.3, 1, 8}),
          setting(model, palpation::force_bias, "", {0.01, 1.2}),
          setting(model, palpation::frame_misalignment, "", {0.5, -1, 0.7, 0.3, -0.2, 0.4}),
          setting(model, palpation::anisotropy, "fibres", {0.8, 0.6, 0.1, 2}),
          setting(model, palpation::anisotropy, "engineering", {0.8, 0.6, 0.1, 2}),
          setting(model, palpation::capsule, "", {0.15}),
          setting(model, palpation::preload, "gravity", {1, -2, -9}),
          setting(model, palpation::preload, "pressure", {0.8})};
}

std::string name_of(const Setting& one) { return one.kind + " " + one.form; }

TEST(PalpationEffects, AtItsDefaultNoneChangesAnything) {
  const auto model = checked_model_of(pad());
  const Eigen::VectorXd declared = model->predict({}).value();
  ASSERT_GT(declared.cwiseAbs().maxCoeff(), 1.0);
  for (const Effect& effect : model->catalogue()) {
    Setting off{effect.kind, effect.form, Eigen::VectorXd(effect.size())};
    for (Eigen::Index p = 0; p < effect.size(); ++p) off.parameters[p] = effect.parameters[std::size_t(p)].no_effect;
    EXPECT_LT((model->predict({off}).value() - declared).cwiseAbs().maxCoeff(), 1e-10) << name_of(off);
  }
}

// Central differences of the whole prediction are the slow judge. They err by about 1e-6 of the largest derivative, the
// solver's rounding over the step; with stiffening by 1e-2, for equilibria are found to 1e-6 of their load and slopes
// to 1e-3 of themselves, which is all that a search needs.
void expect_exact_derivatives(const ForwardModel& model, const Settings& settings, const std::string& name) {
  const bool iterates = std::any_of(settings.begin(), settings.end(),
                                    [](const Setting& one) { return one.kind == palpation::strain_stiffening; });
  const double tolerance = iterates ? 1e-2 : 1e-5;
  const auto linear = model.linearise(settings).value();
  EXPECT_LT((linear.predicted - model.predict(settings).value()).cwiseAbs().maxCoeff(), 1e-9) << name;
  Eigen::Index column = 0;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    for (Eigen::Index p = 0; p < settings[s].parameters.size(); ++p, ++column) {
      const double step = (iterates ? 1e-2 : 1e-4) * std::max(0.1, std::abs(settings[s].parameters[p]));
      Settings ahead = settings, behind = settings;
      ahead[s].parameters[p] += step;
      behind[s].parameters[p] -= step;
      const Eigen::VectorXd difference = (model.predict(ahead).value() - model.predict(behind).value()) / (2 * step);
      const double scale = std::max(1e-6, difference.cwiseAbs().maxCoeff());
      EXPECT_LT((difference - linear.derivatives.col(column)).cwiseAbs().maxCoeff(), tolerance * scale)
          << name << ", parameter " << p;
    }
  }
}

TEST(PalpationEffects, DerivativesAreThoseOfThePrediction) {
  const auto model = checked_model_of(pad({.bricks = {4, 4, 2}}));
  for (const Setting& one : examples(*model)) expect_exact_derivatives(*model, {one}, name_of(one));
}

TEST(PalpationEffects, DerivativesOfEffectsThatActTogether) {
  const auto model = checked_model_of(pad({.bricks = {4, 4, 2}}));
  const Settings all = examples(*model);
  const auto named = [&](const std::string& kind) {
    return *std::find_if(all.begin(), all.end(), [&](const Setting& one) { return one.kind == kind; });
  };
  // Everything linear at once, each with the factor that scales the body but not its springs and its capsule.
  expect_exact_derivatives(
      *model,
      {named("stiffness-scale"), named("support-compliance"), named("stiff-inclusion"), named("viscoelastic-creep"),
       named("force-bias"), named("frame-misalignment"), named("anisotropy"), named("capsule"), named("preload")},
      "all linear ones");
  expect_exact_derivatives(*model,
                           {named("strain-stiffening"), named("stiffness-scale"), named("support-compliance"),
                            named("viscoelastic-creep"), named("preload"), named("frame-misalignment")},
                           "with stiffening");
}

// Levenberg and Marquardt, in the obvious way: what the starts must be good enough for.
struct Fit {
  Settings settings;
  double rms_mm = 0;
};
double rms_of(const Eigen::VectorXd& v) { return std::sqrt(v.squaredNorm() / double(v.size())); }
Fit fit(const ForwardModel& model, Settings settings) {
  const Eigen::VectorXd& measured = model.observations().measured;
  double damping = 1e-3;
  auto at = model.linearise(settings).value();
  for (int step = 0; step < 30; ++step) {
    const Eigen::VectorXd residual = measured - at.predicted;
    const Eigen::MatrixXd normal = at.derivatives.transpose() * at.derivatives;
    const Eigen::VectorXd downhill = at.derivatives.transpose() * residual;
    Eigen::MatrixXd damped = normal;
    damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(normal.rows(), 1e-12);
    const Eigen::VectorXd move = damped.ldlt().solve(downhill);
    Settings moved = settings;
    Eigen::Index column = 0;
    for (Setting& one : moved) {
      const Effect& effect = *effect_of(model, one);
      for (Eigen::Index p = 0; p < one.parameters.size(); ++p, ++column) {
        const Parameter& parameter = effect.parameters[std::size_t(p)];
        double value = one.parameters[p] + move[column];
        if (parameter.scale == Scale::logarithmic) {
          value = one.parameters[p] * std::exp(std::clamp(move[column] / one.parameters[p], -1.0, 1.0));
        }
        one.parameters[p] = std::clamp(value, parameter.lower, parameter.upper);
      }
    }
    const auto there = model.predict(moved);
    if (there && (measured - *there).squaredNorm() < residual.squaredNorm()) {
      const double gain = 1 - (measured - *there).squaredNorm() / residual.squaredNorm();
      settings = moved;
      at = model.linearise(settings).value();
      damping = std::max(1e-8, damping / 10);
      if (gain < 1e-9) break;
    } else if ((damping *= 10) > 1e6) {
      break;
    }
  }
  return {settings, rms_of(measured - at.predicted)};
}
Fit best_fit(const ForwardModel& model, const Effect& effect, const Settings& active = {}) {
  const Eigen::VectorXd residual = model.observations().measured - model.predict(active).value();
  Fit best{{}, 1e9};
  for (const auto& [start, promise] : model.starts(effect, active, residual)) {
    Settings settings = active;
    settings.push_back({effect.kind, effect.form, start});
    Fit found = fit(model, settings);
    if (found.rms_mm < best.rms_mm) best = found;
  }
  return best;
}

TEST(PalpationEffects, EachIsFoundAgainFromItsOwnData) {
  const test::PadOptions small{.bricks = {4, 4, 2}};
  const auto truth = checked_model_of(pad(small));
  const double noise_mm = 0.05;
  for (const Setting& made : examples(*truth)) {
    const auto model = checked_model_of(measured_as(pad(small), truth->predict({made}).value(), noise_mm));
    const Effect& effect = effect_named(*model, made.kind, made.form);
    const Fit found = best_fit(*model, effect);
    EXPECT_LT(found.rms_mm, 1.03 * noise_mm) << name_of(made) << " " << found.settings[0].parameters.transpose();
    if (made.kind == palpation::anisotropy) {
      const Eigen::Vector3d axis = found.settings[0].parameters.head<3>().normalized();
      EXPECT_GT(std::abs(axis.dot(made.parameters.head<3>().normalized())), 0.99) << name_of(made);
      EXPECT_NEAR(found.settings[0].parameters[3], made.parameters[3], 0.1 * made.parameters[3]) << name_of(made);
    } else if (made.kind == palpation::stiff_inclusion) {
      EXPECT_LT((found.settings[0].parameters.head<3>() - made.parameters.head<3>()).norm(), 2.0);
    } else if (made.form != palpation::form_prony_2) {  // whose terms trade with each other
      const Eigen::VectorXd error = found.settings[0].parameters - made.parameters;
      const Eigen::VectorXd size = made.parameters.cwiseAbs().cwiseMax(0.2);
      EXPECT_LT(error.cwiseQuotient(size).cwiseAbs().maxCoeff(), 0.2)
          << name_of(made) << " " << found.settings[0].parameters.transpose();
    }
  }
}

}  // namespace
}  // namespace glisson::closedloop
