// glisson-cli platform grid: one device over liver volume x resolution, with contours and hot spots: what figures 6.7
// and 6.9 of the dissertation draw.

#include <fmt/format.h>
#include <algorithm>

#include "hardware/grid.h"
#include "platform_commands.h"
#include "report/grid_page.h"
#include "report/html.h"

namespace glisson::cli {

using namespace hardware;

namespace {

struct PlatformGridCommand {
  DeviceTables tables;
  PlanRequest request;
  std::string device, out;
  std::vector<double> frame_rates{10, 15, 20, 25};
};

constexpr double smallest_rise_C = 0.001;  // of a hot spot: what a sum of rounding errors cannot make

Json rows_of(const GridSurface& surface) {
  Json rows = Json::array();
  for (std::size_t v = 0; v < surface.grid.volumes_cm3.size(); ++v) {
    Json row = Json::array();
    for (std::size_t r = 0; r < surface.grid.resolutions_mm3.size(); ++r) row.push_back(surface.at(v, r));
    rows.push_back(row);
  }
  return rows;
}

Json segments_of(const GridSurface& surface, double level) {
  Json segments = Json::array();
  for (const ContourSegment& segment : contour(surface, level)) segments.push_back({segment.from, segment.to});
  return segments;
}

std::string table_of(const GridSurface& surface, const std::string& title) {
  std::string text = title + "\n  cm3 \\ mm3";
  for (const double resolution_mm3 : surface.grid.resolutions_mm3) text += fmt::format("{:9.4g}", resolution_mm3);
  text += "\n";
  for (std::size_t v = 0; v < surface.grid.volumes_cm3.size(); ++v) {
    text += fmt::format("  {:9.4g}", surface.grid.volumes_cm3[v]);
    for (std::size_t r = 0; r < surface.grid.resolutions_mm3.size(); ++r)
      text += fmt::format("{:9.3g}", surface.at(v, r));
    text += "\n";
  }
  return text;
}

Result<Outcome> run(const PlatformGridCommand& options) {
  const auto devices = options.tables.devices();
  if (!devices) return failure(devices.error());
  const auto device = device_with_id(*devices, options.device);
  if (!device) return failure(device.error());
  const ProblemGrid grid = dissertation_grid();
  Outcome outcome{{{"device", device->id},
                   {"volumes_cm3", grid.volumes_cm3},
                   {"resolutions_mm3", grid.resolutions_mm3},
                   {"at", Json::array()}},
                  {}};
  std::vector<report::GridAtRate> at;
  for (const double frames_per_s : options.frame_rates) {
    PlanRequest request = options.request;
    request.frames_per_s = frames_per_s;
    const auto surfaces = surfaces_over(grid, *device, request);
    if (!surfaces) return failure(surfaces.error());
    Json spots = Json::array();
    double rise_C = 0;
    for (const HotSpot& spot : hot_spots(surfaces->temperature_C, smallest_rise_C)) {
      rise_C = std::max(rise_C, spot.rise);
      spots.push_back({{"volume_cm3", grid.volumes_cm3[spot.volume]},
                       {"resolution_mm3", grid.resolutions_mm3[spot.resolution]},
                       {"temperature_C", spot.value},
                       {"above_neighbours_C", spot.rise}});
    }
    outcome.document["at"].push_back({{"fps", frames_per_s},
                                      {"power_W", rows_of(surfaces->power_W)},
                                      {"temperature_C", rows_of(surfaces->temperature_C)},
                                      {"battery_h", rows_of(surfaces->battery_h)},
                                      {"frame_J", rows_of(surfaces->frame_joules)},
                                      {"fps_by_energy", rows_of(surfaces->fps_by_energy)},
                                      {"fps_by_temperature", rows_of(surfaces->fps_by_temperature)},
                                      {"sustainable_fps", rows_of(surfaces->fps)},
                                      {"contour_energy", segments_of(surfaces->fps_by_energy, frames_per_s)},
                                      {"contour_temperature", segments_of(surfaces->temperature_C, request.limit_C)},
                                      {"contour_all", segments_of(surfaces->fps, frames_per_s)},
                                      {"hot_spots", spots},
                                      {"hottest_spot_C", rise_C}});
    outcome.text += table_of(surfaces->temperature_C, fmt::format("Surface (C) at {:g} frames a second", frames_per_s));
    outcome.text +=
        spots.empty() ? "No hot spots.\n"
                      : fmt::format("{} hot spots, the largest {:.3g} C above all beside it.\n", spots.size(), rise_C);
    at.push_back({frames_per_s, *surfaces});
    if (frames_per_s == options.frame_rates.back())
      outcome.text += table_of(surfaces->fps, "Frames a second that meet every constraint");
  }
  if (options.out.empty()) return outcome;
  if (auto written = report::write_html(options.out, report::grid_page(*device, at, *devices, options.request));
      !written) {
    return failure(written.error());
  }
  outcome.document["out"] = options.out;
  return outcome;
}

}  // namespace

void add_platform_grid(CLI::App& platform, Action& chosen) {
  CLI::App* command =
      platform.add_subcommand("grid", "One device over liver volume and resolution: surfaces, contours, hot spots");
  auto options = std::make_shared<PlatformGridCommand>();
  command->add_option("--device", options->device, "Its id")->required();
  command->add_option("--fps", options->frame_rates, "Frame rates")->delimiter(',')->capture_default_str();
  command->add_option("--out", options->out, "Page with the figures 6.7 to 6.9 (HTML)");
  add_request_options(*command, options->request);
  command->add_option("--devices", options->tables.files, "Further device tables (JSON)");
  command->callback([&chosen, options] { chosen = [options](const Progress&) { return run(*options); }; });
}

}  // namespace glisson::cli
