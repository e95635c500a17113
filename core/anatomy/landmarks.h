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
// Portal vein: where the main branches part for right and left lobe (bifurcation), for the right sectors (right), for V
// and VIII (right-anterior), VI and VII (right-posterior), II from the rest (left), III and IV (umbilical); and where
// the largest branch leaves the pedicle of a segment (segment-1 to -8). Hepatic veins: where middle and left join
// (confluence), and where the largest tributary joins each of the three, and the largest below that in the right and
// the middle one (inferior).
[[nodiscard]] std::vector<Landmark> landmarks_of(const Patient& patient);

}  // namespace glisson::anatomy
