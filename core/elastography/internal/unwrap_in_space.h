#pragma once
// One image of wrapped phase, unwrapped in space, slice by slice. In most elastography each slice is excited by itself,
// at its own instant. Its phase then stands in no fixed relation to its neighbours'.

#include <vector>

#include "imaging/image.h"

namespace glisson::elastography {

// Both change voxels of the mask by whole turns only, and leave the others as they are. Pieces of the mask that do not
// touch are unwrapped each by itself. Nobody can know from one image which whole turn a piece as a whole is off by. So
// the median of each piece comes to lie in [-pi, pi].
void unwrap_by_poisson(std::vector<float>& phase_rad, const imaging::Mask& signal);
void unwrap_along_reliable_paths(std::vector<float>& phase_rad, const imaging::Mask& signal);

}  // namespace glisson::elastography
