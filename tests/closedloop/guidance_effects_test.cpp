// Every effect of guidance: absent at its default, differentiated exactly, found again from what it does to clouds.

#include <gmock/gmock.h>

#include "closedloop/effect_checks.h"
#include "closedloop/guidance/model.h"
#include "closedloop/guided_bodies.h"

namespace glisson::closedloop {
namespace {

using test::best_fit;
using test::effect_named;
using test::FittedEffect;
using test::guided_pad;
using test::name_of;
using test::seen_as;
using test::setting;

std::unique_ptr<ForwardModel> guidance_model_of(Guidance guidance) {
  auto model = guidance_model(std::move(guidance));
  if (!model) throw std::runtime_error(model.error().message());
  return std::move(*model);
}

// Each effect, strong enough to be seen.
Settings guidance_examples(const ForwardModel& model) {
  return {setting(model, palpation::stiffness_scale, "", {1.3}),
          setting(model, palpation::support_compliance, "", {0.6}),
          setting(model, palpation::stiff_inclusion, "", {36, 26, 17, 9, 5}),
          setting(model, palpation::force_bias, "", {1.2}),
          setting(model, palpation::frame_misalignment, "", {0.5, -1, 0.7, 0.3, -0.2, 0.4}),
          setting(model, palpation::undeclared_attachment, "", {58, 34, 24, 10, 1.5}),
          setting(model, palpation::missing_attachment, "tie", {0.02})};
}

TEST(GuidanceEffects, AtItsDefaultNoneChangesAnything) {
  test::expect_nothing_at_default(*guidance_model_of(guided_pad()));
}

TEST(GuidanceEffects, DerivativesAreThoseOfThePrediction) {
  const auto model = guidance_model_of(guided_pad());
  const Settings all = guidance_examples(*model);
  for (const Setting& one : all) test::expect_exact_derivatives(*model, {one}, name_of(one));
  test::expect_exact_derivatives(*model, all, "all of them");
}

// Two supports may be missing, one at a time; a ligament that only pulls is no linear support, and then none is
// offered.
TEST(GuidanceEffects, EachDeclaredSupportMayBeMissing) {
  std::vector<std::string> forms;
  const auto tied = guidance_model_of(guided_pad());
  for (const Effect& effect : tied->catalogue())
    if (effect.kind == palpation::missing_attachment) forms.push_back(effect.form);
  EXPECT_THAT(forms, testing::ElementsAre("fixed", "tie"));
  Guidance alone = guided_pad();
  alone.organ.supports.pop_back();
  const auto untied = guidance_model_of(alone);
  for (const Effect& effect : untied->catalogue()) EXPECT_NE(effect.kind, palpation::missing_attachment);
}

TEST(GuidanceEffects, EachIsFoundAgainFromItsOwnData) {
  const auto truth = guidance_model_of(guided_pad());
  const double noise_mm = 0.05;
  for (const Setting& made : guidance_examples(*truth)) {
    const auto model = guidance_model_of(seen_as(guided_pad(), truth->predict({made}).value(), noise_mm));
    const FittedEffect found = best_fit(*model, effect_named(*model, made.kind, made.form));
    const Eigen::VectorXd& values = found.settings[0].parameters;
    EXPECT_LT(found.rms_mm, 1.05 * noise_mm) << name_of(made) << " " << values.transpose();
    if (made.kind == palpation::stiff_inclusion || made.kind == palpation::undeclared_attachment) {
      EXPECT_LT((values.head<3>() - made.parameters.head<3>()).norm(), 3.0) << name_of(made) << values.transpose();
    }
  }
}

}  // namespace
}  // namespace glisson::closedloop
