// DICOM files: scanned, and every volume that is found is read; segmentations, and directories of discs.

#include <cmath>
#include <Eigen/Core>

#include "fuzz/target.h"
#include "imaging/dicom_seg.h"
#include "imaging/read_series.h"
#include "support/dicom_files.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;
using test::SliceSpec;

std::string saved(DcmFileFormat& file, E_TransferSyntax syntax, const fs::path& folder) {
  test::save(file, folder / "seed.dcm", syntax);
  return test::bytes_of(folder / "seed.dcm");
}

// One of each way in which the reader takes pictures.
std::vector<std::string> seeds(const fs::path& folder) {
  std::vector<std::string> made;
  for (const E_TransferSyntax syntax : {EXS_LittleEndianImplicit, EXS_LittleEndianExplicit, EXS_BigEndianExplicit,
                                        EXS_RLELossless, EXS_JPEGProcess14SV1, EXS_JPEGLSLossless}) {
    made.push_back(saved(*test::dicom_slice({}), syntax, folder));
  }
  SliceSpec bytes;
  bytes.bits_allocated = bytes.bits_stored = 8;
  bytes.columns = bytes.rows = 16;
  made.push_back(saved(*test::dicom_slice(bytes), EXS_JPEGProcess1, folder));

  const std::vector<Eigen::Vector3d> places{{0, 0, 6}, {0, 0, 0}, {0, 0, 3}};
  const auto enhanced = test::enhanced_image({}, places, [](int n, int i, int j) { return 50 * n + i + j; });
  made.push_back(saved(*enhanced, EXS_LittleEndianExplicit, folder));
  made.push_back(saved(*enhanced, EXS_RLELossless, folder));

  SliceSpec tiles;
  tiles.columns = tiles.rows = 12;
  tiles.image_type = "ORIGINAL\\PRIMARY\\P\\ND\\MOSAIC";
  const auto mosaic = test::dicom_slice(tiles);
  mosaic->getDataset()->putAndInsertString(DCM_SpacingBetweenSlices, "2.5");
  mosaic->getDataset()->putAndInsertString(DcmTag(0x0019, 0x0010, EVR_LO), "SIEMENS MR HEADER");
  mosaic->getDataset()->putAndInsertUint16(DcmTag(0x0019, 0x100a, EVR_US), 7);
  made.push_back(saved(*mosaic, EXS_LittleEndianExplicit, folder));
  return made;
}

// What a reader may promise about any input: numbers, no more of them than the grid has, in a place that exists.
void check(const imaging::Series& series, const imaging::Volume& volume) {
  promise(volume.values.size() == series.grid.voxels(), "a value a voxel");
  promise(series.grid.direction.allFinite() && series.grid.origin_mm.allFinite(), "a grid in a place");
  promise((series.grid.spacing_mm.array() > 0).all(), "a spacing above zero");
  for (const float value : volume.values) promise(!std::isnan(value), "values that are numbers");
}

void run(const std::string& bytes, const fs::path& folder) {
  const auto study = imaging::scan(file_of(bytes, folder, "slice.dcm"));
  if (!study) return;
  for (const auto& series : study->series) {
    // A header may ask for far more voxels than it has bytes (compressed); more than these only take time.
    if (series.grid.voxels() > (std::size_t{1} << 22)) continue;
    for (int volume = 0; volume < std::min(series.volumes, 4); ++volume) {
      if (const auto values = imaging::read_series(series, volume)) check(series, *values);
    }
  }
}

// Two overlapping segments on three slices.
std::vector<std::string> segmentation_seeds(const fs::path& folder) {
  imaging::Mask mask;
  mask.grid.size = {5, 4, 3};
  mask.values.assign(mask.grid.voxels(), 0);
  std::vector<imaging::SegmentedMask> segments;
  for (const int value : {1, 2}) {
    for (std::size_t v = 10; v < 50; ++v) mask.values[v] = v % 3 < std::size_t(value) ? 1 : 0;
    segments.push_back({{value == 1 ? "liver" : "tumour-1", value, {1, 0, 0}}, mask});
  }
  imaging::SegmentationSource source;
  source.study_uid = "2.25.1";
  source.series_uid = "2.25.2";
  source.frame_of_reference_uid = "2.25.3";
  source.content_date = "20260101";
  source.content_time = "080000";
  promise(bool(imaging::write_dicom_seg(folder / "seg.dcm", segments, source)), "a segmentation is written");
  return {test::bytes_of(folder / "seg.dcm")};
}

void run_segmentation(const std::string& bytes, const fs::path& folder) {
  const auto segments = imaging::read_dicom_seg(file_of(bytes, folder, "seg.dcm"));
  if (!segments) return promise(!segments.error().message().empty(), "a refusal says why");
  for (const imaging::SegmentedMask& segment : *segments) {
    promise(segment.mask.values.size() == segment.mask.grid.voxels(), "a value a voxel");
    promise((segment.mask.grid.spacing_mm.array() > 0).all(), "a spacing above zero");
  }
}

std::vector<std::string> directory_seeds(const fs::path& folder) {
  DcmFileFormat directory;
  DcmDataset& data_set = *directory.getDataset();
  data_set.putAndInsertString(DCM_SOPClassUID, UID_MediaStorageDirectoryStorage);
  data_set.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.77");
  for (int k = 0; k < 3; ++k) {
    DcmItem* record = nullptr;
    data_set.findOrCreateSequenceItem(DCM_DirectoryRecordSequence, record, k);
    record->putAndInsertString(DCM_ReferencedFileID, k == 0 ? "IMAGES\\SLICE.DCM" : "..\\SLICE.DCM");
  }
  return {saved(directory, EXS_LittleEndianExplicit, folder)};
}

void run_directory(const std::string& bytes, const fs::path& folder) {
  if (fs::create_directories(folder / "IMAGES"))
    test::save(*test::dicom_slice({}), folder / "IMAGES" / "SLICE.DCM", EXS_LittleEndianExplicit);
  const auto study = imaging::scan(file_of(bytes, folder, "DICOMDIR"));
  if (!study) promise(!study.error().message().empty(), "a refusal says why");
}

}  // namespace

std::vector<Target> targets() {
  return {{"dicom", seeds, run},
          {"dicom-seg", segmentation_seeds, run_segmentation},
          {"dicomdir", directory_seeds, run_directory}};
}

}  // namespace glisson::fuzz
