#pragma once
// How livers differ: a mean surface and the principal components of what corresponding surfaces differ by, rigid
// motions taken out (Cootes et al. 1995; Gower 1975 for the alignment of all to their mean). Size stays in.
//
// Gaussian: a liver is mean + sum over modes of b_k mode_k + rest. The b_k are standard normal. The rest, at each point
// and along each axis, is normal with residual_sd_mm.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::shapes {

struct ShapeModel {
  geometry::Surface mean;    // n points
  Eigen::MatrixXd modes_mm;  // 3n x rank: what one standard deviation of each mode adds to (x, y, z) of each point
  Eigen::VectorXd residual_sd_mm;  // n: of a coordinate, as livers that were left out had it
  int livers = 0;                  // that it was made from

  [[nodiscard]] int rank() const { return static_cast<int>(modes_mm.cols()); }
  // mean + modes * coefficients, in the model's frame.
  [[nodiscard]] geometry::Surface at(const Eigen::VectorXd& coefficients) const;
};

// The shapes, aligned with one another: what models are made from.
struct AlignedShapes {
  geometry::Surface topology;  // whose points are the mean of all
  Eigen::MatrixXd shapes_mm;   // 3n x livers
};

// Failures: "shapes-too-few" (fewer than 4), "shapes-do-not-correspond" (of different counts of points).
Result<AlignedShapes> align_shapes(const std::vector<geometry::Surface>& corresponding);

// The model of all of them but those in `left_out`, with so many modes, at most one fewer than the livers (0: all).
// Its deviations are the sample's, and residual_sd_mm is 0: calibrated() makes both those of livers left out.
ShapeModel model_of(const AlignedShapes& shapes, int rank = 0, const std::vector<int>& left_out = {});

// What each number of modes is worth, by leaving out one liver at a time.
struct RankJudged {
  int modes = 0;
  double compactness = 0;        // share of the variance that they hold
  double generalisation_mm = 0;  // mean distance of the left-out liver's points from where the modes bring them
  double held_out_ratio = 0;     // mean square of left-out livers' coefficient of the last of them, over its variance
};
struct RanksJudged {
  std::vector<RankJudged> by_modes;  // by_modes[k - 1]
  // The honest rank: the fewest modes with which left-out livers lie within 2 % as near as with the best number.
  int rank = 0;
  // At that rank, a column a liver, each by the model of the others. The first is what is left at each point (mean
  // square over x, y and z). The second is the squares of the coefficients over the modes' variances.
  Eigen::MatrixXd rest_mm2, squared_coefficients;
};
RanksJudged judge_ranks(const AlignedShapes& shapes, const Progress& progress = {});

// A sample of few livers holds directions of single ones, along which the next liver hardly differs. So each mode's
// variance becomes the mean square that left-out livers showed along it and the three on either side of it. The
// residual is theirs. `without`: a liver whose own figures stay out.
ShapeModel calibrated(ShapeModel model, const RanksJudged& judged, int without = -1);

// The mean distance, point by point, of livers drawn from the model to the nearest that it was made from.
double specificity_mm(const ShapeModel& model, const AlignedShapes& shapes, int draws = 200, std::uint64_t seed = 1);

// The calibrated model of the honest rank.
Result<ShapeModel> honest_model(const std::vector<geometry::Surface>& corresponding, const Progress& progress = {});

}  // namespace glisson::shapes
