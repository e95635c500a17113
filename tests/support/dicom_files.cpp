// DICOM files made up for a test.

#include "support/dicom_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <fstream>
#include <sstream>

#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>

namespace glisson::test {
namespace {

std::string next_instance_uid() {
  static int count = 0;
  return "1.2.3.999." + std::to_string(++count);
}

std::string decimals(const Eigen::Vector3d& v) { return fmt::format("{:.9g}\\{:.9g}\\{:.9g}", v[0], v[1], v[2]); }

void put(DcmItem& item, const DcmTagKey& key, const std::string& text) { item.putAndInsertString(key, text.c_str()); }

void put_pixels(DcmDataset& data_set, const SliceSpec& spec, const std::vector<int>& values) {
  if (spec.bits_allocated == 8) {
    const std::vector<Uint8> bytes(values.begin(), values.end());
    data_set.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
  } else {
    std::vector<Uint16> words;
    for (const int value : values) words.push_back(static_cast<Uint16>(value));
    data_set.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
  }
}

void register_encoders() {
  static const bool once = [] {
    DcmRLEEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs();
    DJLSEncoderRegistration::registerCodecs();
    return true;
  }();
  (void)once;
}

}  // namespace

std::unique_ptr<DcmFileFormat> dicom_slice(const SliceSpec& spec) {
  auto file = std::make_unique<DcmFileFormat>();
  DcmDataset& data_set = *file->getDataset();
  put(data_set, DCM_SOPClassUID, spec.modality == "CT" ? UID_CTImageStorage : UID_MRImageStorage);
  put(data_set, DCM_SOPInstanceUID, next_instance_uid());
  put(data_set, DCM_StudyInstanceUID, spec.study_uid);
  put(data_set, DCM_SeriesInstanceUID, spec.series_uid);
  put(data_set, DCM_FrameOfReferenceUID, spec.frame_of_reference_uid);
  put(data_set, DCM_Modality, spec.modality);
  put(data_set, DCM_SeriesDescription, spec.description);
  put(data_set, DCM_ImageType, spec.image_type);
  put(data_set, DCM_SeriesNumber, std::to_string(spec.series_number));
  put(data_set, DCM_InstanceNumber, std::to_string(spec.instance_number));
  put(data_set, DCM_ImagePositionPatient, decimals(spec.position_mm));
  put(data_set, DCM_ImageOrientationPatient, decimals(spec.along_row) + "\\" + decimals(spec.along_column));
  put(data_set, DCM_PixelSpacing, fmt::format("{:.9g}\\{:.9g}", spec.row_spacing_mm, spec.column_spacing_mm));
  put(data_set, DCM_SliceThickness, "17");  // never the spacing
  put(data_set, DCM_PhotometricInterpretation, "MONOCHROME2");
  data_set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  data_set.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(spec.rows));
  data_set.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(spec.columns));
  data_set.putAndInsertUint16(DCM_BitsAllocated, static_cast<Uint16>(spec.bits_allocated));
  data_set.putAndInsertUint16(DCM_BitsStored, static_cast<Uint16>(spec.bits_stored));
  data_set.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(spec.bits_stored - 1));
  data_set.putAndInsertUint16(DCM_PixelRepresentation, spec.is_signed ? 1 : 0);
  std::vector<int> values;
  for (int j = 0; j < spec.rows; ++j) {
    for (int i = 0; i < spec.columns; ++i) values.push_back(spec.value(i, j));
  }
  put_pixels(data_set, spec, values);
  return file;
}

std::unique_ptr<DcmFileFormat> enhanced_image(const SliceSpec& spec, const std::vector<Eigen::Vector3d>& positions_mm,
                                              const std::function<int(int, int, int)>& value) {
  auto file = dicom_slice(spec);
  DcmDataset& data_set = *file->getDataset();
  put(data_set, DCM_SOPClassUID, UID_EnhancedMRImageStorage);
  put(data_set, DCM_NumberOfFrames, std::to_string(positions_mm.size()));
  for (const DcmTagKey& key :
       {DCM_ImagePositionPatient, DCM_ImageOrientationPatient, DCM_PixelSpacing, DCM_SliceThickness}) {
    data_set.findAndDeleteElement(key);
  }
  DcmItem* macro = nullptr;
  DcmItem* shared = nullptr;
  data_set.findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, 0);
  shared->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, macro, 0);
  put(*macro, DCM_ImageOrientationPatient, decimals(spec.along_row) + "\\" + decimals(spec.along_column));
  shared->findOrCreateSequenceItem(DCM_PixelMeasuresSequence, macro, 0);
  put(*macro, DCM_PixelSpacing, fmt::format("{:.9g}\\{:.9g}", spec.row_spacing_mm, spec.column_spacing_mm));
  std::vector<int> values;
  for (std::size_t n = 0; n < positions_mm.size(); ++n) {
    DcmItem* frame = nullptr;
    data_set.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, static_cast<signed long>(n));
    frame->findOrCreateSequenceItem(DCM_PlanePositionSequence, macro, 0);
    put(*macro, DCM_ImagePositionPatient, decimals(positions_mm[n]));
    for (int j = 0; j < spec.rows; ++j) {
      for (int i = 0; i < spec.columns; ++i) values.push_back(value(static_cast<int>(n), i, j));
    }
  }
  put_pixels(data_set, spec, values);
  return file;
}

void save(DcmFileFormat& file, const std::filesystem::path& path, E_TransferSyntax syntax) {
  register_encoders();
  const DJ_RPLossless lossless;
  const DJ_RPLossy lossy(100);
  const DJLSRepresentationParameter jpeg_ls(0, OFTrue);
  const DcmRepresentationParameter* parameter = nullptr;
  if (syntax == EXS_JPEGProcess14SV1) parameter = &lossless;
  if (syntax == EXS_JPEGProcess1) parameter = &lossy;
  if (syntax == EXS_JPEGLSLossless) parameter = &jpeg_ls;
  ASSERT_TRUE(file.getDataset()->chooseRepresentation(syntax, parameter).good()) << path;
  const OFCondition saved = file.saveFile(path.c_str(), syntax);
  ASSERT_TRUE(saved.good()) << path << ": " << saved.text();
}

void save_slice(const SliceSpec& spec, const std::filesystem::path& path, E_TransferSyntax syntax) {
  save(*dicom_slice(spec), path, syntax);
}

void save_stack(const std::filesystem::path& folder, int count, SliceSpec spec, double spacing_mm) {
  std::filesystem::create_directories(folder);
  const Eigen::Vector3d first = spec.position_mm;
  const Eigen::Vector3d normal = spec.along_row.cross(spec.along_column);
  for (int k = 0; k < count; ++k) {
    spec.position_mm = first + normal * (spacing_mm * k);
    spec.instance_number = count - k;
    spec.value = [k](int, int) { return 100 * k; };
    save_slice(spec, folder / fmt::format("IM_{:04}.dcm", count - k));
  }
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace glisson::test
