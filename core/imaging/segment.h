#pragma once
// A named structure and the voxels that belong to it, as 3D Slicer and DICOM SEG know it.

#include <array>
#include <string>

#include "imaging/image.h"

namespace glisson::imaging {

struct SegmentInfo {
  std::string name;                                // "liver", "tumour-1"
  int label_value = 1;                             // its value in the file, 1..255
  std::array<double, 3> color_rgb{0.9, 0.4, 0.3};  // sRGB, each 0..1
};

struct SegmentedMask {
  SegmentInfo info;
  Mask mask;
};

}  // namespace glisson::imaging
