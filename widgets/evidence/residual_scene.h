#pragma once
// What a model leaves of a palpation, on the specimen in space, at one moment of a trial. Each marker has an arrow, as
// much too long as is said. The specimen is coloured by the residual's length.

#include "closedloop/explain.h"
#include "scene/scene.h"

namespace glisson::widgets {

enum class ResidualOf { declared, better };

// Whether there are places to draw residuals at.
[[nodiscard]] bool has_residual_scene(const closedloop::Explained& explained);

struct ResidualScene {
  scene::Scene scene;
  double magnification = 1;  // of the arrows
  double largest_mm = 0;     // the declared model's residual at its longest, which both are scaled by
};

// Of the trial's moment at which the declared model is farthest off. Colours and arrows of both models have one scale.
[[nodiscard]] ResidualScene residual_scene(const closedloop::Explained& explained, std::size_t trial, ResidualOf of,
                                           const std::string& legend);

// The trial at which the declared model is farthest off.
[[nodiscard]] std::size_t worst_trial(const closedloop::Explained& explained);

}  // namespace glisson::widgets
