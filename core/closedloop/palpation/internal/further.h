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

// Variations of the trial that went furthest: twice as hard, held ten times as long, pulled, or tilted by 30 degrees in
// two directions. Then up to six places of the surface that look the same way, each as far as can be from all tools and
// from each other; the first of them twice as hard and held, too. Twice as hard only where that moves no marker by more
// than 0.3 of the specimen. The simplest come first.
[[nodiscard]] std::vector<FurtherPalpation> further_palpations(const Palpation& experiment,
                                                               const std::vector<mechanics::BoundaryFace>& boundary);

}  // namespace glisson::closedloop
