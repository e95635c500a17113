#include "closedloop/inference/verdict.h"

namespace glisson::closedloop {

bool reaches_noise(const Remainder& left, const DiagnosisOptions& options) {
  const double excess =
      left.effects == 0 ? options.noise_uncertainty : options.near_noise_excess / static_cast<double>(left.effects);
  return left.leaves_nothing || left.rms_in_noise <= 1 + excess;
}

Verdict verdict_of(const Remainder& left, const DiagnosisOptions& options) {
  if (!reaches_noise(left, options)) return Verdict::unexplained;
  if (left.effects == 0) return Verdict::nothing_missing;
  const bool has_causes = left.evidence_over_smooth && *left.evidence_over_smooth >= options.alike_bic;
  return has_causes ? Verdict::explained : Verdict::unexplained;
}

}  // namespace glisson::closedloop
