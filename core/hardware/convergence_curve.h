#pragma once
// Which resolution a wanted accuracy asks for: the error of a simulated cantilever against Euler-Bernoulli's beam
//
//   w(x) = f x^2 (6 L^2 - 4 L x + x^2) / (24 E I)        (eq. 6.6; L 50 mm, 10 x 10 mm, 997 kg/m3, 12 kPa: table 6.1)
//
// over the volume that one node stands for (section 6.3.2, figure 6.5). The curve is data: whoever makes a better one,
// with this product's own engine, writes a file in the same form.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/figure.h"

namespace glisson::hardware {

struct ConvergencePoint {
  double resolution_mm3 = 0;  // volume a node stands for
  double error_mm = 0;        // of the beam's deflection
};

struct ConvergenceCurve {
  std::vector<ConvergencePoint> points;  // finest first; both figures strictly increasing, at least two
  double youngs_kPa = 12;                // of the beam; table 6.1's where a file leaves it out
  Source source = Source::assumed;
  std::string provenance;  // one sentence: which study, which engine, which version
};

// {"format": "glisson-convergence/1", "source": "dissertation", "provenance": "...", "youngs_kPa": 12,
//  "points": [{"resolution_mm3": 1.65, "error_mm": 1}, ...]}
// Refused are fewer than two points or more than 10,000, and figures that are not positive or do not increase together.
Result<ConvergenceCurve> read_convergence_curve(const std::filesystem::path& file);

// The curve in softer or stiffer tissue under the same load. What is missing is a part of the deflection. That is in
// inverse proportion to Young's modulus (linear elasticity, as eq. 6.6).
[[nodiscard]] ConvergenceCurve in_tissue(const ConvergenceCurve& curve, double youngs_kPa);

// The coarsest resolution whose error is at most `accuracy_mm`; straight lines between the points in log-log.
// Refused: an accuracy finer than the finest point ("accuracy-not-reached"). Coarser than the coarsest point gives the
// coarsest point: a study says nothing beyond its ends.
Result<double> resolution_for_accuracy_mm3(const ConvergenceCurve& curve, double accuracy_mm);

// The error at a resolution, between the curve's ends.
[[nodiscard]] double error_at_resolution_mm(const ConvergenceCurve& curve, double resolution_mm3);

}  // namespace glisson::hardware
