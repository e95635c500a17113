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
  enum class Style { line, dashes, dots };
  std::string label;  // in the legend; empty for none
  std::vector<std::pair<double, double>> points;
  Style style = Style::line;
  const char* colour = nullptr;  // of SVG; null for the next of the plot's own
};

// From (x, y), by (dx, dy) in the same unit; its heat goes from blue at 0 over grey to red at Plot::hottest.
struct Arrow {
  double x = 0, y = 0;
  double dx = 0, dy = 0;
  double heat = 0;
};

// A disc with its heat written in it, in the same unit and colours.
struct Spot {
  double x = 0, y = 0;
  double radius = 0;
  double heat = 0;
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

// A stretch of the x axis, behind all else; named in the legend. Each has the plot's next colour, from the last on.
struct Band {
  double low = 0, high = 0;
  std::string label;
};

struct Plot {
  std::string caption, x_title, y_title;
  std::optional<Histogram> histogram = {};
  std::vector<PlotCurve> curves = {};
  std::vector<Box> boxes = {};
  std::vector<Rule> rules = {};
  std::vector<Band> bands = {};
  std::vector<Arrow> arrows = {};  // with them or spots, a mm across is as long as a mm up
  std::vector<Spot> spots = {};
  double hottest = 0;
  bool from_zero = true;  // y begins at 0, unless values are negative
};

// Axes reach over all that is drawn. Values that are not finite are left out.
[[nodiscard]] std::string svg_of(const Plot& plot);

}  // namespace glisson::report
