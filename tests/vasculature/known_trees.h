#pragma once
// Vessels of generated patients as a mask of one class, damaged as real masks are, and how far a result is from what is
// known of them.

#include <cstdint>

#include "anatomy/patient.h"
#include "imaging/image.h"
#include "vasculature/systems.h"

namespace glisson::test {

struct Damage {
  double noise_mm = 0.3;  // standard deviation of the wall, voxel by voxel
  int gaps = 6;           // cut through branches of 1 to 2.5 mm radius, three voxels long
  int touches = 6;  // portal and hepatic branches grown together where they come close, beside those that do anyway
};

struct KnownVessels {
  anatomy::Patient patient;
  imaging::Mask liver, vessels;
};
KnownVessels make_known_vessels(std::uint64_t seed, const Damage& damage = {}, double spacing_mm = 0.8);

struct TreeScore {
  int branches = 0, found = 0;       // of a calibre of 3 mm and more; found: on 70 % of their length
  int joins = 0, wrong_joins = 0;    // of result's branches to their parents
  double radius_error_mm = 0;        // median of the absolute difference along those branches
  double radius_within_half_mm = 0;  // share of their length
  double system_right = 0;           // share of the result's length
  double marked_doubtful = 0;        // share of what is wrong whose confidence is below 0.8
};
TreeScore score_of(const vasculature::VesselTrees& trees, const anatomy::Patient& patient);

}  // namespace glisson::test
