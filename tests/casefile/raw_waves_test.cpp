// Raw elastography in the forms in which scanners may store it, from files to the modulus: the same waves in a body of
// 4 kPa, written by this test's own writer. No enhanced raw elastography of a real scanner was at hand.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <random>

#include "base/files.h"
#include "casefile/import.h"
#include "casefile/waves.h"
#include "elastography/wave_phantom.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "support/dicom_files.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using elastography::WaveImages;

constexpr int instants = 4;
constexpr int slices = 5;

WaveImages waves_of_4_kPa() {
  glisson::elastography::WavePhantom phantom;
  phantom.grid = glisson::elastography::cube_grid(40, slices, 2, 4);
  phantom.background_kPa = {4, 0.3};
  return glisson::elastography::measured(phantom, glisson::elastography::crossing_waves(phantom), 1.0, 0.02, instants);
}

// What the files under the folder give, imported and inverted as a person would.
void expect_4_kPa(const fs::path& files, const fs::path& case_folder, int directions,
                  const elastography::AskedFor& asked = {}) {
  const auto study = imaging::scan(files);
  ASSERT_TRUE(study.has_value()) << study.error().message();
  ImportChoice choice;
  for (const imaging::Series& series : study->series) {
    if (series.role == imaging::Role::mre_phase) choice.phase_uids.push_back(series.uid);
  }
  const auto made = new_case_from(*study, case_folder, choice);
  ASSERT_TRUE(made.has_value()) << made.error().message();
  const auto sorted = read_waves(made->patient, asked);
  ASSERT_TRUE(sorted.has_value()) << sorted.error().message();
  ASSERT_EQ(sorted->frequencies.size(), 1u);
  EXPECT_EQ(sorted->frequencies[0].phase_rad.size(), static_cast<std::size_t>(directions));
  EXPECT_EQ(sorted->frequencies[0].phase_rad[0].size(), static_cast<std::size_t>(instants));
  const auto inverted = inverted_waves(made->patient, asked);
  ASSERT_TRUE(inverted.has_value()) << inverted.error().message();
  EXPECT_EQ(inverted->map.frequencies_Hz, std::vector<double>{60});
  EXPECT_NEAR(inverted->map.confident.median, 4, 0.3);
  EXPECT_GT(inverted->map.confident_fraction, 0.3);
}

imaging::SeriesDescription described(const std::string& name, const std::string& image_type, int number) {
  imaging::SeriesDescription series;
  series.study_uid = imaging::uid_from_name("raw waves");
  series.series_uid = imaging::uid_from_name("raw waves, " + std::to_string(number));
  series.frame_of_reference_uid = imaging::uid_from_name("raw waves, frame");
  series.series_number = number;
  series.series_description = name;
  series.image_type = image_type;
  return series;
}

void write_offsets(const fs::path& folder, const WaveImages& images, std::size_t direction, const std::string& unit,
                   double scale, imaging::SeriesDescription series) {
  series.rescale_type = unit;
  for (int t = 0; t < instants; ++t) {
    imaging::Volume volume{{images.grid, images.phase_rad[direction][static_cast<std::size_t>(t)]}, unit};
    for (float& value : volume.values) value = static_cast<float>(scale * static_cast<double>(value));
    series.rescale_slope = 1e-4 * scale;
    series.temporal_position = {t + 1, instants, 1000.0 / 60 * t / instants};
    ASSERT_TRUE(imaging::write_dicom_series(folder, volume, series));
  }
}

void write_anatomy(const fs::path& folder, const imaging::Grid& grid) {
  const imaging::Volume anatomy{{grid, std::vector<float>(grid.voxels(), 300)}, ""};
  ASSERT_TRUE(imaging::write_dicom_series(folder, anatomy, described("T1 axial", "ORIGINAL\\PRIMARY\\M", 9)));
}

TEST(RawWaves, OneFileAnOffsetAndASeriesADirection) {
  const TemporaryFolder folder;
  const WaveImages images = waves_of_4_kPa();
  write_anatomy(folder.path() / "dicom" / "anatomy", images.grid);
  for (std::size_t d = 0; d < 3; ++d) {
    write_offsets(folder.path() / "dicom" / std::to_string(d), images, d, "rad", 1,
                  described("MRE phase 60 Hz", "ORIGINAL\\PRIMARY\\P\\MRE", static_cast<int>(d) + 1));
  }
  expect_4_kPa(folder.path() / "dicom", folder.path() / "p.glisson", 3);
}

