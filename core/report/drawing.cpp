#include "report/drawing.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "report/html.h"

namespace glisson::report {
namespace {

constexpr double width = 480;
constexpr double height = 320;
constexpr double left = 62;
constexpr double right = 12;
constexpr double top = 12;
constexpr double bottom = 46;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Never empty, so that it can be divided by.
  [[nodiscard]] Range padded() const {
    if (!(high >= low)) return {0, 1};
    const double margin = high > low ? 0.04 * (high - low) : std::max(1e-9, 0.5 * std::abs(high));
    return {low - margin, high + margin};
  }
  [[nodiscard]] double length() const { return high - low; }
};

// 1, 2 or 5 times a power of ten, so that about five steps fill the range.
double round_step(double length) {
  const double rough = length / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

// The frame, its labels, and where values come to lie.
class Axes {
 public:
  Axes(Range x, Range y) : x_(x), y_(y) {}

  [[nodiscard]] double at_x(double x) const { return left + (x - x_.low) / x_.length() * (width - left - right); }
  [[nodiscard]] double at_y(double y) const {
    return height - bottom - (y - y_.low) / y_.length() * (height - top - bottom);
  }
  [[nodiscard]] std::string frame(const std::string& x_label, const std::string& y_label) const {
    std::string svg = fmt::format(
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" font-size=\"12\" fill=\"currentColor\">"
        "<path d=\"M{} {}V{}H{}\" fill=\"none\" stroke=\"currentColor\" opacity=\"0.6\"/>",
        width, height, left, top, height - bottom, width - right);
    const auto tick = [](double value, double step) { return std::abs(value) < 1e-9 * step ? 0.0 : value; };
    const double step_x = round_step(x_.length());
    for (double x = std::ceil(x_.low / step_x) * step_x; x <= x_.high; x += step_x)
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.4g}</text>", at_x(x),
                         height - bottom + 16, tick(x, step_x));
    const double step_y = round_step(y_.length());
    for (double y = std::ceil(y_.low / step_y) * step_y; y <= y_.high; y += step_y)
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.4g}</text>", left - 6, at_y(y) + 4,
                         tick(y, step_y));
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", (left + width - right) / 2,
                       height - 8, escaped(x_label));
    svg += fmt::format("<text transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                       (top + height - bottom) / 2, escaped(y_label));
    return svg;
  }

 private:
  Range x_;
  Range y_;
};

std::string dots(const Curve& curve, const Axes& axes) {
  std::string svg = "<g fill=\"currentColor\" opacity=\"0.45\">";
  for (const auto& [x, y] : curve.points)
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.8\"/>", axes.at_x(x), axes.at_y(y));
  return svg + "</g>";
}

std::string line(const Curve& curve, const Axes& axes) {
  std::string path;
  for (const auto& [x, y] : curve.points)
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", axes.at_x(x), axes.at_y(y));
  const bool before = curve.ink == Ink::before;
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}/>", path,
                     before ? "#c0392b" : "#2471a3", before ? " stroke-dasharray=\"5 4\"" : "");
}

// Blue over grey to red: read alike by most people who do not tell red from green.
std::string colour_of(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  const auto between = [s](double cold, double middle, double hot) {
    return static_cast<int>(s < 0.5 ? cold + 2 * s * (middle - cold) : middle + (2 * s - 1) * (hot - middle));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", between(49, 150, 192), between(104, 150, 45), between(176, 155, 38));
}

}  // namespace

std::string curves_svg(const std::vector<Curve>& curves, const std::string& x_label, const std::string& y_label) {
  Range x;
  Range y;
  for (const Curve& curve : curves) {
    for (const auto& point : curve.points) {
      x.include(point.first);
      y.include(point.second);
    }
  }
  const Axes axes(x.padded(), y.padded());
  std::string svg = axes.frame(x_label, y_label);
  for (const Curve& curve : curves) svg += curve.ink == Ink::measured ? dots(curve, axes) : line(curve, axes);
  return svg + "</svg>";
}

std::string arrows_svg(const std::vector<Arrow>& arrows, double hottest, const std::string& x_label,
                       const std::string& y_label) {
  Range x;
  Range y;
  for (const Arrow& arrow : arrows) {
    x.include(arrow.x);
    x.include(arrow.x + arrow.dx);
    y.include(arrow.y);
    y.include(arrow.y + arrow.dy);
  }
  x = x.padded();
  y = y.padded();
  // Equal scales: the shorter side is widened about its middle.
  const double per_mm = std::min((width - left - right) / x.length(), (height - top - bottom) / y.length());
  const auto widen = [](Range& range, double length) {
    const double middle = (range.low + range.high) / 2;
    range = {middle - length / 2, middle + length / 2};
  };
  widen(x, (width - left - right) / per_mm);
  widen(y, (height - top - bottom) / per_mm);
  const Axes axes(x, y);
  std::string svg = axes.frame(x_label, y_label);
  for (const Arrow& arrow : arrows) {
    const std::string colour = colour_of(hottest > 0 ? arrow.heat / hottest : 0);
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"2\" fill=\"{4}\"/>"
        "<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}\" stroke=\"{4}\" stroke-width=\"1.4\"/>",
        axes.at_x(arrow.x), axes.at_y(arrow.y), axes.at_x(arrow.x + arrow.dx), axes.at_y(arrow.y + arrow.dy), colour);
  }
  return svg + "</svg>";
}

}  // namespace glisson::report
