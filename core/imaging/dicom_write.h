#pragma once
// Writes a volume as a classic MR series in DICOM: one file a slice, 16-bit integers with a rescale.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::imaging {

// One of several measurements of the same slices, such as the phase offsets of MR elastography.
struct TemporalPosition {
  int number = 1;  // 1..count
  int count = 1;
  double trigger_time_ms = 0;
};

// What the series says of itself. Empty texts are written as empty where DICOM demands the attribute, else left out.
struct SeriesDescription {
  std::string patient_name;  // "FAMILY^GIVEN"
  std::string patient_id;
  std::string patient_comments;
  std::string study_uid;  // the three identifiers must be given (uid_from_name)
  std::string series_uid;
  std::string frame_of_reference_uid;
  std::string study_id;
  std::string study_description;
  std::string study_date;  // YYYYMMDD
  std::string study_time;  // HHMMSS
  int series_number = 1;
  std::string series_description;
  std::string protocol_name;
  std::string image_type = "DERIVED\\PRIMARY\\OTHER";
  std::string modality = "MR";
  std::string manufacturer;
  std::string sequence_name;
  std::string image_comments;
  double slice_thickness_mm = 0;  // 0: the spacing between slices
  double repetition_time_ms = 0;
  double echo_time_ms = 0;
  double flip_angle_deg = 0;
  double field_strength_T = 0;
  std::string rescale_type;  // what a value is after the rescale: "Pa", "um", "rad", or "US" (unspecified)
  // value = slope * stored + intercept; left out, they are chosen so that the volume's range fills 0..32767.
  std::optional<double> rescale_slope;
  std::optional<double> rescale_intercept;
  std::optional<TemporalPosition> temporal_position;
};

// Files IM_0001.dcm, ... in the order of the slices, one for each k of the grid; temporal positions after the first
// count on. `folder` is made where absent; a file that is there already is replaced. The same input gives the same
// bytes. Fails with dicom-write-empty, dicom-write-too-large, dicom-write-no-uid, dicom-write-range (a value that is
// not finite, or that the given rescale cannot hold in 16 bits), dicom-write-failed.
Result<std::vector<std::filesystem::path>> write_dicom_series(const std::filesystem::path& folder, const Volume& volume,
                                                              const SeriesDescription& description);

}  // namespace glisson::imaging
