#pragma once
// From the slices of a series to the bytes in its files.

#include <filesystem>
#include <vector>

#include "imaging/internal/dicom_image.h"
#include "imaging/study.h"

namespace glisson::imaging {

// A file as it was when it was scanned.
struct PixelFile {
  std::filesystem::path path;
  std::uint64_t file_bytes = 0;
  int frames = 1;
  TransferSyntax syntax;
  PixelFormat format;
  PixelElement pixels;
};

// One picture, and how its stored values become what they measure.
struct SliceSource {
  int file = 0;  // in VoxelLayout::files
  int frame = 0;
  int left = 0, top = 0;
  double slope = 1, intercept = 0;
};

// A slice of the grid: one picture, or two with weights where it lies between them.
struct SliceTerms {
  int first = 0;  // in VoxelLayout::sources
  int second = -1;
  float weight_of_second = 0;
};

struct VoxelLayout {
  std::filesystem::path volume_file;  // NIfTI, NRRD, MetaImage; else the rest holds
  std::vector<PixelFile> files;
  std::vector<SliceSource> sources;
  std::vector<SliceTerms> slices;  // volume after volume, slice k of volume v at v * size[2] + k
};

}  // namespace glisson::imaging
