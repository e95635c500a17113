// Every effect of a palpation: absent at its default, differentiated exactly, found again from what it does.

#include "closedloop/palpation/internal/effects.h"

#include <gmock/gmock.h>

#include "closedloop/effect_checks.h"
#include "closedloop/palpation/model.h"
#include "closedloop/palpation_bodies.h"

namespace glisson::closedloop {
namespace {

using test::best_fit;
using test::effect_named;
using test::expect_exact_derivatives;
using test::FittedEffect;
using test::measured_as;
using test::name_of;
using test::pad;
using test::setting;

std::unique_ptr<ForwardModel> checked_model_of(const Palpation& experiment) {
  auto model = palpation_model(experiment);
  if (!model) throw std::runtime_error(model.error().message());
  return std::move(*model);
}

// Each effect, strong enough to be seen.
Settings examples(const ForwardModel& model) {
  return {setting(model, palpation::stiffness_scale, "", {1.3}),
          setting(model, palpation::strain_stiffening, "exponential", {8}),
          setting(model, palpation::strain_stiffening, "linear", {3}),
          setting(model, palpation::strain_stiffening, "yeoh", {3}),
          setting(model, palpation::strain_stiffening, "ogden", {9}),
          setting(model, palpation::support_compliance, "", {0.6}),
          setting(model, palpation::support_compliance, "layer", {0.6, 0.15}),
          setting(model, palpation::stiff_inclusion, "", {36, 26, 17, 9, 5}),
          setting(model, palpation::viscoelastic_creep, "prony-1", {0.4, 3}),
          setting(model, palpation::viscoelastic_creep, "prony-2", {0.2, 0.3, 1, 8}),
          setting(model, palpation::force_bias, "", {0.01, 1.2}),
          setting(model, palpation::frame_misalignment, "", {0.5, -1, 0.7, 0.3, -0.2, 0.4}),
          setting(model, palpation::anisotropy, "fibres", {0.8, 0.6, 0.1, 2}),
          setting(model, palpation::anisotropy, "engineering", {0.8, 0.6, 0.1, 2}),
          setting(model, palpation::anisotropy, "three-moduli", {0.8, 0.6, 0.1, 2, 0.6}),
          setting(model, palpation::capsule, "", {0.15}),
          setting(model, palpation::preload, "gravity", {1, -2, -9}),
          setting(model, palpation::preload, "pressure", {0.8})};
}

TEST(PalpationEffects, AtItsDefaultNoneChangesAnything) {
  const auto model = checked_model_of(pad());
  test::expect_nothing_at_default(*model);
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
  const Setting layer = setting(*model, palpation::support_compliance, "layer", {0.6, 0.15});
  expect_exact_derivatives(*model, {named("stiffness-scale"), layer, named("capsule")}, "on a layer");
}

TEST(PalpationEffects, EachIsFoundAgainFromItsOwnData) {
  const test::PadOptions small{.bricks = {4, 4, 2}};
  const auto truth = checked_model_of(pad(small));
  const double noise_mm = 0.05;
  for (const Setting& made : examples(*truth)) {
    const auto model = checked_model_of(measured_as(pad(small), truth->predict({made}).value(), noise_mm));
    const Effect& effect = effect_named(*model, made.kind, made.form);
    const FittedEffect found = best_fit(*model, effect);
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
