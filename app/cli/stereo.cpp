// glisson-cli stereo LEFT RIGHT: rectified stereo to points in left-camera mm.

#include "vision/stereo.h"

#include <fmt/format.h>

#include "command.h"
#include "geometry/mesh_file.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct StereoCommand {
  std::string left, right, calibration, out;
  vision::StereoOptions options;
};

Result<Outcome> run(const StereoCommand& command) {
  const auto calibration = vision::read_stereo_calibration(command.calibration);
  if (!calibration) return failure(calibration.error());
  auto cloud = vision::stereo_cloud(command.left, command.right, *calibration, command.options);
  if (!cloud) return failure(cloud.error());
  const auto points = cloud->points_mm.size();
  geometry::Surface surface;
  surface.points_mm = std::move(cloud->points_mm);
  surface.triangles = std::move(cloud->triangles);
  if (surface.triangles.empty()) {
    return failure(
        Error{"stereo-nothing-seen",
              GLISSON_TEXT("The two pictures agree nowhere."),
              {},
              GLISSON_TEXT("Check that left and right are not exchanged and that the calibration is theirs."),
              {}});
  }
  geometry::set_field(surface.point_fields, {"confidence", 1, std::move(cloud->confidence)});
  if (auto written = geometry::write_surface(command.out, surface); !written) return failure(written.error());
  return Outcome{{{"points", points},
                  {"triangles", surface.triangles.size()},
                  {"valid_fraction", cloud->valid_fraction},
                  {"baseline_mm", calibration->baseline_mm()},
                  {"notes", calibration->notes},
                  {"file", command.out}},
                 fmt::format("{} points, {:.0f} % of what could be seen\n{}", points, 100 * cloud->valid_fraction,
                             bullet_list(calibration->notes))};
}

}  // namespace

void add_stereo(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("stereo", "Turn a stereo pair into points in left-camera mm");
  auto settings = std::make_shared<StereoCommand>();
  command->add_option("left", settings->left, "Left picture")->required();
  command->add_option("right", settings->right, "Right picture")->required();
  command->add_option("--calibration", settings->calibration, "Stereo calibration (JSON, or OpenCV's YAML)")
      ->required();
  command->add_option("--nearest-mm", settings->options.nearest_mm, "Nearest depth looked for")->capture_default_str();
  command->add_option("--farthest-mm", settings->options.farthest_mm, "Farthest depth kept")->capture_default_str();
  command->add_option("--step", settings->options.step_px, "A point every so many pixels")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--out", settings->out, "Cloud with triangles between neighbours (.ply, .obj, .stl, .vtp)")
      ->required();
  command->callback([&chosen, settings] { chosen = [settings](const Progress&) { return run(*settings); }; });
}

}  // namespace glisson::cli
