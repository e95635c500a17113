#pragma once
// Several segments that share no voxel, in one file.

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "imaging/segment.h"

namespace glisson::imaging {

// A .nrrd with gzip, of 8 bits, or 16 where a value is above 255. By its fields 3D Slicer opens it as a segmentation
// with these names and colours. Each segment's label_value is its value in the map. Atomic.
Result<void> write_segments_file(const std::filesystem::path& file, const LabelMap& labels,
                                 const std::vector<SegmentInfo>& segments);

}  // namespace glisson::imaging
