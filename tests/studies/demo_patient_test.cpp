// The demo patient: what the program makes of its own DICOM files can be held against a known truth.

#include "studies/demo/patient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <map>

#include "base/files.h"
#include "base/json.h"
#include "base/parallel.h"
#include "imaging/read_series.h"
#include "imaging/stiffness_map.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/rasterise.h"
#include "segmentation/structures.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using imaging::Grid;
using imaging::Mask;
using imaging::Role;
using imaging::Volume;

// Made once for all tests, some ten seconds: so this program is one case to CTest.
class DemoStudy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    auto written = write_demo_study(folder_->path());
    ASSERT_TRUE(written) << written.error().message();
    patient_ = new DemoPatient(std::move(*written));
    auto scanned = imaging::scan(patient_->dicom_folder);
    ASSERT_TRUE(scanned) << scanned.error().message();
    study_ = new imaging::Study(std::move(*scanned));
  }
  static void TearDownTestSuite() {
    delete study_;
    delete patient_;
    delete folder_;
  }
  static const imaging::Series& series(Role role) {
    for (const auto& one : study_->series) {
      if (one.role == role) return one;
    }
    ADD_FAILURE() << "no series has the role " << imaging::role_name(role);
    return study_->series.front();
  }
  static Mask truth(const std::string& structure) {
    return imaging::read_mask_file(patient_->truth_folder / (structure + ".nrrd"))->mask;
  }

  static inline TemporaryFolder* folder_ = nullptr;
  static inline DemoPatient* patient_ = nullptr;
  static inline imaging::Study* study_ = nullptr;
};

TEST_F(DemoStudy, IsFoundByScanningWithEverySeriesInItsRole) {
  ASSERT_EQ(study_->series.size(), patient_->series.size());
  EXPECT_TRUE(study_->skipped.empty());
  for (const DemoSeries& written : patient_->series) {
    const imaging::Series& found = series(written.role);
    EXPECT_EQ(found.frame_of_reference_uid, study_->series.front().frame_of_reference_uid);
    EXPECT_THAT(found.description, testing::StartsWith("SIMULATED"));
    if (written.role == Role::segmentation) continue;  // its uid follows from its content
    EXPECT_EQ(found.uid, written.uid) << imaging::role_name(written.role) << " by " << found.role_evidence;
    EXPECT_THAT(found.problems, testing::IsEmpty()) << found.description;
  }
  EXPECT_EQ(series(Role::mre_wave).volumes, WaveOptions{}.phase_offsets);
}

TEST_F(DemoStudy, ComesBackOnTheGridsItWasMadeOn) {
  // Positions and directions pass through decimal strings of 16 characters: 1e-9 mm would do, 1e-4 is asked.
  EXPECT_TRUE(imaging::same_grid(series(Role::anatomy).grid, demo_anatomy_grid(), 1e-4));
  EXPECT_TRUE(imaging::same_grid(series(Role::mre_stiffness).grid, demo_elastography_grid(), 1e-4));
}

TEST_F(DemoStudy, HoldsTheTrueStiffnessInsideTheLiverAndFarTooLittleAtItsBorder) {
  const auto stored = imaging::read_series(series(Role::mre_stiffness));
  ASSERT_TRUE(stored) << stored.error().message();
  const auto map = imaging::stiffness_in_kPa(*stored);
  ASSERT_TRUE(map) << map.error().message();
  const auto confidence = imaging::read_series(series(Role::mre_confidence));
  const auto exact = imaging::read_volume_file(patient_->truth_folder / "shear_kPa.nrrd");
  ASSERT_TRUE(confidence && exact);
  ASSERT_TRUE(imaging::same_grid(exact->grid, map->shear_kPa.grid));

  const auto anatomy = make_demo_anatomy();
  const Mask liver = liver_mask(*anatomy, exact->grid);
  const Mask inner = segmentation::with_margin(liver, -6);
  double inside_error = 0, inside = 0, border_ratio = 0, border = 0;
  for (std::size_t i = 0; i < liver.values.size(); ++i) {
    if (liver.values[i] == 0 || confidence->values[i] < 0.5f || exact->values[i] <= 0) continue;
    const double ratio = map->shear_kPa.values[i] / exact->values[i];
    if (inner.values[i] != 0) {
      inside_error += std::abs(ratio - 1);
      ++inside;
    }
  }
  const Mask core = segmentation::with_margin(liver, -3);
  for (std::size_t i = 0; i < liver.values.size(); ++i) {
    if (liver.values[i] == 0 || core.values[i] != 0 || exact->values[i] <= 0) continue;
    border_ratio += map->shear_kPa.values[i] / exact->values[i];
    ++border;
  }
  ASSERT_GT(inside, 1000);
  ASSERT_GT(border, 1000);
  // The map's own noise is 25 % times a field of standard deviation 0.3, and the window blurs the patches' edges.
  EXPECT_LT(inside_error / inside, 0.12);
  EXPECT_LT(border_ratio / border, 0.6);
}

TEST_F(DemoStudy, ShowsTheLiverApartFromItsSurroundings) {
  const auto image = imaging::read_series(series(Role::anatomy));
  ASSERT_TRUE(image);
  const Mask liver = truth("liver"), tumour = truth("tumour-1"), cyst = truth("cyst");
  const Mask inner = segmentation::with_margin(liver, -5), outer = segmentation::with_margin(liver, 8);
  std::map<std::string, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < liver.values.size(); ++i) {
    const char* where = inner.values[i] && !tumour.values[i] && !cyst.values[i] ? "liver"
                        : tumour.values[i]                                      ? "tumour"
                        : cyst.values[i]                                        ? "cyst"
                        : outer.values[i] && !liver.values[i]                   ? "around"
                                                                                : "elsewhere";
    sums[where].first += image->values[i];
    ++sums[where].second;
  }
  const auto mean = [&](const char* where) { return sums[where].first / sums[where].second; };
  EXPECT_GT(mean("liver"), 1.3 * mean("tumour"));
  EXPECT_GT(mean("liver"), 1.6 * mean("around"));
  EXPECT_GT(mean("tumour"), 1.5 * mean("cyst"));
}

