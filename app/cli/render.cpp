// glisson-cli render (CASE | RESULT) --scene NAME --size WxH --out FILE.png: draws one scene with no window.

#include <fmt/format.h>

#include "command.h"
#include "scene/case_scenes.h"
#include "scene/landmark_overlay.h"
#include "shared_options.h"

namespace glisson::cli {
namespace fs = std::filesystem;
namespace {

struct RenderCommand {
  std::string folder;
  std::string scene;
  std::string size = "1600x1000";
  std::string out;
  std::optional<std::string> reference;
  std::string group;
};

// That group's, or without a name the first.
Result<scene::Scene> landmark_scene(const RenderCommand& options) {
  const auto overlays = scene::landmark_overlays(options.folder, options.reference);
  if (!overlays) return failure(overlays.error());
  std::string known;
  for (const scene::LandmarkOverlay& overlay : *overlays) {
    if (options.group.empty() || overlay.group == options.group) return overlay.scene;
    known += (known.empty() ? "" : ", ") + overlay.group;
  }
  return failure("landmarks-unknown", GLISSON_TEXT("The result has no landmarks \"{0}\"; it has: {1}."),
                 {options.group, known});
}

Result<scene::Scene> scene_of(const RenderCommand& options) {
  std::error_code problem;
  if (fs::exists(fs::path(options.folder) / "result.vtu", problem)) {
    if (options.scene == "displacement") return scene::result_scene(options.folder);
    if (options.scene == "landmarks") return landmark_scene(options);
    return failure("scene-unknown", GLISSON_TEXT("A result has no scene named {0}; it has displacement, landmarks."),
                   {options.scene});
  }
  return casefile::Case::open(options.folder).and_then([&](const casefile::Case& patient) {
    return scene::case_scene(patient, options.scene);
  });
}

Result<Outcome> render(const RenderCommand& options, const Progress& progress) {
  const auto size = parse_size(options.size);
  if (!size) return failure(size.error());
  progress.report(0.0, GLISSON_TEXT("Reading"));
  const auto scene = scene_of(options);
  if (!scene) return failure(scene.error());
  progress.report(0.5, GLISSON_TEXT("Drawing"));
  const auto picture = scene::draw(*scene, size->width, size->height);
  if (!picture) return failure(picture.error());
  if (auto written = scene::write_png(*picture, options.out); !written) return failure(written.error());
  return Outcome{{{"scene", options.scene}, {"file", options.out}}, options.out + "\n"};
}

}  // namespace

void add_render(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("render", "Draw one scene of a case or a result, with no window");
  auto options = std::make_shared<RenderCommand>();
  command->add_option("folder", options->folder, "A case, or a result's folder")->required();
  command
      ->add_option("--scene", options->scene,
                   "Case: anatomy, liver, stiffness, model, waves, confidence; result: displacement, landmarks "
                   "(predicted, over the grey scan of its case)")
      ->required();
  command->add_option("--atlas", options->reference, "Of landmarks: the result with the atlas's stiffness, beside it");
  command->add_option("--group", options->group, "Of landmarks: which, as tumour or hepatic-vein; the first else");
  command->add_option("--size", options->size, "WxH in pixels")->capture_default_str();
  command->add_option("--out", options->out, "The picture to write (.png)")->required();
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return render(*options, progress); }; });
}

}  // namespace glisson::cli
