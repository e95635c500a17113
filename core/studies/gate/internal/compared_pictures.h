#pragma once
// Two versions' pictures of one case, as the gate judges them and as it shows them.

#include <string>

#include "studies/gate/gate.h"
#include "vision/frame.h"
#include "vision/similarity.h"

namespace glisson::studies {

struct ComparedPictures {
  vision::Frame base, now;
  vision::Similarity similarity;  // where the picture's mask is white
};

// `name` is one that both have. Fails as read_frame() and similarity_of() do.
Result<ComparedPictures> compared_pictures(const std::string& name, const Results& base, const Results& now,
                                           const GateOptions& options);

}  // namespace glisson::studies
