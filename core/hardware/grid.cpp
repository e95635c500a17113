#include "hardware/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::hardware {
namespace {

constexpr int dissertation_steps = 10;

std::vector<double> evenly_spaced(double first, double last, int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = first + (last - first) * i / (count - 1);
  return values;
}

// Where the level cuts the straight line between two corners of a cell.
std::array<double, 2> crossing(std::array<double, 2> a, double value_a, std::array<double, 2> b, double value_b,
                               double level) {
  const double t = (level - value_a) / (value_b - value_a);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

// The corners in a ring, each with its value; consecutive corners share an edge.
struct Cell {
  std::array<std::array<double, 2>, 4> corners;
  std::array<double, 4> values;
};

Cell cell_of(const GridSurface& surface, std::size_t v, std::size_t r) {
  const auto& volumes = surface.grid.volumes_cm3;
  const auto& resolutions = surface.grid.resolutions_mm3;
  return {{{{volumes[v], resolutions[r]},
            {volumes[v + 1], resolutions[r]},
            {volumes[v + 1], resolutions[r + 1]},
            {volumes[v], resolutions[r + 1]}}},
          {surface.at(v, r), surface.at(v + 1, r), surface.at(v + 1, r + 1), surface.at(v, r + 1)}};
}

void add_segments(const Cell& cell, double level, std::vector<ContourSegment>& segments) {
  std::vector<std::array<double, 2>> cuts;  // in the order of the ring
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if ((cell.values[i] >= level) == (cell.values[next] >= level)) continue;
    cuts.push_back(crossing(cell.corners[i], cell.values[i], cell.corners[next], cell.values[next], level));
  }
  if (cuts.size() == 2) segments.push_back({cuts[0], cuts[1]});
  if (cuts.size() != 4) return;
  // A saddle: cuts 0..3 lie on edges 01, 12, 23, 30. The centre joins the corners on its own side of the level.
  const double centre = (cell.values[0] + cell.values[1] + cell.values[2] + cell.values[3]) / 4;
  const bool first_corner_alone = (centre >= level) != (cell.values[0] >= level);
  if (first_corner_alone) {
    segments.push_back({cuts[3], cuts[0]});
    segments.push_back({cuts[1], cuts[2]});
  } else {
    segments.push_back({cuts[0], cuts[1]});
    segments.push_back({cuts[2], cuts[3]});
  }
}

}  // namespace

ProblemGrid dissertation_grid() {
  return {evenly_spaced(900, 2700, dissertation_steps), evenly_spaced(1.65, 165, dissertation_steps)};
}

Result<DeviceSurfaces> surfaces_over(const ProblemGrid& grid, const Device& device, const PlanRequest& request) {
  if (const auto checked = check(request); !checked) return failure(checked.error());
  DeviceSurfaces surfaces;
  GridSurface* const all[] = {&surfaces.nodes,
                              &surfaces.frame_joules,
                              &surfaces.power_W,
                              &surfaces.temperature_C,
                              &surfaces.battery_h,
                              &surfaces.fps_by_energy,
                              &surfaces.fps_by_temperature,
                              &surfaces.fps};
  for (GridSurface* surface : all) surface->grid = grid;
  for (const double volume_cm3 : grid.volumes_cm3) {
    for (const double resolution_mm3 : grid.resolutions_mm3) {
      const auto workload = workload_at_resolution(volume_cm3, resolution_mm3, request.workload);
      if (!workload) return failure(workload.error());
      const DevicePlan answer = answer_for(device, *workload, request);
      surfaces.nodes.values.push_back(workload->nodes);
      surfaces.frame_joules.values.push_back(answer.frame_joules);
      surfaces.power_W.values.push_back(answer.power_W);
      surfaces.temperature_C.values.push_back(answer.temperature_C);
      surfaces.battery_h.values.push_back(answer.battery_h);
      surfaces.fps_by_energy.values.push_back(answer.fps_by_energy);
      surfaces.fps_by_temperature.values.push_back(answer.fps_by_temperature);
      surfaces.fps.values.push_back(answer.fps);
    }
  }
  return surfaces;
}

std::vector<ContourSegment> contour(const GridSurface& surface, double level) {
  std::vector<ContourSegment> segments;
  for (std::size_t v = 0; v + 1 < surface.grid.volumes_cm3.size(); ++v) {
    for (std::size_t r = 0; r + 1 < surface.grid.resolutions_mm3.size(); ++r) {
      add_segments(cell_of(surface, v, r), level, segments);
    }
  }
  return segments;
}

std::vector<HotSpot> hot_spots(const GridSurface& surface, double minimum_rise) {
  const auto volumes = static_cast<long>(surface.grid.volumes_cm3.size());
  const auto resolutions = static_cast<long>(surface.grid.resolutions_mm3.size());
  std::vector<HotSpot> spots;
  for (long v = 0; v < volumes; ++v) {
    for (long r = 0; r < resolutions; ++r) {
      const bool corner = (v == 0 || v == volumes - 1) && (r == 0 || r == resolutions - 1);
      if (corner) continue;
      const double value = surface.at(static_cast<std::size_t>(v), static_cast<std::size_t>(r));
      double highest_beside = -std::numeric_limits<double>::infinity();
      for (long dv = -1; dv <= 1; ++dv) {
        for (long dr = -1; dr <= 1; ++dr) {
          const bool inside = v + dv >= 0 && v + dv < volumes && r + dr >= 0 && r + dr < resolutions;
          if (!inside || (dv == 0 && dr == 0)) continue;
          highest_beside =
              std::max(highest_beside, surface.at(static_cast<std::size_t>(v + dv), static_cast<std::size_t>(r + dr)));
        }
      }
      if (value - highest_beside > minimum_rise) {
        spots.push_back({static_cast<std::size_t>(v), static_cast<std::size_t>(r), value, value - highest_beside});
      }
    }
  }
  return spots;
}

}  // namespace glisson::hardware
