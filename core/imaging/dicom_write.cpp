#include "imaging/dicom_write.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>

#include "base/files.h"
#include "imaging/dicom_uid.h"
#include "imaging/internal/dicom_text.h"

// DCMTK after ours: its headers define macros.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

struct Rescale {
  double slope = 1;
  double intercept = 0;
};
Result<Rescale> rescale_for(const Volume& volume, const SeriesDescription& series);
Result<std::vector<Sint16>> stored_slice(const Volume& volume, int k, const Rescale& rescale);

// Puts texts in a dataset and remembers whether DCMTK took them all.
class Writer {
 public:
  explicit Writer(DcmDataset& dataset) : dataset_(dataset) {}
  void text(const DcmTagKey& tag, const std::string& value) {
    good_ = good_ && dataset_.putAndInsertString(tag, value.c_str()).good();
  }
  void text_if_any(const DcmTagKey& tag, const std::string& value) {
    if (!value.empty()) text(tag, value);
  }
  void number_if_any(const DcmTagKey& tag, double value) {
    if (value != 0) text(tag, decimal_string(value));
  }
  void word(const DcmTagKey& tag, int value) {
    good_ = good_ && dataset_.putAndInsertUint16(tag, static_cast<Uint16>(value)).good();
  }
  void pixels(const std::vector<Sint16>& values) {
    good_ = good_ && dataset_
                         .putAndInsertUint16Array(DCM_PixelData, reinterpret_cast<const Uint16*>(values.data()),
                                                  static_cast<unsigned long>(values.size()))
                         .good();
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  DcmDataset& dataset_;
  bool good_ = true;
};

void describe_series(Writer& write, const SeriesDescription& series, const Rescale& rescale);
void describe_slice(Writer& write, const Grid& grid, int k, const SeriesDescription& series, int instance_number);

}  // namespace

Result<std::vector<fs::path>> write_dicom_series(const fs::path& folder, const Volume& volume,
                                                 const SeriesDescription& series) {
  const Grid& grid = volume.grid;
  if (grid.voxels() == 0 || volume.values.size() != grid.voxels()) {
    return failure("dicom-write-empty", GLISSON_TEXT("The volume holds no voxels, so no series can be written to {0}."),
                   {folder.string()});
  }
  if (grid.size[0] > 65535 || grid.size[1] > 65535) {
    return failure("dicom-write-too-large",
                   GLISSON_TEXT("The slices have {0} x {1} voxels; DICOM counts rows and columns up to 65535."),
                   {std::to_string(grid.size[0]), std::to_string(grid.size[1])});
  }
  if (series.study_uid.empty() || series.series_uid.empty() || series.frame_of_reference_uid.empty()) {
    return failure("dicom-write-no-uid",
                   GLISSON_TEXT("The series {0} needs the identifiers of its study, of itself and of its frame of "
                                "reference."),
                   {series.series_description});
  }
  const auto rescale = rescale_for(volume, series);
  if (!rescale) return failure(rescale.error());

  const int before = series.temporal_position ? (series.temporal_position->number - 1) * grid.size[2] : 0;
  std::vector<fs::path> files;
  for (int k = 0; k < grid.size[2]; ++k) {
    const auto stored = stored_slice(volume, k, *rescale);
    if (!stored) return failure(stored.error());
    DcmFileFormat format;
    Writer write(*format.getDataset());
    describe_series(write, series, *rescale);
    describe_slice(write, grid, k, series, before + k + 1);
    write.pixels(*stored);

    const fs::path file = folder / fmt::format("IM_{:04}.dcm", before + k + 1);
    auto written = write_atomically(file, [&](const fs::path& beside) -> Result<void> {
      const OFCondition saved =
          write.good() ? format.saveFile(beside.c_str(), EXS_LittleEndianExplicit) : EC_IllegalCall;
      if (saved.good()) return {};
      return failure(Error{"dicom-write-failed",
                           GLISSON_TEXT("{0} cannot be written: {1}."),
                           {file.string(), saved.text()},
                           GLISSON_TEXT("Check the folder, your rights there and the free space."),
                           file});
    });
    if (!written) return failure(std::move(written.error()));
    files.push_back(file);
  }
  return files;
}

