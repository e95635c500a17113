#include "report/plot.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/markup.h"

namespace glisson::report {
namespace {

constexpr double width_px = 640;
constexpr double height_px = 400;
constexpr double left_px = 70, right_px = 20, top_px = 16, bottom_px = 60;
constexpr double room_px_x = width_px - left_px - right_px;
constexpr double room_px_y = height_px - top_px - bottom_px;
// Okabe and Ito's colours, which colour-blind readers can tell apart.
constexpr std::array<const char*, 5> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};

struct Range {
  double low = 0, high = 0;
  bool empty = true;

  void reach(double value) {
    if (!std::isfinite(value)) return;
    low = empty ? value : std::min(low, value);
    high = empty ? value : std::max(high, value);
    empty = false;
  }
  void widen() {
    if (empty) *this = {0, 1, false};
    const double room = high > low ? 0.04 * (high - low) : std::max(0.5, 0.1 * std::abs(low));
    high += room;
    if (low != 0) low -= room;
  }
  // About the same middle.
  void stretch_to(double length) {
    const double middle = 0.5 * (low + high);
    low = middle - 0.5 * length;
    high = middle + 0.5 * length;
  }
  [[nodiscard]] double length() const { return high - low; }
};

// 1, 2 or 5 times a power of ten, so that about six marks fit.
double mark_step(const Range& range) {
  const double rough = (range.high - range.low) / 6;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power) return factor * power;
  }
  return 10 * power;
}

