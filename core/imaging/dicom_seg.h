#pragma once
// DICOM Segmentation objects: structures drawn on a series, as other hospitals' systems exchange them.
//
// Positions are patient coordinates, LPS, mm. Binary and fractional segmentations are read (half of the maximum or
// more counts as inside); labels of overlapping segments stay apart because each is a mask of its own.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/segment.h"

namespace glisson::imaging {

struct SourceInstance {
  std::string sop_class_uid;
  std::string sop_instance_uid;
};

// What a segmentation refers to: the study, and the slices that it was drawn on.
struct SegmentationSource {
  std::string patient_name;
  std::string patient_id;
  std::string study_uid;
  std::string series_uid;  // of the images, not of the segmentation
  std::string frame_of_reference_uid;
  std::vector<SourceInstance> instances;  // one for each slice k of the masks' grid, or none
};

// One mask a segment, all on one grid: the planes of the frames, evenly spaced; a plane that only some segments (or
// none) have a frame for is empty in the others, since writers leave empty frames out.
// Fails with dicom-seg-unreadable, -not-a-segmentation, -compressed, -bad-geometry, -truncated.
Result<std::vector<SegmentedMask>> read_dicom_seg(const std::filesystem::path& file);

// All masks on the same grid (dicom-seg-grids-differ). Identifiers follow from the source and the segments' names, so
// that the same input gives the same bytes. Colours go as CIELab, 16 bits each.
Result<void> write_dicom_seg(const std::filesystem::path& file, const std::vector<SegmentedMask>& segments,
                             const SegmentationSource& source);

// What `series` of DICOM files (one a slice, in the order of the grid) offers as the source of a segmentation.
Result<SegmentationSource> segmentation_source(const std::vector<std::filesystem::path>& slice_files);

}  // namespace glisson::imaging
