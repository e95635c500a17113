#pragma once
// A ball whose border is as wide as half a cell, so that what lies in it changes smoothly with the ball.

#include <Eigen/Core>

#include "mechanics/scenario/scenario.h"

namespace glisson::closedloop {

// From 0 outside to 1 inside, at a place in a cell (or face) of that edge.
[[nodiscard]] double inside(const mechanics::Ball& ball, const Eigen::Vector3d& place_mm, double edge_mm);

enum class BallParameter { x, y, z, radius };
// Its derivative, per mm.
[[nodiscard]] double inside_derivative(const mechanics::Ball& ball, const Eigen::Vector3d& place_mm, double edge_mm,
                                       BallParameter by);

}  // namespace glisson::closedloop
