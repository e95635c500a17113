#pragma once
// Bringing a stiffness map to kPa of shear modulus, whichever unit it was stored in.

#include <string>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::imaging {

struct StiffnessMap {
  Volume shear_kPa;      // unit "kPa"; 0 where the scanner gave nothing
  std::string evidence;  // why it was taken to be in Pa or kPa, for a person to read
};

// Decides by the unit in `stored.unit` ("Pa", "kPa", or empty for none; `unit_evidence` says which header field it came
// from), together with the size of the values. The median of the positive voxels must be a shear modulus that soft
// tissue can have: 0.2 to 100 kPa. Healthy liver is near 2 kPa (dissertation, section 4.3), cirrhosis up to 8 or 12 kPa
// (ours). Livers of 2 to 80 kPa are reported (section 4.1, without saying of which modulus). As the two readings are a
// factor 1000 apart, at most one of them is plausible.
//
// Fails with "stiffness-unit-contradicted" where the unit contradicts the values, and with "stiffness-unit-foreign"
// where it is none of a stiffness. Fails with "stiffness-unit-unknown" where neither reading is plausible, and with
// "stiffness-empty" where no voxel is positive.
[[nodiscard]] Result<StiffnessMap> stiffness_in_kPa(Volume stored, const std::string& unit_evidence = "");

}  // namespace glisson::imaging
