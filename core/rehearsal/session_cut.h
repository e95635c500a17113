#pragma once
// What the cut of a session has come to: to be drawn, and in figures.

#include <cstddef>
#include <vector>

#include "geometry/surface.h"

namespace glisson::rehearsal {

struct SessionCut {
  geometry::Surface patient;         // as it lies, mm, LPS, with the cut's walls (mechanics/cutting/opened_surface.h)
  std::size_t advances = 0;          // that led here
  double open_mm2 = 0;               // of the section that the cut runs along
  double bridge_mm2 = 0;             // what of it still holds
  double largest_opening_mm = 0;     // between two points that were one
  std::vector<std::size_t> crossed;  // of the setup's structures

  [[nodiscard]] double open_share() const { return open_mm2 / (open_mm2 + bridge_mm2); }
};

}  // namespace glisson::rehearsal
