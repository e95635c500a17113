#pragma once
// That some of the values are wild: noise some times as large as that of the others, one value in a hundred or so, and
// nobody knows which. A likelihood of two normals for every row would not be quadratic in the parameters. So each row
// has a probability that it is wild, from one residual, and counts by the precision that is expected of it. What comes
// of that is a lower bound of the evidence, and the evidence itself where these probabilities are right.
//
// Bishop, Pattern Recognition and Machine Learning (2006), 10.1 and 10.2 (variational mixtures).

#include <Eigen/Core>

#include "closedloop/inference/diagnosis_options.h"

namespace glisson::closedloop {

struct WildValues {
  Eigen::VectorXd worth;       // of each row, beside one that is not wild: its precision
  double log_probability = 0;  // natural: of which are wild, and of how their noise is wider
};

// `white`: a residual in units of the noise; the noise may be any number of times as large.
[[nodiscard]] WildValues wild_values(const Eigen::VectorXd& white, const PosteriorOptions& options);

}  // namespace glisson::closedloop
