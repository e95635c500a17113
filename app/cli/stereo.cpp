// glisson-cli stereo LEFT RIGHT: rectified stereo to points in left-camera mm.

#include "vision/stereo.h"

#include <fmt/format.h>

#include "command.h"
#include "eyes.h"
#include "geometry/mesh_file.h"
#include "scene/depth_picture.h"
#include "shared_options.h"
#include "vision/picture_check.h"

namespace glisson::cli {
namespace {

struct StereoCommand {
  std::string left, right, calibration, out, picture;
  vision::Shared shared = vision::Shared::left_then_right;
  vision::StereoOptions options;
};

Result<vision::StereoCloud> see(const StereoCommand& command, const vision::StereoCalibration& calibration,
                                vision::PictureCheck& check);

Result<Outcome> run(const StereoCommand& command) {
  const auto calibration = vision::read_stereo_calibration(command.calibration);
  if (!calibration) return failure(calibration.error());
  vision::PictureCheck check;
  auto cloud = see(command, *calibration, check);
  if (!cloud) return failure(cloud.error());
  if (cloud->triangles.empty()) {
    return failure(
        Error{"stereo-nothing-seen",
              GLISSON_TEXT("The two pictures agree nowhere."),
              {},
              GLISSON_TEXT("Check that left and right are not exchanged and that the calibration is theirs."),
              {}});
  }
  if (!command.picture.empty()) {
    if (auto written = vision::write_frame(scene::depth_picture(*cloud, command.options.step_px), command.picture);
        !written) {
      return failure(written.error());
    }
  }
  const auto points = cloud->points_mm.size();
  geometry::Surface surface;
  surface.points_mm = std::move(cloud->points_mm);
  surface.triangles = std::move(cloud->triangles);
  geometry::set_field(surface.point_fields, {"confidence", 1, std::move(cloud->confidence)});
  geometry::Field colour{"colour", 3, {}};
  for (const auto& rgb : cloud->colour) colour.values.insert(colour.values.end(), rgb.begin(), rgb.end());
  geometry::set_field(surface.point_fields, std::move(colour));
  if (auto written = geometry::write_surface(command.out, surface); !written) return failure(written.error());
  Outcome outcome{{{"points", points},
                   {"triangles", surface.triangles.size()},
                   {"valid_fraction", cloud->valid_fraction},
                   {"masked",
                    {{"border", cloud->masked.border},
                     {"highlights", cloud->masked.highlights},
                     {"tools", cloud->masked.tools},
                     {"smoke", cloud->masked.smoke}}},
                   {"baseline_mm", calibration->baseline_mm()},
                   {"features", check.matches},
                   {"epipolar_px", check.epipolar_px},
                   {"in_front", check.in_front},
                   {"notes", calibration->notes},
                   {"file", command.out}},
                  fmt::format("{} points, {:.0f} % of what could be seen\n{}", points, 100 * cloud->valid_fraction,
                              bullet_list(calibration->notes))};
  if (!command.picture.empty()) outcome.document["picture"] = command.picture;
  return outcome;
}

// The pictures themselves say whether the calibration is theirs, and which way it goes.
Result<vision::StereoCloud> see(const StereoCommand& command, const vision::StereoCalibration& calibration,
                                vision::PictureCheck& check) {
  const auto pair = vision::read_pair({command.left, command.right, command.shared});
  if (!pair) return failure(pair.error());
  const auto& [left, right] = *pair;
  auto matcher = vision::StereoMatcher::prepare(calibration, left.width, left.height, command.options);
  if (!matcher) return failure(matcher.error());
  auto cloud = matcher->cloud(left, right);
  if (!cloud) return cloud;
  const auto checked = vision::check_against_pictures(calibration, left, right);
  if (!checked) return failure(checked.error());
  check = *checked;
  return cloud;
}

}  // namespace

void add_stereo(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("stereo", "Turn a stereo pair into points in left-camera mm");
  auto settings = std::make_shared<StereoCommand>();
  command->add_option("left", settings->left, "Left picture")->required();
  CLI::Option* right = command->add_option("right", settings->right, "Right picture; none with --eyes");
  CLI::Option* eyes = add_eyes(*command, right, settings->shared);
  command
      ->add_option("--calibration", settings->calibration,
                   "Stereo calibration: JSON, OpenCV's YAML, or a folder of text files")
      ->required();
  command->add_option("--nearest-mm", settings->options.nearest_mm, "Nearest depth looked for")->capture_default_str();
  command->add_option("--farthest-mm", settings->options.farthest_mm, "Farthest depth kept")->capture_default_str();
  command->add_option("--step", settings->options.step_px, "A point every so many pixels")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--out", settings->out, "Cloud with triangles between neighbours (.ply, .obj, .stl, .vtp)")
      ->required();
  command->add_option("--picture", settings->picture, "The left picture beside its depths (.png)");
  command->callback([&chosen, settings, right, eyes] {
    check_eyes(*right, *eyes);
    chosen = [settings](const Progress&) { return run(*settings); };
  });
}

}  // namespace glisson::cli
