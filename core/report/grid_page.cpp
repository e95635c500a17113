#include "report/grid_page.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"

namespace glisson::report {
namespace {

using hardware::GridSurface;

// A line a resolution, every third of them.
Plot lines_over_volume(const GridSurface& surface, const std::string& caption, const std::string& unit) {
  Plot plot{caption, "liver (cm3)", unit};
  for (std::size_t r = 0; r < surface.grid.resolutions_mm3.size(); r += 3) {
    PlotCurve line{fmt::format("{:.4g} mm3 a node", surface.grid.resolutions_mm3[r]), {}, PlotCurve::Style::line};
    for (std::size_t v = 0; v < surface.grid.volumes_cm3.size(); ++v) {
      line.points.emplace_back(surface.grid.volumes_cm3[v], surface.at(v, r));
    }
    plot.curves.push_back(std::move(line));
  }
  return plot;
}

// A dot at each problem, so that an empty plot has its axes.
PlotCurve problems(const hardware::ProblemGrid& grid) {
  PlotCurve dots{"the problems", {}, PlotCurve::Style::dots, "#cccccc"};
  for (const double volume_cm3 : grid.volumes_cm3) {
    for (const double resolution_mm3 : grid.resolutions_mm3) dots.points.emplace_back(volume_cm3, resolution_mm3);
  }
  return dots;
}

Plot energy_over_nodes(const std::vector<hardware::Device>& devices, const hardware::ProblemGrid& grid,
                       const hardware::PlanRequest& request) {
  Plot plot{"Figure 6.8: energy of one iteration, above idle, over the nodes.", "nodes, as a power of ten",
            "energy (J), as a power of ten"};
  plot.from_zero = false;
  for (const hardware::Device& device : devices) {
    PlotCurve line{device.name, {}, PlotCurve::Style::line};
    for (const double volume_cm3 : grid.volumes_cm3) {
      for (const double resolution_mm3 : grid.resolutions_mm3) {
        const auto work = hardware::workload_at_resolution(volume_cm3, resolution_mm3, request.workload);
        if (!work) continue;
        line.points.emplace_back(std::log10(work->nodes), std::log10(hardware::product_cost(device, *work).joules));
      }
    }
    std::sort(line.points.begin(), line.points.end());
    plot.curves.push_back(std::move(line));
  }
  return plot;
}

Table hot_spot_table(const std::vector<GridAtRate>& at) {
  Table table{"Hot spots: problems that are hotter than all beside them. Pauses between frames even them out.",
              {"frames a second", "liver (cm3)", "mm3 a node", "surface (C)", "above its neighbours (C)"},
              {}};
  for (const GridAtRate& rate : at) {
    const GridSurface& surface = rate.surfaces.temperature_C;
    for (const hardware::HotSpot& spot : hardware::hot_spots(surface, 0.001)) {
      table.rows.push_back({{fmt::format("{:g}", rate.frames_per_s)},
                            {fmt::format("{:.0f}", surface.grid.volumes_cm3[spot.volume])},
                            {fmt::format("{:.4g}", surface.grid.resolutions_mm3[spot.resolution])},
                            {fmt::format("{:.2f}", spot.value)},
                            {fmt::format("{:.3f}", spot.rise)}});
    }
  }
  return table;
}

}  // namespace

Page grid_page(const hardware::Device& device, const std::vector<GridAtRate>& at,
               const std::vector<hardware::Device>& devices, const hardware::PlanRequest& request) {
  GLISSON_ASSERT(!at.empty());
  const hardware::ProblemGrid& grid = at.front().surfaces.nodes.grid;
  Page page;
  page.title = device.name;
  page.subtitle = "Over liver volume and resolution: figures 6.7 to 6.9 of the dissertation";
  const GridAtRate& last = at.back();
  Plot power =
      lines_over_volume(last.surfaces.power_W,
                        fmt::format("Figure 6.7: mean power at {:g} frames a second.", last.frames_per_s), "power (W)");
  const double allowed_W = hardware::largest_load_W(battery_of(device), request.duration_h, request.ambient_C);
  power.rules.push_back({Rule::Along::y, allowed_W * device.supply_efficiency.value,
                         fmt::format("what its battery allows over {:g} h", request.duration_h)});
  Plot energy =
      lines_over_volume(last.surfaces.frame_joules, "Figure 6.7: energy of a frame, above idle.", "energy (J)");
  Plot lasts{fmt::format("Figure 6.9: above a line its battery lasts {:g} h at that rate.", request.duration_h),
             "liver (cm3)", "mm3 a node"};
  Plot cool{fmt::format("Figure 6.9: where it reaches {:g} C.", request.limit_C), "liver (cm3)", "mm3 a node"};
  static const char* const colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#555555"};
  lasts.curves.push_back(problems(grid));
  cool.curves.push_back(problems(grid));
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string label = fmt::format("{:g} frames a second", at[i].frames_per_s);
    const auto add = [&](Plot& plot, const GridSurface& surface, double level) {
      bool named = false;
      for (const hardware::ContourSegment& segment : hardware::contour(surface, level)) {
        plot.curves.push_back({named ? "" : label,
                               {{segment.from[0], segment.from[1]}, {segment.to[0], segment.to[1]}},
                               PlotCurve::Style::line,
                               colours[i % std::size(colours)]});
        named = true;
      }
    };
    add(lasts, at[i].surfaces.fps_by_energy, at[i].frames_per_s);
    add(cool, at[i].surfaces.temperature_C, request.limit_C);
  }
  page.blocks = {std::move(power), std::move(energy), energy_over_nodes(devices, grid, request), std::move(lasts),
                 std::move(cool)};
  Table spots = hot_spot_table(at);
  if (spots.rows.empty()) {
    page.blocks.push_back(Paragraph{"No hot spots at these rates."});
  } else {
    page.blocks.push_back(std::move(spots));
  }
  page.blocks.push_back(
      Paragraph{"A page is no better than the device's figures; where each comes from: glisson-cli platform list "
                "--device ID."});
  page.footer = fmt::format("Glisson {}. Not a medical device.", version());
  return page;
}

}  // namespace glisson::report
