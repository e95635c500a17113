#pragma once
// Is there a smooth function of what was done in a residual, whatever caused it? The evidence of a Gaussian process
// of what was done (smooth_features.h) stands beside that of noise, by Laplace's method. Its amplitudes, its lengths
// and the noise's size have proper priors; beside something else the noise may be of any size (PosteriorOptions). The
// answer is the weight of "something else" in a posterior.
//
// Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), 5.2.

#include <Eigen/Core>

#include "base/progress.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/experiment/whitening.h"
#include "closedloop/inference/diagnosis_options.h"

namespace glisson::closedloop {

// Natural logarithms, over the same rows: neighbours in time averaged, of every so many markers, to about
// PosteriorOptions::smooth_rows means.
struct SmoothEvidence {
  double smooth = 0;
  double noise = 0;  // white, or, without places, repeating itself from sample to sample (AR(1))
  // Of the information in all rows, what these hold: averages keep it, markers that were passed over do not.
  double share_of_rows = 1;
};

// `residual`: measured - predicted. Where the search is cancelled, its best so far.
[[nodiscard]] SmoothEvidence smooth_evidence(const Observations& observations, const SystematicUncertainty& systematic,
                                             const Eigen::VectorXd& residual, const PosteriorOptions& options,
                                             const Progress& progress = {});

}  // namespace glisson::closedloop
