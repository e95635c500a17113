#pragma once
// What of a case's structures a rehearsal follows: points of tumours, cysts and vessels.

#include <string>
#include <vector>

#include "mechanics/scenario/scenario.h"
#include "segmentation/structures.h"

namespace glisson::casefile {

// Points to follow: the centre of each tumour and cyst, and points spread along each vessel inside the liver (the
// farthest from one another first). Positions are rest positions, patient LPS, mm.
std::vector<mechanics::Landmark> landmarks_of(const std::vector<segmentation::Structure>& structures,
                                              int points_per_vessel = 6);

// Whether a structure or landmark of that name is (on) a vessel: "portal-vein", "hepatic-vein-3", "artery".
[[nodiscard]] bool is_vessel(const std::string& name);

}  // namespace glisson::casefile
