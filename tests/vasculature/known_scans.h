#pragma once
// Scans of generated patients whose vessels are known: a portal-venous CT, and an MR in which vessels are dark.
//
// SIMULATED: partial volume and the blur of the scanner, noise that is blurred as a reconstruction's, tumours, and in
// MR a sensitivity that drifts. No motion, no metal, no fat beside vessels.

#include <cstdint>

#include "anatomy/patient.h"
#include "imaging/image.h"

namespace glisson::test {

struct Scanner {
  std::string unit = "HU";
  Eigen::Vector3d spacing_mm{0.75, 0.75, 1.5};
  double tissue = 105, portal = 170, hepatic = 160, tumour = 70, around = -80;
  double noise = 12;     // standard deviation of a voxel
  double blur_mm = 0.6;  // standard deviation of the point spread
  double drift = 0;      // of the brightness over 150 mm, as a share
};
inline Scanner portal_venous_ct() { return {}; }
inline Scanner hepatobiliary_mr() { return {"", {1.2, 1.2, 3.0}, 400, 230, 230, 150, 60, 16, 0.7, 0.3}; }

struct KnownScan {
  anatomy::Patient patient;
  imaging::Volume image;
  imaging::Mask liver;    // its outline
  imaging::Mask vessels;  // voxels of which half or more is vessel, of radii of 1 mm and more, in the liver
};
KnownScan make_known_scan(std::uint64_t seed, const Scanner& scanner);

}  // namespace glisson::test
