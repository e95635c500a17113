#pragma once
// Places in a generated patient's vessels that books name, known by construction.

#include <string>
#include <vector>

#include "anatomy/patient.h"

namespace glisson::anatomy {

struct Landmark {
  std::string id;                        // "portal-right-division"
  std::string structure;                 // "portal-vein", "hepatic-vein"
  Eigen::Vector3d position_mm{0, 0, 0};  // placed
};

// On the centre lines, at least 3 mm under the liver's surface; those that a patient has not, or not there, are absent.
//
// Portal vein (portal-...), where branches part:
//   bifurcation                 the right lobe from the left
//   right-division              the right sectors
//   right-anterior-division     V from VIII
//   right-posterior-division    VI from VII
//   left-division               II from III and IV
//   umbilical-division          III from IV
//   segment-N-division          where the largest branch leaves the pedicle of segment N, 1 to 8
// Hepatic veins (hepatic-...), where they join:
//   confluence                  the middle and the left one
//   NAME-division               the largest tributary and the right, the middle or the left one
//   NAME-inferior-division      the largest at least 15 mm below that, of the right and the middle one
[[nodiscard]] std::vector<Landmark> landmarks_of(const Patient& patient);

}  // namespace glisson::anatomy
