// DICOM files: scanned, and every volume that is found is read.

#include <cmath>
#include <Eigen/Core>

#include "fuzz/target.h"
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

}  // namespace

std::vector<Target> targets() { return {{"dicom", seeds, run}}; }

}  // namespace glisson::fuzz
