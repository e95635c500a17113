// glisson-cli stereo LEFT RIGHT: rectified stereo to points in left-camera mm.

#include "vision/stereo.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "command.h"
#include "geometry/mesh_file.h"
#include "scene/colour.h"
#include "shared_options.h"
#include "vision/picture_check.h"

namespace glisson::cli {
namespace {

struct StereoCommand {
  std::string left, right, calibration, out, picture;
  vision::StereoOptions options;
};

Result<vision::StereoCloud> see(const StereoCommand& command, const vision::StereoCalibration& calibration,
                                vision::PictureCheck& check);
vision::Frame depth_picture(const vision::StereoCloud& cloud);

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
    if (auto written = vision::write_frame(depth_picture(*cloud), command.picture); !written) {
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
  const auto left = vision::read_frame(command.left);
  if (!left) return failure(left.error());
  const auto right = vision::read_frame(command.right);
  if (!right) return failure(right.error());
  auto matcher = vision::StereoMatcher::prepare(calibration, left->width, left->height, command.options);
  if (!matcher) return failure(matcher.error());
  auto cloud = matcher->cloud(*left, *right);
  if (!cloud) return cloud;
  const auto checked = vision::check_against_pictures(calibration, *left, *right);
  if (!checked) return failure(checked.error());
  check = *checked;
  return cloud;
}

// The left picture beside its depths, near ones bright.
vision::Frame depth_picture(const vision::StereoCloud& cloud) {
  const vision::Frame& seen = cloud.picture;
  vision::Frame both{2 * seen.width, seen.height, std::vector<std::uint8_t>(2 * seen.rgb.size(), 0)};
  for (int y = 0; y < seen.height; ++y) std::copy_n(seen.at(0, y), 3 * seen.width, both.at(0, y));
  std::vector<double> depths_mm;
  for (const Eigen::Vector3d& point : cloud.points_mm) depths_mm.push_back(point.z());
  std::sort(depths_mm.begin(), depths_mm.end());
  const double nearest_mm = depths_mm[depths_mm.size() / 50];  // stray points do not set the scale
  const double farthest_mm = depths_mm[depths_mm.size() - 1 - depths_mm.size() / 50];
  const double range_mm = std::max(1e-9, farthest_mm - nearest_mm);
  for (std::size_t i = 0; i < cloud.points_mm.size(); ++i) {
    const auto [red, green, blue] =
        scene::colour_at(scene::ColourMap::viridis, (farthest_mm - cloud.points_mm[i].z()) / range_mm);
    std::uint8_t* const pixel = both.at(seen.width + cloud.pixels[i][0], cloud.pixels[i][1]);
    pixel[0] = static_cast<std::uint8_t>(std::lround(255 * red));
    pixel[1] = static_cast<std::uint8_t>(std::lround(255 * green));
    pixel[2] = static_cast<std::uint8_t>(std::lround(255 * blue));
  }
  return both;
}

}  // namespace

void add_stereo(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("stereo", "Turn a stereo pair into points in left-camera mm");
  auto settings = std::make_shared<StereoCommand>();
  command->add_option("left", settings->left, "Left picture")->required();
  command->add_option("right", settings->right, "Right picture")->required();
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
  command->callback([&chosen, settings] { chosen = [settings](const Progress&) { return run(*settings); }; });
}

}  // namespace glisson::cli
