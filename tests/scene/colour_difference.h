#pragma once
// How different two colours look.

#include <Eigen/Core>

#include "scene/colour.h"

namespace glisson::test {

// CIELAB of an sRGB colour under D65.
[[nodiscard]] Eigen::Vector3d cielab(const scene::Colour& colour);

// CIEDE2000 of two colours in CIELAB: 1 is about what is just seen, 10 at a glance. Formula: Sharma, Wu, Dalal, Color
// Research and Application 30(1), 2005, weights 1.
[[nodiscard]] double ciede2000(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// As an eye sees it that lacks one kind of cone altogether: Machado, Oliveira, Fernandes, IEEE TVCG 15(6), 2009.
enum class Lacks { long_waves, middle_waves, short_waves };
[[nodiscard]] scene::Colour seen_without(const scene::Colour& colour, Lacks cones);

}  // namespace glisson::test
