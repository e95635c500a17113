#pragma once
// How alike two pictures look, by structure and not by bytes: two drivers that draw the same scene stay near 1.
//
// The mean structural similarity of Wang, Bovik, Sheikh and Simoncelli (IEEE Transactions on Image Processing 13, 2004,
// eq. 13): Windows are Gaussian of 1.5 pixels, on the luminance (Rec. 601). Both pictures were first reduced to about
// 256 pixels at their shorter side, as its authors advise.

#include <optional>

#include "base/result.h"
#include "vision/frame.h"

namespace glisson::vision {

struct Similarity {
  double mean = 1;   // over the mask; 1: the same, 0: nothing in common
  double worst = 1;  // of any sixteenth of the picture's sides squared, so that a small fault is not averaged away
  Frame difference;  // of the pictures' size: grey where alike, red where not
};

// Judged where `mask` is not black; everywhere without one. Failures: "pictures-differ-in-size" (of the pictures, or of
// the mask), "mask-empty".
Result<Similarity> similarity_of(const Frame& one, const Frame& other, const std::optional<Frame>& mask = {});

}  // namespace glisson::vision
