#pragma once
// Lesions belong to the liver, also where its growing stopped at their edge.

#include <string>
#include <vector>

#include "imaging/image.h"
#include "segmentation/structures.h"

namespace glisson::segmentation {

struct WithLesions {
  imaging::Mask liver;
  std::vector<std::string> added;  // names of the lesions that were not wholly inside before
};

// The liver with the tumours and cysts among `structures` that touch it or lie within `gap_mm` of it. The cleft between
// them and the tissue is closed: partial volume makes the rim of a lesion look like neither. Vessels are left as they
// are, since their trunks run out of the organ. Masks on other grids are left out.
[[nodiscard]] WithLesions with_lesions(imaging::Mask liver, const std::vector<Structure>& structures,
                                       double gap_mm = 6);

}  // namespace glisson::segmentation
