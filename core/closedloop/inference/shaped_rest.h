#pragma once
// Does a residual hold some of given shapes (ForwardModel::unlisted_shapes), whatever caused it? The evidence of any
// combination of them stands beside that of noise alone. All rows count, and wild values among them are noise: what a
// shape takes is the sum over many rows.
//
// A combination is normal with equal variances along the shapes' principal directions, so that both integrals are in
// closed form but for two numbers, which are summed over: the noise's size (laplace.h) and the combination's amplitude.
// MacKay, Information Theory, Inference, and Learning Algorithms (2003), ch. 28.

#include <Eigen/Core>

#include "closedloop/experiment/observations.h"
#include "closedloop/inference/diagnosis_options.h"

namespace glisson::closedloop {

// Of a combination: root mean square over rows, in noises. Its logarithm is normal.
struct Amplitude {
  double middle = 0;
  double spread = 0;  // of the natural logarithm
};

class ShapedRest {
 public:
  // `white_shapes`: whitened (whitening.h), a column a shape, rows as `observations`. Dependent shapes count once.
  ShapedRest(const Observations& observations, const Eigen::MatrixXd& white_shapes, const PosteriorOptions& options);

  // Natural logarithm of the odds that `white` (the whitened residual) is noise and a combination of that amplitude,
  // and not noise alone. Neighbours in time may repeat each other. With `own_error`, the alternative is with half of
  // the probability a combination of that amplitude: what the prediction itself may be off by.
  [[nodiscard]] double log_odds(const Eigen::VectorXd& white, const Amplitude& amplitude,
                                const Amplitude& own_error = {}) const;

 private:
  const Observations& observations_;
  const PosteriorOptions& options_;
  Eigen::MatrixXd directions_;  // orthonormal columns
};

}  // namespace glisson::closedloop
