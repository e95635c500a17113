#pragma once
// What the headers of one DICOM file say, as far as finding and reading images needs it.

#include <cstdint>
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/internal/checked_dicom.h"

namespace glisson::imaging {

// How one picture is stored: PS3.3 C.7.6.3.
struct PixelFormat {
  int columns = 0;
  int rows = 0;
  int samples = 1;  // more than one: colour
  int bits_allocated = 16;
  int bits_stored = 16;
  int high_bit = 15;
  bool is_signed = false;
  std::string photometric = "MONOCHROME2";

  [[nodiscard]] bool is_colour() const { return samples != 1 || photometric == "PALETTE COLOR"; }
  [[nodiscard]] std::uint64_t frame_bits() const {
    return std::uint64_t(columns) * std::uint64_t(rows) * std::uint64_t(samples) * std::uint64_t(bits_allocated);
  }
};

// value = slope * stored + intercept, in `unit` (see Volume); `evidence` names the header fields.
struct ValueMapping {
  double slope = 1;
  double intercept = 0;
  std::string unit;
  std::string evidence;
  bool stated = false;  // false: the header says nothing of it
};

// One picture: a file's only one, one frame of many, or one tile of a mosaic.
struct Picture {
  int frame = 0;          // in the file
  int left = 0, top = 0;  // of its first pixel in the frame
  int columns = 0, rows = 0;
  bool placed = false;                   // whether the header gives the place in the patient
  Eigen::Vector3d position_mm{0, 0, 0};  // centre of the first pixel, LPS
  Eigen::Vector3d along_row{1, 0, 0};    // unit vectors
  Eigen::Vector3d along_column{0, 1, 0};
  double column_spacing_mm = 1;  // between neighbours in a row
  double row_spacing_mm = 1;
  ValueMapping mapping;
  // What may tell pictures at the same place apart; 0 or empty where not given.
  std::string stack_id;
  std::string component;  // "M", "P", ...: which part of the complex signal
  int temporal_position = 0;
  int echo_number = 0;
  double echo_time_ms = 0;
  double trigger_time_ms = 0;
  double b_value = 0;
  std::string comments;                         // of this frame of many
  std::optional<Eigen::Vector3d> motion_along;  // the direction in which motion was encoded: a unit vector, LPS
  double slice_thickness_mm = 0;
  std::optional<double> time_in_volume_ms;  // when it was acquired, after the first slice of its volume
};

struct DicomImage {
  std::filesystem::path path;
  std::string sop_class_uid, sop_instance_uid, series_uid, study_uid, frame_of_reference_uid;
  std::string description, protocol, sequence_name, modality, manufacturer, comments;
  std::vector<std::string> image_type;
  std::string ge_pulse_sequence;  // (0019,xx9c) of GEMS_ACQU_01: "fgremre", "epimre"
  int series_number = 0, instance_number = 0, acquisition_number = 0;
  int temporal_positions = 0;  // NumberOfTemporalPositions
  std::string acquisition_time;
  double gantry_tilt_deg = 0;
  double window_center = 0, window_width = 0;
  TransferSyntax syntax;
  PixelFormat format;
  PixelElement pixels;
  std::uint64_t file_bytes = 0;
  int frames = 1;
  std::vector<Picture> pictures;
  std::vector<std::string> problems;  // of this file alone
};

// Fails as check_dicom_file does, and with "dicom-no-image" (a report, a plan, ...). Fails with "dicom-size" (the sizes
// do not fit together) or "dicom-truncated" (fewer pixels than the sizes ask for).
[[nodiscard]] Result<DicomImage> read_dicom_image_header(const std::filesystem::path& file);

// The files that a DICOMDIR names, as paths beside it.
[[nodiscard]] Result<std::vector<std::filesystem::path>> files_named_in_dicomdir(const std::filesystem::path& dicomdir);

}  // namespace glisson::imaging
