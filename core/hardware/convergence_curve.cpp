#include "hardware/convergence_curve.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t maximum_curve_points = 10000;

// The straight line through two points in log-log, at x between them.
double on_log_line(double x, double x0, double y0, double x1, double y1) {
  const double t = std::log(x / x0) / std::log(x1 / x0);
  return y0 * std::pow(y1 / y0, t);
}

void check_points(const ConvergenceCurve& curve) {
  if (curve.points.size() < 2 || curve.points.size() > maximum_curve_points) {
    refuse({}, GLISSON_TEXT("A convergence curve has 2 to {0} points; this one has {1}."),
           {std::to_string(maximum_curve_points), std::to_string(curve.points.size())});
  }
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const auto& [resolution_mm3, error_mm] = curve.points[i];
    const bool positive = resolution_mm3 > 0 && error_mm > 0 && std::isfinite(resolution_mm3 * error_mm);
    const bool increases =
        i == 0 || (resolution_mm3 > curve.points[i - 1].resolution_mm3 && error_mm > curve.points[i - 1].error_mm);
    if (positive && increases) continue;
    refuse({},
           GLISSON_TEXT("Point {0} of the convergence curve, {1} mm3 and {2} mm, is not positive or does not "
                        "increase from the point before."),
           {std::to_string(i + 1), fmt::format("{:g}", resolution_mm3), fmt::format("{:g}", error_mm)});
  }
}

ConvergenceCurve curve_from(const Json& document, const std::filesystem::path& file) {
  check_format(document, "glisson-convergence/1", file);
  ConvergenceCurve curve;
  curve.source = source_in(document, "The curve");
  curve.provenance = text_under(document, "provenance", "The curve");
  if (document.contains("youngs_kPa")) curve.youngs_kPa = number_under(document, "youngs_kPa", {0.1, 1e6}, "The curve");
  const auto points = document.find("points");
  if (points == document.end() || !points->is_array() || points->size() > maximum_curve_points)
    refuse({}, GLISSON_TEXT("{0} has no list of points."), {file.string()});
  for (const Json& point : *points) {
    known_keys(point, {"resolution_mm3", "error_mm"}, "A point of the curve");
    const double resolution_mm3 = number_under(point, "resolution_mm3", {1e-6, 1e6}, "A point of the curve");
    curve.points.push_back({resolution_mm3, number_under(point, "error_mm", {1e-6, 1e6}, "A point of the curve")});
  }
  check_points(curve);
  return curve;
}

}  // namespace

Result<ConvergenceCurve> read_convergence_curve(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  return reading("convergence-invalid", file, [&] { return curve_from(*document, file); });
}

ConvergenceCurve in_tissue(const ConvergenceCurve& curve, double youngs_kPa) {
  ConvergenceCurve other = curve;
  other.youngs_kPa = youngs_kPa;
  for (ConvergencePoint& point : other.points) point.error_mm *= curve.youngs_kPa / youngs_kPa;
  return other;
}

Result<double> resolution_for_accuracy_mm3(const ConvergenceCurve& curve, double accuracy_mm) {
  const auto& points = curve.points;
  // Written so that NaN is refused as well.
  if (!(accuracy_mm >= points.front().error_mm)) {
    return failure(Error{"accuracy-not-reached",
                         GLISSON_TEXT("An accuracy of {0} mm is finer than the convergence study reaches ({1} mm at "
                                      "{2} mm3 a node)."),
                         {fmt::format("{:g}", accuracy_mm), fmt::format("{:g}", points.front().error_mm),
                          fmt::format("{:g}", points.front().resolution_mm3)},
                         GLISSON_TEXT("Ask for {1} mm or more."),
                         {}});
  }
  const auto above =
      std::find_if(points.begin(), points.end(), [&](auto& point) { return point.error_mm > accuracy_mm; });
  if (above == points.end()) return points.back().resolution_mm3;
  const auto below = above - 1;
  return on_log_line(accuracy_mm, below->error_mm, below->resolution_mm3, above->error_mm, above->resolution_mm3);
}

double error_at_resolution_mm(const ConvergenceCurve& curve, double resolution_mm3) {
  const auto& points = curve.points;
  const double inside = std::clamp(resolution_mm3, points.front().resolution_mm3, points.back().resolution_mm3);
  auto above =
      std::find_if(points.begin() + 1, points.end(), [&](auto& point) { return point.resolution_mm3 >= inside; });
  const auto below = above - 1;
  return on_log_line(inside, below->resolution_mm3, below->error_mm, above->resolution_mm3, above->error_mm);
}

}  // namespace glisson::hardware