namespace {

Result<Rescale> rescale_for(const Volume& volume, const SeriesDescription& series) {
  const auto [low, high] = std::minmax_element(volume.values.begin(), volume.values.end());
  const double range = static_cast<double>(*high) - static_cast<double>(*low);
  Rescale rescale;
  rescale.intercept = series.rescale_intercept.value_or(series.rescale_slope ? 0.0 : static_cast<double>(*low));
  rescale.slope = series.rescale_slope.value_or(range > 0 ? range / 32767 : 1.0);
  // What is written is what counts: 16 characters may hold a little less than the number.
  rescale.intercept = std::stod(decimal_string(rescale.intercept));
  rescale.slope = std::stod(decimal_string(rescale.slope));
  if (std::isfinite(rescale.slope) && std::isfinite(rescale.intercept) && rescale.slope != 0) return rescale;
  return failure("dicom-write-range", GLISSON_TEXT("The volume holds values that are not finite; DICOM cannot."));
}

Result<std::vector<Sint16>> stored_slice(const Volume& volume, int k, const Rescale& rescale) {
  const Grid& grid = volume.grid;
  const auto area = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  const float* values = volume.values.data() + area * static_cast<std::size_t>(k);
  std::vector<Sint16> stored(area);
  for (std::size_t i = 0; i < area; ++i) {
    const double number = std::round((static_cast<double>(values[i]) - rescale.intercept) / rescale.slope);
    // Written so that what is not a number is refused too.
    if (!(number >= -32768 && number <= 32768)) {
      return failure(
          "dicom-write-range",
          GLISSON_TEXT("Slice {0} holds the value {1}, which the rescale {2} x + {3} cannot hold in 16 bits."),
          {std::to_string(k), fmt::format("{:g}", values[i]), decimal_string(rescale.slope),
           decimal_string(rescale.intercept)});
    }
    // One above is the rounding of the slope itself to 16 characters.
    stored[i] = static_cast<Sint16>(std::min(number, 32767.0));
  }
  return stored;
}

void describe_series(Writer& write, const SeriesDescription& series, const Rescale& rescale) {
  write.text(DCM_SpecificCharacterSet, "ISO_IR 192");
  write.text(DCM_ImageType, series.image_type);
  write.text(DCM_SOPClassUID, UID_MRImageStorage);
  write.text(DCM_StudyDate, series.study_date);
  write.text(DCM_StudyTime, series.study_time);
  write.text(DCM_AccessionNumber, "");
  write.text(DCM_Modality, series.modality);
  write.text(DCM_Manufacturer, series.manufacturer);
  write.text(DCM_ReferringPhysicianName, "");
  write.text_if_any(DCM_StudyDescription, series.study_description);
  write.text_if_any(DCM_SeriesDescription, series.series_description);
  write.text(DCM_PatientName, series.patient_name);
  write.text(DCM_PatientID, series.patient_id);
  write.text(DCM_PatientBirthDate, "");
  write.text(DCM_PatientSex, "");
  write.text_if_any(DCM_PatientComments, series.patient_comments);
  write.text(DCM_ScanningSequence, "RM");  // research mode: the sequence is told by its name
  write.text(DCM_SequenceVariant, "NONE");
  write.text(DCM_ScanOptions, "");
  write.text(DCM_MRAcquisitionType, "2D");
  write.text_if_any(DCM_SequenceName, series.sequence_name);
  write.number_if_any(DCM_RepetitionTime, series.repetition_time_ms);
  write.number_if_any(DCM_EchoTime, series.echo_time_ms);
  write.number_if_any(DCM_MagneticFieldStrength, series.field_strength_T);
  write.text(DCM_EchoTrainLength, "");
  write.text_if_any(DCM_ProtocolName, series.protocol_name);
  write.number_if_any(DCM_FlipAngle, series.flip_angle_deg);
  write.text(DCM_PatientPosition, "HFS");
  write.text(DCM_StudyInstanceUID, series.study_uid);
  write.text(DCM_SeriesInstanceUID, series.series_uid);
  write.text(DCM_StudyID, series.study_id);
  write.text(DCM_SeriesNumber, std::to_string(series.series_number));
  write.text(DCM_FrameOfReferenceUID, series.frame_of_reference_uid);
  write.text(DCM_PositionReferenceIndicator, "");
  write.text_if_any(DCM_ImageComments, series.image_comments);
  if (series.temporal_position) {
    write.text(DCM_TriggerTime, decimal_string(series.temporal_position->trigger_time_ms));
    write.text(DCM_TemporalPositionIdentifier, std::to_string(series.temporal_position->number));
    write.text(DCM_NumberOfTemporalPositions, std::to_string(series.temporal_position->count));
  }
  write.text(DCM_RescaleIntercept, decimal_string(rescale.intercept));
  write.text(DCM_RescaleSlope, decimal_string(rescale.slope));
  write.text(DCM_RescaleType, series.rescale_type.empty() ? "US" : series.rescale_type);
}

void describe_slice(Writer& write, const Grid& grid, int k, const SeriesDescription& series, int instance_number) {
  const Eigen::Vector3d row = grid.direction.col(0);
  const Eigen::Vector3d column = grid.direction.col(1);
  const Eigen::Vector3d normal = row.cross(column);
  const Eigen::Vector3d position = grid.position_mm(0, 0, k);
  write.text(DCM_SOPInstanceUID, uid_from_name(fmt::format("{}/{}", series.series_uid, instance_number)));
  write.text(DCM_InstanceNumber, std::to_string(instance_number));
  write.text(DCM_ImagePositionPatient, decimal_strings({position.x(), position.y(), position.z()}));
  write.text(DCM_ImageOrientationPatient,
             decimal_strings({row.x(), row.y(), row.z(), column.x(), column.y(), column.z()}));
  write.text(DCM_SliceLocation, decimal_string(normal.dot(position)));
  write.text(DCM_SliceThickness,
             decimal_string(series.slice_thickness_mm > 0 ? series.slice_thickness_mm : grid.spacing_mm[2]));
  write.text(DCM_SpacingBetweenSlices, decimal_string(grid.spacing_mm[2]));
  write.text(DCM_PixelSpacing, decimal_strings({grid.spacing_mm[1], grid.spacing_mm[0]}));  // between rows first
  write.word(DCM_SamplesPerPixel, 1);
  write.text(DCM_PhotometricInterpretation, "MONOCHROME2");
  write.word(DCM_Rows, grid.size[1]);
  write.word(DCM_Columns, grid.size[0]);
  write.word(DCM_BitsAllocated, 16);
  write.word(DCM_BitsStored, 16);
  write.word(DCM_HighBit, 15);
  write.word(DCM_PixelRepresentation, 1);
}

}  // namespace
}  // namespace glisson::imaging
