#pragma once
// A device over liver volume x resolution, as figures 6.7 and 6.9 draw it. It is a surface of power, frame rate or
// temperature on a grid of 10 x 10 problems. With it go the contour at which a constraint is just met, and the hot
// spots.

#include <array>
#include <vector>

#include "hardware/plan.h"

namespace glisson::hardware {

struct ProblemGrid {
  std::vector<double> volumes_cm3;      // increasing, at least two
  std::vector<double> resolutions_mm3;  // increasing, at least two
};

// Figure 6.4's 10 x 10 problems: resolutions evenly from 1.65 to 165 mm3, volumes evenly from 900 to 2700 cm3. The
// volumes are assumed, as those of healthy adult livers: the figure's own limits are not in the text.
[[nodiscard]] ProblemGrid dissertation_grid();

// A value for each problem; at(v, r) belongs to volumes_cm3[v] and resolutions_mm3[r].
struct GridSurface {
  ProblemGrid grid;
  std::vector<double> values;  // volumes x resolutions, the resolution running fastest
  [[nodiscard]] double at(std::size_t volume, std::size_t resolution) const {
    return values[volume * grid.resolutions_mm3.size() + resolution];
  }
};

struct DeviceSurfaces {
  GridSurface nodes;
  GridSurface frame_joules;        // above idle
  GridSurface power_W;             // at the wanted frame rate, or the fastest the device computes
  GridSurface temperature_C;       // at the end of the operation, at that power
  GridSurface battery_h;           // at that power
  GridSurface fps_by_energy;       // the frame rate that the battery lasts for (figures 6.9c, 6.9d)
  GridSurface fps_by_temperature;  // the frame rate that stays within the limit (figures 6.9a, 6.9b)
  GridSurface fps;                 // that meets every constraint
};

// The request's volume and accuracy are not used: the grid takes their place. Refused: what plan() and workload.h
// refuse.
Result<DeviceSurfaces> surfaces_over(const ProblemGrid& grid, const Device& device, const PlanRequest& request);

// A piece of the line on which a surface has one value, in (volume cm3, resolution mm3). In each grid cell it is found
// by straight lines along its edges (marching squares). The mean of the corners decides how a saddle is cut.
struct ContourSegment {
  std::array<double, 2> from;
  std::array<double, 2> to;
};
[[nodiscard]] std::vector<ContourSegment> contour(const GridSurface& surface, double level);

// A problem at which the surface is higher than at all problems beside it, by more than `minimum_rise`. Its neighbours,
// smaller and larger, do better. A problem on the grid's edge is compared with those it has, but a corner never counts:
// a surface that only rises ends there.
struct HotSpot {
  std::size_t volume = 0;
  std::size_t resolution = 0;
  double value = 0;
  double rise = 0;  // above its highest neighbour
};
[[nodiscard]] std::vector<HotSpot> hot_spots(const GridSurface& surface, double minimum_rise);

}  // namespace glisson::hardware
