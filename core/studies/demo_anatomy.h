#pragma once
// The demo patient's body: the liver and its vessels, tumour, cysts and gall bladder from a real patient's scan
// (resources/demo/anatomy), the rest drawn around them in simple shapes. SIMULATED but for the surfaces named.
//
// Frame. The surfaces are in patient coordinates (LPS, mm) as they are in the files: no transform is applied. That they
// are is read off the anatomy: the greater part of the liver lies at negative x (right), the gall bladder's fundus
// (y -246) before the aorta (y -155 to -128, that is: towards the front), and the hepatic veins meet upwards, in the
// vena cava at (-33, -167, -243), above the portal vein's division at z -274.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::studies {

// A point whose displacement a surgeon would want to know.
struct DemoLandmark {
  std::string id;         // "portal-bifurcation", "tumour-1-centre"
  std::string structure;  // "portal-vein", "hepatic-vein", "tumour-1"
  Eigen::Vector3d position_mm{0, 0, 0};
};

struct DemoAnatomy {
  geometry::Surface liver, portal_vein, hepatic_veins, arteries, gallbladder, tumour, cysts;
  std::vector<DemoLandmark> landmarks;  // those of landmarks.json, then the tumour's centre
};

// Fails with what geometry::read_surface and read_json_file say, and demo-anatomy-not-closed.
Result<DemoAnatomy> read_demo_anatomy(const std::filesystem::path& folder);

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
