#pragma once
// A plot as values, and as a drawing (SVG) that a page holds inside itself.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glisson::report {

// One bar between each two edges.
struct Histogram {
  std::vector<double> edges;    // ascending, one more than heights
  std::vector<double> heights;  // from 0
};

struct PlotCurve {
  enum class Style { line, dots };
  std::string label;  // in the legend; empty for none
  std::vector<std::pair<double, double>> points;
  Style style = Style::line;
};

// From the 5th to the 95th percentile with the middle half as a box; boxes stand side by side along x at 1, 2, ...
struct Box {
  std::string label;
  double low = 0, quarter = 0, median = 0, three_quarters = 0, high = 0;
};

// A straight line across the plot, such as the 5 mm from which a displacement matters.
struct Rule {
  enum class Along { x, y };  // the axis on which `at` lies
  Along axis = Along::y;
  double at = 0;
  std::string label;
};

struct Plot {
  std::string caption, x_title, y_title;
  std::optional<Histogram> histogram;
  std::vector<PlotCurve> curves;
  std::vector<Box> boxes;
  std::vector<Rule> rules;
};

// Axes reach over all that is drawn, and to 0 on y unless values are negative. Values that are not finite are left out.
[[nodiscard]] std::string svg_of(const Plot& plot);

}  // namespace glisson::report
