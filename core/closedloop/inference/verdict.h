#pragma once
// The verdict on a model: a function of what is left of the error, and of nothing else.

#include <cstddef>
#include <optional>

#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

// What a set of effects leaves of the error.
struct Remainder {
  std::size_t effects = 0;      // in the set; none: the declared model
  bool leaves_nothing = false;  // noise by its tests (residual.h), or no larger than the prediction's own error
  double rms_in_noise = 0;      // of the whitened residual: 1 for noise as stated
  // BIC by which the effects are better evidence than a smooth function that names no cause (smooth_baseline.h). It
  // takes long, and is asked for only where there are effects that reach the noise.
  std::optional<double> evidence_over_smooth;
};

// It is noise, or as near to the noise as the stated one can be trusted.
[[nodiscard]] bool reaches_noise(const Remainder& left, const DiagnosisOptions& options);

// Effects that reach the noise explain only where they are better evidence than a smooth function, by `alike_bic`;
// without that evidence they explain nothing.
[[nodiscard]] Verdict verdict_of(const Remainder& left, const DiagnosisOptions& options);

}  // namespace glisson::closedloop
