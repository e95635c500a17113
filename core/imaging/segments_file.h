#pragma once
// Several segments that share no voxel, in one file.

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "imaging/segment.h"

namespace glisson::imaging {

// A .nrrd (gzip; 8 bits, 16 where a value is above 255) with the fields by which 3D Slicer opens it as a segmentation
// with these names and colours; each segment's label_value is its value in the map. Atomic.
Result<void> write_segments_file(const std::filesystem::path& file, const LabelMap& labels,
                                 const std::vector<SegmentInfo>& segments);

}  // namespace glisson::imaging
