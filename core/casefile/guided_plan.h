#pragma once
// What is planned on the case's liver, drawn on it wherever a frame shows it.

#include "casefile/guided_sequence.h"

namespace glisson::casefile {

// As lines on the liver's surface, after its other structures: "planned-cut" where results/resection holds a cut that
// was set on the liver at rest, "segments" where the case has Couinaud's segments. What cannot be read is left out.
void add_plans(GuidedSequence& guided, const Case& patient);

}  // namespace glisson::casefile