TEST_F(DemoStudy, HasAStiffnessAsDiseasedLiversDo) {
  const auto exact = imaging::read_volume_file(patient_->truth_folder / "shear_kPa.nrrd");
  const auto anatomy = make_demo_anatomy();
  const Mask liver = liver_mask(*anatomy, exact->grid);
  const Mask tumour = segmentation::rasterise(anatomy->tumour, exact->grid);
  double tissue_sum = 0, tissue = 0, fibrotic = 0, tumour_sum = 0, tumour_voxels = 0;
  for (std::size_t i = 0; i < liver.values.size(); ++i) {
    const double value = exact->values[i];
    if (liver.values[i] == 0 || value <= 0) continue;
    if (tumour.values[i] != 0) {
      tumour_sum += value;
      ++tumour_voxels;
      continue;
    }
    EXPECT_GT(value, 1.0);
    EXPECT_LT(value, 9.0);
    tissue_sum += value;
    ++tissue;
    fibrotic += value > 5 ? 1 : 0;
  }
  EXPECT_NEAR(tissue_sum / tissue, 3.2, 0.5) << "not between the atlas (2.1, 2.6) and cirrhosis";
  EXPECT_GT(fibrotic / tissue, 0.05);
  EXPECT_LT(fibrotic / tissue, 0.35);
  const double ratio = (tumour_sum / tumour_voxels) / (tissue_sum / tissue);
  EXPECT_GT(ratio, 3.5) << "5 times the plain tissue, which the patches bring nearer";
  EXPECT_LT(ratio, 6);
}

TEST_F(DemoStudy, SaysEverywhereThatItIsSimulated) {
  const Json document = *read_json_file(patient_->truth_folder / "truth.json");
  EXPECT_EQ(document["simulated"], demo_is_simulated);
  EXPECT_TRUE(all_numbers_finite(document));
  for (const DemoSeries& one : patient_->series) {
    for (const fs::path& file : one.files) {
      const std::string bytes = *read_text_file(file);
      for (const char* text : {"SIMULATED^GLISSON DEMO", "SIMULATED-1", demo_is_simulated}) {
        ASSERT_NE(bytes.find(text), std::string::npos) << file << " does not say " << text;
      }
    }
  }
}

TEST_F(DemoStudy, PutsItsLandmarksAndSeedsInsideTheirStructures) {
  const Mask liver = truth("liver");
  const auto holds = [](const Mask& mask, const Eigen::Vector3d& position) {
    const Eigen::Vector3d index = mask.grid.index_of(position);
    return mask.at(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
                   static_cast<int>(std::lround(index.z()))) != 0;
  };
  std::map<std::string, Mask> near_vessels;
  for (const char* name : {"portal-vein", "hepatic-vein", "tumour-1"}) {
    near_vessels.emplace(name, segmentation::with_margin(truth(name), 4));
  }
  const Mask deep = segmentation::with_margin(liver, -8);
  EXPECT_GE(patient_->landmarks.size(), 10U);
  for (const DemoLandmark& landmark : patient_->landmarks) {
    // A vessel may be thinner than a voxel's diagonal.
    EXPECT_TRUE(holds(near_vessels.at(landmark.structure), landmark.position_mm)) << landmark.id;
    EXPECT_TRUE(holds(liver, landmark.position_mm)) << landmark.id;
  }
  for (const DemoSeeds& seeds : patient_->seeds) {
    EXPECT_FALSE(seeds.positions_mm.empty()) << seeds.structure;
    if (seeds.structure != "liver") continue;
    for (const Eigen::Vector3d& seed : seeds.positions_mm) {
      EXPECT_TRUE(holds(deep, seed));
      for (const auto& [name, mask] : near_vessels) EXPECT_FALSE(holds(mask, seed)) << name;
    }
  }
}

// The volumes of the surfaces, by the divergence theorem, against the voxels that were drawn: the grid's voxels are
// 8 mm3, so that a hundred thousand of them are right to a fraction of a percent.
TEST_F(DemoStudy, KeepsTheVolumesOfItsAnatomy) {
  const auto anatomy = make_demo_anatomy();
  EXPECT_NEAR(segmentation::volume_ml(truth("liver")), geometry::volume_mm3(anatomy->liver) / 1000, 5);
  EXPECT_NEAR(segmentation::volume_ml(truth("tumour-1")), geometry::volume_mm3(anatomy->tumour) / 1000, 1);
}

std::map<std::string, std::string> hashes(const fs::path& folder) {
  std::map<std::string, std::string> of_file;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) of_file[entry.path().lexically_relative(folder)] = *sha256_of_file(entry.path());
  }
  return of_file;
}

TEST_F(DemoStudy, IsTheSameBytesFromTheSameSeedOnAnyNumberOfThreads) {
  const TemporaryFolder again;
  set_thread_count(1);
  ASSERT_TRUE(write_demo_study(again.path()));
  set_thread_count(0);
  EXPECT_EQ(hashes(folder_->path()), hashes(again.path()));
}

TEST(DemoStudyCancelled, LeavesWhatWasThere) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "dicom" / "old.txt", "old"));
  std::stop_source stop;
  stop.request_stop();
  const auto written = write_demo_study(folder.path(), {}, Progress({}, stop.get_token()));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "cancelled");
  EXPECT_EQ(hashes(folder.path()).size(), 1U);
}

}  // namespace
}  // namespace glisson::studies
