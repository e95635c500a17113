// Comparing the places of two images.

#include "imaging/image.h"

#include <algorithm>

namespace glisson::imaging {

// A grid is an affine frame, so the voxels differ most at one of the eight corners.
bool same_grid(const Grid& a, const Grid& b, double tolerance_mm) {
  if (a.size != b.size) return false;
  for (const int i : {0, std::max(0, a.size[0] - 1)}) {
    for (const int j : {0, std::max(0, a.size[1] - 1)}) {
      for (const int k : {0, std::max(0, a.size[2] - 1)}) {
        if (!((a.position_mm(i, j, k) - b.position_mm(i, j, k)).norm() <= tolerance_mm)) return false;
      }
    }
  }
  return true;
}

}  // namespace glisson::imaging
