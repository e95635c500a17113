#pragma once
// What is planned on the case's liver, drawn on it wherever a frame shows it.

#include "casefile/guided_sequence.h"

namespace glisson::casefile {

// They become lines on the liver's surface, after its other structures. The lines "planned-cut" are there where
// results/resection holds a cut that was set on the liver at rest. The lines "segments" are there where the case has
// Couinaud's segments. What cannot be read is left out.
void add_plans(GuidedSequence& guided, const Case& patient);

}  // namespace glisson::casefile
