#pragma once
// The demo patient's body: the generator's seed 1 (anatomy/patient.h) with a tumour and two cysts, and what lies
// around in simple shapes. SIMULATED, all of it.
//
//   glisson-cli study anatomy --seed 1 --tumour 30@6 --cyst 16@8 --cyst 11@4 --out DIR
//
// writes the same liver, vessels and lesions. Frame: patient coordinates, LPS, mm (anatomy/liver_body.h says where).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/patient.h"
#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::studies {

// A point whose displacement a surgeon would want to know.
struct DemoLandmark {
  std::string id;         // "portal-right-division", "tumour-1-centre"
  std::string structure;  // "portal-vein", "hepatic-vein", "tumour-1"
  Eigen::Vector3d position_mm{0, 0, 0};
};

// Closed surfaces. The hepatic veins are those within the liver; they open into the vena cava.
struct DemoAnatomy {
  geometry::Surface liver, portal_vein, hepatic_veins, vena_cava, arteries, gallbladder, tumour, cysts;
  geometry::Surface drawn_portal_vein, drawn_hepatic_veins;  // as far as a radiologist follows them in these voxels
  std::vector<DemoLandmark> landmarks;  // divisions of vessels inside the liver, then the tumour's centre
  double size = 1;                      // of the body: the liver's lengths against one of 2300 ml
};

// What the demo asks the generator for.
[[nodiscard]] anatomy::PatientOptions demo_patient_options();

// Landmarks are known by construction: where the trees divide among segments, and where the largest branch joins each
// hepatic vein. Fails with what anatomy::make_patient says.
Result<DemoAnatomy> make_demo_anatomy(const anatomy::PatientOptions& options = demo_patient_options(),
                                      const Progress& progress = {});

enum class Tissue : std::uint8_t {
  air,  // around the body, and gas in it
  fat,
  muscle,
  marrow,
  cortical_bone,
  disc,
  spinal_canal,
  spinal_cord,
  lung,
  heart_muscle,
  blood,
  spleen,
  kidney_cortex,
  kidney_medulla,
  stomach_wall,
  stomach_content,
  bowel_wall,
  bowel_content,
  pancreas,
  bile,
  liver,
  portal_vein,
  hepatic_vein,
  artery,
  cyst,
  tumour,
  tumour_rim,
  tumour_core
};
inline constexpr std::size_t tissue_count = 28;
using TissueImage = imaging::Image<Tissue>;

// What is at the centre of each voxel.
[[nodiscard]] TissueImage draw_tissues(const DemoAnatomy& anatomy, const imaging::Grid& grid, std::uint64_t seed);

// The voxels inside the liver's surface, with all that lies in it.
[[nodiscard]] imaging::Mask liver_mask(const DemoAnatomy& anatomy, const imaging::Grid& grid);

}  // namespace glisson::studies
