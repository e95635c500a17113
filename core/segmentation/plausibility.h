#pragma once
// Whether what is called a liver can be a person's.

#include <optional>

#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// What is odd about this outline, in one sentence; nothing where nothing is. Odd is what fills most of the body in its
// slices, of which a person's liver takes less than half at its widest. Odd is also what holds less than 100 ml. That
// counts only where neither the first nor the last slice cuts it off, or where the image itself is narrower than a
// person's liver. The body is what is brighter than the image's dark tenth, with all that lies between. `image` is on
// the outline's grid, in any unit.
[[nodiscard]] std::optional<Sentence> doubt_of_liver(const imaging::Mask& liver, const imaging::Volume& image);

}  // namespace glisson::segmentation
