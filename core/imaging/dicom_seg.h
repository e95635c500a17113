#pragma once
// DICOM Segmentation objects: structures drawn on a series, as other hospitals' systems exchange them.
//
// Positions are patient coordinates, LPS, mm. Binary and fractional segmentations are read; half of the maximum or more
// counts as inside. Labels of overlapping segments stay apart because each is a mask of its own.

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
  std::string patient_comments;
  std::string series_description = "Segmentation";  // of the segmentation itself
  std::string study_uid;
  std::string series_uid;  // of the images, not of the segmentation
  std::string frame_of_reference_uid;
  std::string study_date;                 // YYYYMMDD
  std::string study_time;                 // HHMMSS
  std::vector<SourceInstance> instances;  // one for each slice k of the masks' grid, or none
  // When the masks were made, YYYYMMDD and HHMMSS; left empty, now.
  std::string content_date;
  std::string content_time;
};

// One mask a segment, all on one grid of the frames' planes, evenly spaced. Its first axis goes along a row, the third
// along the normal. Writers leave empty frames out. So where only some segments (or none) have a frame for a plane, it
// is empty in the others. `label_value` is the segment's number where that is at most 255. Fails with what
// check_dicom_file says, and dicom-seg-not-a-segmentation, -compressed (or big endian), -bad-geometry, -truncated,
// -too-large (more than 4 GiB of masks).
[[nodiscard]] Result<std::vector<SegmentedMask>> read_dicom_seg(const std::filesystem::path& file);

// All masks on the same grid, with axes at right angles and right-handed (dicom-seg-grids-differ, -bad-geometry).
// Every plane is written for the first segment, so that the grid comes back whole; of the others those that hold
// something. Identifiers follow from the source and the masks. Colours go as CIELab.
// Fails with dicom-seg-empty, dicom-seg-no-uid, dicom-seg-not-written too.
Result<void> write_dicom_seg(const std::filesystem::path& file, const std::vector<SegmentedMask>& segments,
                             const SegmentationSource& source);

// What a series of DICOM files (one a slice, in the order of the grid) offers as the source of a segmentation.
[[nodiscard]] Result<SegmentationSource> segmentation_source(const std::vector<std::filesystem::path>& slice_files);

}  // namespace glisson::imaging
