#pragma once
// Volumes, label maps and masks in files that 3D Slicer and ITK-SNAP open: NIfTI, NRRD, MetaImage.
//
// Reads .nii .nii.gz .nrrd .nhdr .mha .mhd, three-dimensional (a fourth axis of length one is dropped), one value a
// voxel. Positions come out in patient coordinates, LPS, mm; what a file says in RAS is turned. The size that a header
// declares is compared, in 64 bits, with the size of the file before memory is asked for. The voxels that come are
// counted. Compressed ones must end where they should, with the right checksum.

#include <filesystem>

#include "base/result.h"
#include "imaging/image.h"
#include "imaging/segment.h"

namespace glisson::imaging {

// What the header alone says, believed under the same conditions; scan() lists such files by it.
struct VolumeFileHeader {
  Grid grid;
  std::string unit;
  bool holds_bytes = false;  // whole numbers of 8 bits, as label maps mostly are
};
Result<VolumeFileHeader> read_volume_file_header(const std::filesystem::path& file);

// Whether the name ends as those of the formats above.
bool has_volume_file_name(const std::filesystem::path& file);

// Any scalar type, as float (a value beyond 2^24 loses its last digits). The unit is that of the NRRD or MetaImage
// key "unit"; NIfTI has no place for it.
// Fails with volume-file-unknown-type, -unreadable, -not-scalar, -not-3d, -bad-grid, -too-large (above 2^29 voxels),
// -truncated, -longer, -damaged.
Result<Volume> read_volume_file(const std::filesystem::path& file);

// The same for whole numbers 0..65535; refuses others (volume-file-not-labels), since they are not a label map.
Result<LabelMap> read_labels_file(const std::filesystem::path& file);

// The format follows from the extension (.nrrd, .nii, .nii.gz, .mha); 32-bit floats, compressed but for .nii; atomic.
Result<void> write_volume_file(const std::filesystem::path& file, const Volume& volume);

// A .nrrd (gzip, 8 bits, 0 or label_value) with the fields that 3D Slicer needs to open it as one named, coloured
// segment. Slicer takes the name ".seg.nrrd" for a segmentation unasked and asks for the kind at plain ".nrrd".
Result<void> write_mask_file(const std::filesystem::path& file, const Mask& mask, const SegmentInfo& info);

// The first segment of such a file: the voxels that hold its label value. A file without segment fields is taken as
// one segment named after the file, of all voxels that are not zero.
Result<SegmentedMask> read_mask_file(const std::filesystem::path& file);

}  // namespace glisson::imaging
