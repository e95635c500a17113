#pragma once
// Colours, and the colour maps that turn a number into one.
//
// The maps are even to the eye. People with any of the common colour-vision deficiencies can tell them apart; a rainbow
// is not on offer. viridis: van der Walt and Smith 2015 (CC0). cividis: Nunez, Anderton and Renslow, PLoS ONE 13(7),
// 2018 (CC0). magma, plasma: Smith and van der Walt 2015 (CC0).

#include <array>
#include <string>
#include <vector>

namespace glisson::scene {

// sRGB as a screen takes it, each 0..1.
struct Colour {
  double red = 1;
  double green = 1;
  double blue = 1;
};

enum class ColourMap { viridis, cividis, magma, plasma, grey };

// The colour at `fraction` of the way from the map's low end (0) to its high end (1); clamped outside.
[[nodiscard]] Colour colour_at(ColourMap map, double fraction);

// Round numbers that divide [low, high] into about `wanted` steps, for the marks of a legend: 0, 5, 10, ...
[[nodiscard]] std::vector<double> round_marks(double low, double high, int wanted);

}  // namespace glisson::scene
