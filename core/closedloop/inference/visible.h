#pragma once
// What an experiment could have shown, so that "nothing is missing" can be read for what it is worth. For each effect
// it is the smallest size that these trials, places and this noise would have brought to light.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"
#include "closedloop/inference/fit.h"

namespace glisson::closedloop {

// One answer for each effect of the catalogue, and for each of its parameters that alone switches it on. Its other
// parameters stand where they have no effect. The answer is the value from which the effect would
// pay by BIC in VisibleOptions::power of all repetitions, and change more than the prediction's own error. Of several
// forms of a kind the first that has such a parameter; laws without a number that makes them vanish are left out.
// Values are looked for on the side on which a surgeon would expect more of them. Fails where the declared model cannot
// be solved, and when cancelled.
Result<std::vector<SmallestVisible>> smallest_visible(const ForwardModel& model,
                                                      const SystematicUncertainty& systematic,
                                                      const Whitening& whitening, const DiagnosisOptions& options,
                                                      const Progress& progress = {});

// "stiffness-scale (factor) from 1.02", one after the other; a person's words.
[[nodiscard]] std::string visible_sentence(const Explanation& explanation);

}  // namespace glisson::closedloop
