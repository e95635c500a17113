#pragma once
// Drawings for reports, as SVG that stands inside the page: curves, and arrows at places.

#include <string>
#include <utility>
#include <vector>

namespace glisson::report {

enum class Ink { measured, before, after };

struct Curve {
  std::vector<std::pair<double, double>> points;  // finite; in the order in which a line goes
  Ink ink = Ink::measured;                        // measured: dots; before: a broken line; after: a line
};

// Axes with round numbers, labelled. No curves, or curves without extent, give an empty frame.
[[nodiscard]] std::string curves_svg(const std::vector<Curve>& curves, const std::string& x_label,
                                     const std::string& y_label);

// An arrow at a place; its heat from 0 to `hottest` goes from blue over grey to red.
struct Arrow {
  double x = 0, y = 0;
  double dx = 0, dy = 0;  // in the unit of x and y, as long as it is to be drawn
  double heat = 0;
};

// Equal scales in x and y, which both go up and right.
[[nodiscard]] std::string arrows_svg(const std::vector<Arrow>& arrows, double hottest, const std::string& x_label,
                                     const std::string& y_label);

}  // namespace glisson::report
