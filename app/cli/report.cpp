// glisson-cli report CASE --out FILE.html: one page of what was done for a patient.

#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "command.h"
#include "report/html.h"
#include "report/patient_page.h"
#include "scene/case_scenes.h"
#include "scene/landmark_overlay.h"
#include "scene/picture.h"

namespace glisson::cli {
namespace {

struct ReportCommand {
  std::string case_folder;
  std::string out;
  std::string name;
};

bool there_is(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

// The planned cut, or without one the liver, and a slice with the outlines. What the case lacks is not drawn.
Result<std::vector<report::Figure>> pictures(const casefile::Case& patient, const std::filesystem::path& folder) {
  constexpr int width = 1200, height = 800;
  const bool cut = there_is(patient.folder() / "results" / "resection" / "cut.vtp");
  std::vector<std::pair<std::string, std::string>> wanted{{"anatomy", "A slice with the outlines."}};
  wanted.insert(wanted.begin(), cut ? std::pair{std::string(scene::resection_scene_name), "The planned cut."}
                                    : std::pair{std::string("liver"), "The liver with what lies inside it."});
  std::vector<report::Figure> figures;
  for (const auto& [name, caption] : wanted) {
    const auto scene = scene::case_scene(patient, name);
    if (!scene) continue;
    const std::filesystem::path file = folder / (name + ".png");
    auto drawn = scene::draw(*scene, width, height).and_then([&](const scene::Picture& picture) {
      return scene::write_png(picture, file);
    });
    if (!drawn) return failure(std::move(drawn.error()));
    figures.push_back({file, caption});
  }
  return figures;
}

// A picture for each group of landmarks: the retraction on the measured stiffness, with the atlas's beside it.
Result<void> add_landmarks(const casefile::Case& patient, const std::filesystem::path& folder,
                           std::vector<report::Figure>& figures) {
  constexpr int width = 1200, height = 800;
  const std::filesystem::path results = patient.folder() / "results";
  if (!there_is(results / "mre" / "result.vtu")) return {};
  std::optional<std::filesystem::path> reference;
  if (there_is(results / "atlas" / "result.vtu")) reference = results / "atlas";
  const auto overlays = scene::landmark_overlays(results / "mre", reference);
  if (!overlays) return failure(overlays.error());
  for (const scene::LandmarkOverlay& overlay : *overlays) {
    const std::filesystem::path file = folder / ("landmarks-" + overlay.group + ".png");
    auto drawn = scene::draw(overlay.scene, width, height).and_then([&](const scene::Picture& picture) {
      return scene::write_png(picture, file);
    });
    if (!drawn) return failure(std::move(drawn.error()));
    figures.push_back({file, "Where the retraction brings " + overlay.group + ", over the scan."});
  }
  return {};
}

Result<Outcome> run(const ReportCommand& command, const Progress& progress) {
  const auto patient = casefile::Case::open(command.case_folder);
  if (!patient) return failure(patient.error());
  report::PatientPageContent content;
  if (!command.name.empty()) content.name = command.name;
  const auto scratch = TemporaryFolder::make();
  if (!scratch) return failure(scratch.error());
  auto figures = pictures(*patient, scratch->path());
  if (!figures) return failure(std::move(figures.error()));
  if (auto added = add_landmarks(*patient, scratch->path(), *figures); !added) return failure(std::move(added.error()));
  content.figures = *std::move(figures);
  const auto page = report::patient_page(*patient, content, progress);
  if (!page) return failure(page.error());
  if (auto written = report::write_html(command.out, *page); !written) return failure(std::move(written.error()));
  return Outcome{{{"file", command.out}, {"name_shown", content.name.has_value()}}, command.out + "\n"};
}

}  // namespace

void add_report(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("report", "Write one page of what was done for a patient");
  auto settings = std::make_shared<ReportCommand>();
  command->add_option("case", settings->case_folder, "The case")->required();
  command->add_option("--out", settings->out, "HTML file to write")->required();
  command->add_option("--name", settings->name, "The patient's name, which the page otherwise withholds");
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
