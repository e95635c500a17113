#pragma once
// Trials that could still be made on a specimen: where, how hard and for how long. They are sentences, and what the
// model is asked to predict.

#include <vector>

#include "base/sentence.h"
#include "closedloop/experiment/experiment.h"
#include "mechanics/elements/boundary.h"

namespace glisson::closedloop {

struct FurtherPalpation {
  Sentence sentence;     // for a person: "Press at (…) mm with 2 N."
  PalpationTrial trial;  // one sample with the markers of the experiment; their positions mean nothing
};

// Variations of the trial that went furthest. One presses the place of the surface that is furthest from all tools and
// looks the same way. The others press twice as hard, hold ten times as long, or pull.
[[nodiscard]] std::vector<FurtherPalpation> further_palpations(const Palpation& experiment,
                                                               const std::vector<mechanics::BoundaryFace>& boundary);

}  // namespace glisson::closedloop