// Blue over grey to red: read alike by most people who do not tell red from green.
std::string heat_colour(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  const auto between = [s](double cold, double middle, double hot) {
    return static_cast<int>(s < 0.5 ? cold + 2 * s * (middle - cold) : middle + (2 * s - 1) * (hot - middle));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", between(49, 150, 192), between(104, 150, 45), between(176, 155, 38));
}

class PlotDrawing {
 public:
  explicit PlotDrawing(const Plot& plot) : plot_(plot) { find_ranges(); }

  std::string svg() {
    out_ = fmt::format(
        "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\" font-size=\"13\" fill=\"currentColor\">\n",
        width_px, height_px, escaped_markup(plot_.caption));
    for (std::size_t n = 0; n < plot_.bands.size(); ++n) band(plot_.bands[n], colour_of_band(n));
    axes();
    if (plot_.histogram) bars(*plot_.histogram);
    for (std::size_t n = 0; n < plot_.boxes.size(); ++n) box(plot_.boxes[n], static_cast<double>(n + 1));
    for (const Arrow& each : plot_.arrows) arrow(each);
    for (const Spot& each : plot_.spots) spot(each);
    for (std::size_t n = 0; n < plot_.curves.size(); ++n) curve(plot_.curves[n], colour_of_curve(n));
    for (const Rule& rule : plot_.rules) line(rule);
    legend();
    return out_ + "</svg>\n";
  }

 private:
  void find_ranges() {
    if (plot_.from_zero) y_.reach(0);
    if (plot_.histogram) {
      for (const double edge : plot_.histogram->edges) x_.reach(edge);
      for (const double height : plot_.histogram->heights) y_.reach(height);
    }
    for (const PlotCurve& curve : plot_.curves) {
      for (const auto& [x, y] : curve.points) {
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        x_.reach(x);
        y_.reach(y);
      }
    }
    for (const Box& box : plot_.boxes) {
      y_.reach(box.low);
      y_.reach(box.high);
    }
    for (const Rule& rule : plot_.rules) (rule.axis == Rule::Along::x ? x_ : y_).reach(rule.at);
    for (const Band& band : plot_.bands) {
      x_.reach(band.low);
      x_.reach(band.high);
    }
    for (const Arrow& arrow : plot_.arrows) {
      x_.reach(arrow.x);
      x_.reach(arrow.x + arrow.dx);
      y_.reach(arrow.y);
      y_.reach(arrow.y + arrow.dy);
    }
    for (const Spot& spot : plot_.spots) {
      for (const double side : {-1.0, 1.0}) {
        x_.reach(spot.x + side * spot.radius);
        y_.reach(spot.y + side * spot.radius);
      }
    }
    if (!plot_.boxes.empty()) x_ = {0.4, static_cast<double>(plot_.boxes.size()) + 0.6, false};
    if (plot_.boxes.empty()) x_.widen();
    y_.widen();
    if (!plot_.arrows.empty() || !plot_.spots.empty()) {
      const double px_per_unit = std::min(room_px_x / x_.length(), room_px_y / y_.length());
      x_.stretch_to(room_px_x / px_per_unit);
      y_.stretch_to(room_px_y / px_per_unit);
    }
  }
  [[nodiscard]] const char* colour_of_curve(std::size_t n) const {
    return plot_.curves[n].colour != nullptr ? plot_.curves[n].colour : colours[n % colours.size()];
  }
  [[nodiscard]] static const char* colour_of_band(std::size_t n) {
    return colours[colours.size() - 1 - n % colours.size()];
  }
  [[nodiscard]] double px(double x) const { return left_px + (x - x_.low) / x_.length() * room_px_x; }
  [[nodiscard]] double py(double y) const { return height_px - bottom_px - (y - y_.low) / y_.length() * room_px_y; }
  void text(double x_px, double y_px, const std::string& words, const char* anchor, const std::string& more = "") {
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x_px, y_px, anchor, more,
                        escaped_markup(words));
  }
  void stroke(double x0, double y0, double x1, double y1, const std::string& look) {
    out_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x0, y0, x1, y1, look);
  }
  void axes() {
    const std::string faint = "stroke=\"currentColor\" stroke-opacity=\"0.15\"";
    for (double y = std::ceil(y_.low / mark_step(y_)) * mark_step(y_); y <= y_.high; y += mark_step(y_)) {
      stroke(left_px, py(y), width_px - right_px, py(y), faint);
      text(left_px - 8, py(y) + 4, fmt::format("{:.4g}", std::abs(y) < 1e-12 ? 0 : y), "end");
    }
    if (plot_.boxes.empty()) {
      for (double x = std::ceil(x_.low / mark_step(x_)) * mark_step(x_); x <= x_.high; x += mark_step(x_)) {
        stroke(px(x), height_px - bottom_px, px(x), height_px - bottom_px + 5, "stroke=\"currentColor\"");
        text(px(x), height_px - bottom_px + 20, fmt::format("{:.4g}", std::abs(x) < 1e-12 ? 0 : x), "middle");
      }
    }
    stroke(left_px, height_px - bottom_px, width_px - right_px, height_px - bottom_px, "stroke=\"currentColor\"");
    stroke(left_px, top_px, left_px, height_px - bottom_px, "stroke=\"currentColor\"");
    text(0.5 * (left_px + width_px - right_px), height_px - 14, plot_.x_title, "middle");
    const double middle = 0.5 * (top_px + height_px - bottom_px);
    text(18, middle, plot_.y_title, "middle", fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", middle));
  }
  void bars(const Histogram& histogram) {
    for (std::size_t n = 0; n < histogram.heights.size(); ++n) {
      const double left = px(histogram.edges[n]);
      const double right = px(histogram.edges[n + 1]);
      const double top = py(histogram.heights[n]);
      out_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.55\"/>\n",
          left + 1, top, std::max(right - left - 2, 1.0), py(0) - top, colours[0]);
    }
  }
  void band(const Band& band, const char* colour) {
    out_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.2\"/>\n",
        px(band.low), top_px, px(band.high) - px(band.low), height_px - bottom_px - top_px, colour);
  }
  void box(const Box& box, double at) {
    const std::string look = fmt::format("stroke=\"{}\" stroke-width=\"2\"", colours[0]);
    stroke(px(at), py(box.low), px(at), py(box.high), look);
    out_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {} fill=\"{}\" fill-opacity=\"0.3\"/>\n",
        px(at - 0.25), py(box.three_quarters), px(at + 0.25) - px(at - 0.25), py(box.quarter) - py(box.three_quarters),
        look, colours[0]);
    stroke(px(at - 0.25), py(box.median), px(at + 0.25), py(box.median),
           fmt::format("stroke=\"{}\" stroke-width=\"3\"", colours[1]));
    text(px(at), height_px - bottom_px + 20, box.label, "middle");
  }
  void curve(const PlotCurve& curve, const char* colour) {
    std::string path;
    for (const auto& [x, y] : curve.points) {
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      if (curve.style == PlotCurve::Style::dots) {
        out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\" fill-opacity=\"0.7\"/>\n", px(x),
                            py(y), colour);
      } else {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", px(x), py(y));
      }
    }
    if (!path.empty())
      out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, colour,
                          curve.style == PlotCurve::Style::dashes ? " stroke-dasharray=\"5 4\"" : "");
  }
  void spot(const Spot& spot) {
    if (!std::isfinite(spot.x + spot.y + spot.radius + spot.heat)) return;
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.85\"/>\n",
                        px(spot.x), py(spot.y), spot.radius / x_.length() * room_px_x,
                        heat_colour(plot_.hottest > 0 ? spot.heat / plot_.hottest : 0));
    text(px(spot.x), py(spot.y) + 4, fmt::format("{:.2g}", spot.heat), "middle", " font-size=\"11\"");
  }
  void arrow(const Arrow& arrow) {
    if (!std::isfinite(arrow.x + arrow.y + arrow.dx + arrow.dy)) return;
    const std::string colour = heat_colour(plot_.hottest > 0 ? arrow.heat / plot_.hottest : 0);
    out_ +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"{}\"/>\n", px(arrow.x), py(arrow.y), colour);
    stroke(px(arrow.x), py(arrow.y), px(arrow.x + arrow.dx), py(arrow.y + arrow.dy),
           fmt::format("stroke=\"{}\" stroke-width=\"1.4\"", colour));
  }
  void line(const Rule& rule) {
    const std::string look = fmt::format("stroke=\"{}\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"", colours[1]);
    if (rule.axis == Rule::Along::y) {
      stroke(left_px, py(rule.at), width_px - right_px, py(rule.at), look);
      text(width_px - right_px - 4, py(rule.at) - 5, rule.label, "end");
    } else {
      stroke(px(rule.at), top_px, px(rule.at), height_px - bottom_px, look);
      text(px(rule.at) + 5, top_px + 12, rule.label, "start");
    }
  }
  void legend() {
    double y_px = top_px + 14;
    const auto entry = [&](const std::string& label, const char* colour, const char* opacity) {
      if (label.empty()) return;
      out_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"12\" height=\"12\" fill=\"{}\"{}/>\n",
                          width_px - 200, y_px - 11, colour, opacity);
      text(width_px - 182, y_px, label, "start");
      y_px += 18;
    };
    for (std::size_t n = 0; n < plot_.curves.size(); ++n) entry(plot_.curves[n].label, colour_of_curve(n), "");
    for (std::size_t n = 0; n < plot_.bands.size(); ++n) {
      entry(plot_.bands[n].label, colour_of_band(n), " fill-opacity=\"0.4\"");
    }
  }

  const Plot& plot_;
  Range x_, y_;
  std::string out_;
};

}  // namespace

std::string svg_of(const Plot& plot) { return PlotDrawing(plot).svg(); }

}  // namespace glisson::report
