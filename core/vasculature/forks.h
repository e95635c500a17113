#pragma once
// Where vessels divide: places inside a liver that can be found again on another image of it, and so landmarks.
//
// Frame: patient coordinates, LPS, mm.

#include <vector>

#include "vasculature/systems.h"

namespace glisson::vasculature {

struct Fork {
  Eigen::Vector3d position_mm{0, 0, 0};  // where the vessel that divides ends
  System system = System::portal_vein;
  double calibre_mm = 0;  // of that vessel: twice the median radius along it
  int branches = 0;       // that leave there, two or more
};

// Ends of vessels of at least that calibre where two or more branches of their tree begin. What stands on a bridged gap
// or on a contact is no fork. In the order of the trees' branches.
// 3 mm: what docs/territories.md judges trees from.
[[nodiscard]] std::vector<Fork> forks_of(const VesselTrees& trees, double minimum_calibre_mm = 3);

}  // namespace glisson::vasculature
