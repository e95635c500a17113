#pragma once
// What a declared platform may lack, and how each effect changes its behaviour.

#include <functional>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/hardware/behaviour.h"

namespace glisson::closedloop {

struct HardwareEffect {
  Effect effect;
  std::function<void(const Eigen::VectorXd& parameters, HardwareBehaviour& behaviour)> apply;
};

// Those that the recorded quantities could show at all.
[[nodiscard]] std::vector<HardwareEffect> hardware_effects(const Hardware& hardware);

// Those, and the ones that trials with more columns would show: a model learnt from such trials is applied to these.
[[nodiscard]] std::vector<HardwareEffect> known_hardware_effects(const Hardware& hardware);

}  // namespace glisson::closedloop
