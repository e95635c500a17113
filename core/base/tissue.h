#pragma once
// What is taken for granted of the liver's tissue where nobody says otherwise.

namespace glisson {

// What simulations commonly take for a nearly incompressible organ: our choice, since the dissertation states none.
constexpr double usual_poisson_ratio = 0.45;

}  // namespace glisson
