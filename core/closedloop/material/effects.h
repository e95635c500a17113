#pragma once
// What a declared material law may lack, and how each effect changes the behaviour of the specimen.

#include <functional>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/material/behaviour.h"

namespace glisson::closedloop {

struct MaterialEffect {
  Effect effect;
  std::function<void(const Eigen::VectorXd& parameters, MaterialBehaviour& behaviour)> apply;
};

// Those that the trials could show at all. There are no time constants without a range of times, no hysteresis without
// unloading, no asymmetry where only one side was tested.
[[nodiscard]] std::vector<MaterialEffect> material_effects(const Material& material);

// Those, and the ones that other trials would show: a model learnt from such trials is applied to these.
[[nodiscard]] std::vector<MaterialEffect> known_material_effects(const Material& material);

}  // namespace glisson::closedloop
