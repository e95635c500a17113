#pragma once
// A liver MR and MR elastography study as DICOM files, SIMULATED from a real patient's anatomy, with its truth beside
// it.
//
// Nothing in it was measured but the surfaces of the liver and what lies in it (resources/demo/anatomy). Every file
// says so: patient name, comments, descriptions, truth.json. The same seed gives the same bytes.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/study.h"
#include "studies/demo_anatomy.h"
#include "studies/demo_elastography.h"

namespace glisson::studies {

struct DemoOptions {
  std::uint64_t seed = 2026;
  DemoStiffness stiffness;
  WaveOptions waves;
};

// The sentence that goes wherever the demo patient is shown.
inline constexpr const char* demo_is_simulated =
    "SIMULATED from a real patient's anatomy: nothing but the shape of the liver and of what lies in it is real.";

struct DemoSeries {
  imaging::Role role = imaging::Role::other;
  std::string uid;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> files;
};

// Where to click for a structure, as a person would.
struct DemoSeeds {
  std::string structure;
  std::vector<Eigen::Vector3d> positions_mm;
};

struct DemoPatient {
  std::filesystem::path dicom_folder;  // one folder a series
  std::vector<DemoSeries> series;      // anatomy, magnitude, wave, stiffness, confidence, drawn structures (DICOM SEG)
  std::vector<DemoLandmark> landmarks;
  std::vector<DemoSeeds> seeds;

  // truth.json (landmarks, seeds, volumes, options), the true masks on the anatomy's grid (liver.nrrd, tumour-1.nrrd,
  // cyst.nrrd, portal-vein.nrrd, hepatic-vein.nrrd, gallbladder.nrrd) and shear_kPa.nrrd, the true shear modulus on
  // the elastography's grid.
  std::filesystem::path truth_folder;
};

// The grids: 256 x 208 x 70 axial voxels of 1.6 x 1.6 x 3.3 mm (slices of 3 mm with gaps), the whole liver; and
// 232 x 196 x 28 voxels of 1.64 x 1.64 x 6 mm (slices of 5 mm with gaps), turned by 9 degrees against them, which leave
// out the top of the dome and the lowest tip, as elastography does. 1.64 mm is section 4.3's.
[[nodiscard]] imaging::Grid demo_anatomy_grid();
[[nodiscard]] imaging::Grid demo_elastography_grid();

// Writes dicom/ and truth/ under out_folder, in place of what they held; on failure they are as they were.
// Fails with what reading the anatomy and writing files say, or cancelled.
Result<DemoPatient> write_demo_study(const std::filesystem::path& anatomy_folder,
                                     const std::filesystem::path& out_folder, const DemoOptions& options = {},
                                     const Progress& progress = {});

}  // namespace glisson::studies
