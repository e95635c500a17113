#pragma once
// What is taken for granted of the liver's tissue where nobody says otherwise.

namespace glisson {

// What liver simulations commonly take for a nearly incompressible organ, the dissertation's among them (section 4.2).
constexpr double usual_poisson_ratio = 0.45;

}  // namespace glisson
