#pragma once
// What a declared platform may lack, and how each effect changes its behaviour.

#include <functional>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/hardware/behaviour.h"

namespace glisson::closedloop {

struct PlatformEffect {
  Effect effect;
  std::function<void(const Eigen::VectorXd& parameters, PlatformBehaviour& behaviour)> apply;
};

// Those that the recorded quantities could show at all.
[[nodiscard]] std::vector<PlatformEffect> platform_effects(const Platform& platform);

// Those, and the ones that trials with more columns would show: a model learnt from such trials is applied to these.
[[nodiscard]] std::vector<PlatformEffect> known_platform_effects(const Platform& platform);

}  // namespace glisson::closedloop