// Frames of one file, in no order: the direction stands in each as MR velocity encoding, the offset as temporal
// position.
TEST(RawWaves, AnEnhancedMultiFrameImage) {
  const TemporaryFolder folder;
  const WaveImages images = waves_of_4_kPa();
  struct Frame {
    std::size_t direction, instant;
    int slice;
  };
  std::vector<Frame> frames;
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t t = 0; t < instants; ++t) {
      for (int k = 0; k < slices; ++k) frames.push_back({d, t, k});
    }
  }
  std::shuffle(frames.begin(), frames.end(), std::mt19937(3));
  glisson::test::SliceSpec spec;
  spec.description = "MRE phase 60 Hz";
  spec.image_type = "ORIGINAL\\PRIMARY\\P\\MRE";
  spec.columns = images.grid.size[0];
  spec.rows = images.grid.size[1];
  spec.column_spacing_mm = spec.row_spacing_mm = 2;
  std::vector<Eigen::Vector3d> positions_mm;
  for (const Frame& frame : frames) positions_mm.push_back(images.grid.position_mm(0, 0, frame.slice));
  const auto file = glisson::test::enhanced_image(spec, positions_mm, [&](int n, int i, int j) {
    const Frame& frame = frames[static_cast<std::size_t>(n)];
    const float phase = images.phase_rad[frame.direction][frame.instant][images.grid.offset(i, j, frame.slice)];
    return static_cast<int>(std::lround((static_cast<double>(phase) + std::numbers::pi) * 1e4));
  });
  DcmDataset& data_set = *file->getDataset();
  DcmItem* shared = nullptr;
  DcmItem* macro = nullptr;
  data_set.findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, 0);
  shared->findOrCreateSequenceItem(DCM_PixelValueTransformationSequence, macro, 0);
  macro->putAndInsertString(DCM_RescaleSlope, "0.0001");
  macro->putAndInsertString(DCM_RescaleIntercept, fmt::format("{:.6f}", -std::numbers::pi).c_str());
  macro->putAndInsertString(DCM_RescaleType, "rad");
  shared->findOrCreateSequenceItem(DCM_MRImageFrameTypeSequence, macro, 0);
  macro->putAndInsertString(DCM_ComplexImageComponent, "PHASE");
  for (std::size_t n = 0; n < frames.size(); ++n) {
    DcmItem* frame = nullptr;
    data_set.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, static_cast<signed long>(n));
    frame->findOrCreateSequenceItem(DCM_FrameContentSequence, macro, 0);
    macro->putAndInsertUint32(DCM_TemporalPositionIndex, static_cast<Uint32>(frames[n].instant + 1));
    frame->findOrCreateSequenceItem(DCM_MRVelocityEncodingSequence, macro, 0);
    const Eigen::Vector3d along = images.along[frames[n].direction];
    macro->putAndInsertFloat64Array(DCM_VelocityEncodingDirection, along.data(), 3);
  }
  fs::create_directories(folder.path() / "dicom");
  glisson::test::save(*file, folder.path() / "dicom" / "enhanced.dcm");
  write_anatomy(folder.path() / "dicom" / "anatomy", images.grid);

  const auto study = imaging::scan(folder.path() / "dicom" / "enhanced.dcm");
  ASSERT_TRUE(study.has_value() && study->series.size() == 1);
  EXPECT_EQ(study->series[0].role, imaging::Role::mre_phase);
  EXPECT_EQ(study->series[0].volumes, 3 * instants);
  EXPECT_EQ(study->series[0].motion.at(5).frequency_Hz, 60);
  expect_4_kPa(folder.path() / "dicom", folder.path() / "p.glisson", 3);
}

// A vendor's waves are displacements, unwrapped, of one direction; only their frequency may have to be asked for.
TEST(RawWaves, AVendorsWaveImages) {
  const TemporaryFolder folder;
  glisson::elastography::WavePhantom phantom;
  phantom.grid = glisson::elastography::cube_grid(40, slices, 2, 4);
  phantom.background_kPa = {4, 0.3};
  const auto components = glisson::elastography::crossing_waves(phantom);
  WaveImages images;
  images.grid = phantom.grid;
  images.phase_rad.resize(1);
  for (int t = 0; t < instants; ++t) {
    std::vector<float> displacement;
    const auto turn = std::complex<float>(std::polar(1.0, 2 * std::numbers::pi * t / instants));
    for (const auto& u : components[0]) displacement.push_back((u * turn).real());
    images.phase_rad[0].push_back(std::move(displacement));
  }
  write_anatomy(folder.path() / "dicom" / "anatomy", images.grid);
  write_offsets(folder.path() / "dicom" / "waves", images, 0, "um", 20,
                described("Wave images", "DERIVED\\PRIMARY\\WAVE\\MRE", 2));
  {
    const auto study = imaging::scan(folder.path() / "dicom");
    ASSERT_TRUE(study.has_value());
    const auto made = new_case_from(*study, folder.path() / "asked.glisson", {});
    ASSERT_TRUE(made.has_value()) << made.error().message();
    EXPECT_EQ(inverted_waves(made->patient).error().code, "waves-no-frequency");
  }
  elastography::AskedFor asked;
  asked.frequency_Hz = 60;
  expect_4_kPa(folder.path() / "dicom", folder.path() / "p.glisson", 1, asked);
}

}  // namespace
}  // namespace glisson::casefile
