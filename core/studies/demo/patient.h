#pragma once
// A liver MR and MR elastography study of a generated patient as DICOM files, SIMULATED, with its truth beside it.
//
// Nothing in it was measured. Every file says so: patient name, comments, descriptions, truth.json. The same seed gives
// the same bytes.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/write_patient.h"
#include "base/progress.h"
#include "base/result.h"
#include "imaging/study.h"
#include "studies/demo/anatomy.h"
#include "studies/demo/elastography.h"

namespace glisson::studies {

struct DemoOptions {
  std::uint64_t seed = 1;  // of body, texture, stiffness and noise; the patient's own stands in demo_patient_options()
  DemoStiffness stiffness;
  WaveOptions waves;  // body_size is set by the anatomy
};

// The sentence that goes wherever the demo patient is shown.
inline constexpr const char* demo_is_simulated = anatomy::is_simulated;

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

  // truth.json has landmarks, seeds, volumes and options. The true masks lie on the anatomy's grid: liver.nrrd,
  // tumour-1.nrrd, cyst.nrrd, gallbladder.nrrd. From 1.8 mm radius on there are portal-vein.nrrd and hepatic-vein.nrrd.
  // The true shear modulus, shear_kPa.nrrd, lies on the elastography's grid.
  std::filesystem::path truth_folder;
};

// The first grid has the whole liver: 256 x 208 x 70 axial voxels of 1.6 x 1.6 x 3.3 mm (slices of 3 mm with gaps). The
// second has 232 x 196 x 28 voxels of 1.64 x 1.64 x 6 mm (slices of 5 mm with gaps). It is turned by 9 degrees against
// the first. It leaves out the top of the dome and the lowest tip, as elastography does. The figure of 1.64 mm is
// section 4.3's.
[[nodiscard]] imaging::Grid demo_anatomy_grid();
[[nodiscard]] imaging::Grid demo_elastography_grid();

// Writes dicom/ and truth/ under out_folder, in place of what they held; on failure they are as they were.
// Fails with what making the anatomy and writing files say, or cancelled.
Result<DemoPatient> write_demo_study(const std::filesystem::path& out_folder, const DemoOptions& options = {},
                                     const Progress& progress = {});

}  // namespace glisson::studies
