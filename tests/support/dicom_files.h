#pragma once
// DICOM files made up for a test, written with DCMTK: good ones to begin with, then broken in one way each.

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace glisson::test {

struct SliceSpec {
  std::string series_uid = "1.2.3.4";
  std::string study_uid = "1.2.3";
  std::string frame_of_reference_uid = "1.2.9";
  std::string modality = "MR";
  std::string description = "T1 axial";
  std::string image_type = "ORIGINAL\\PRIMARY\\M";
  int series_number = 3;
  int instance_number = 1;
  int columns = 8, rows = 6;
  double column_spacing_mm = 1.5, row_spacing_mm = 2;
  Eigen::Vector3d position_mm{-10, -20, 30};
  Eigen::Vector3d along_row{1, 0, 0}, along_column{0, 1, 0};
  int bits_allocated = 16, bits_stored = 16;
  bool is_signed = false;
  std::function<int(int column, int row)> value = [](int i, int j) { return 10 * i + j; };
};

// A classic image; the test adds to its data set what it is about. Every one has its own SOPInstanceUID.
std::unique_ptr<DcmFileFormat> dicom_slice(const SliceSpec& spec);

// An enhanced MR image with one frame at each position, in the order given.
std::unique_ptr<DcmFileFormat> enhanced_image(const SliceSpec& spec, const std::vector<Eigen::Vector3d>& positions_mm,
                                              const std::function<int(int frame, int column, int row)>& value);

// Compressed by DCMTK's own encoders where the transfer syntax asks for it (RLE, JPEG, JPEG-LS).
void save(DcmFileFormat& file, const std::filesystem::path& path, E_TransferSyntax syntax = EXS_LittleEndianExplicit);
void save_slice(const SliceSpec& spec, const std::filesystem::path& path,
                E_TransferSyntax syntax = EXS_LittleEndianExplicit);

// `count` slices along the normal, 3 mm apart, whose names and numbers run against their positions. The value of every
// voxel of slice k is 100 k.
void save_stack(const std::filesystem::path& folder, int count, SliceSpec spec = {}, double spacing_mm = 3);

std::string bytes_of(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace glisson::test
