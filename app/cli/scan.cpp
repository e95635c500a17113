// glisson-cli scan PATH: the image series under a folder, a DICOMDIR or in one file.

#include <fmt/format.h>

#include "command.h"
#include "imaging/study.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

Outcome describe_scan(const imaging::Study& study) {
  Outcome outcome{{{"series", Json::array()}, {"skipped", Json::array()}}, {}};
  for (const imaging::Series& series : study.series) {
    outcome.document["series"].push_back({{"uid", series.uid},
                                          {"description", series.description},
                                          {"modality", series.modality},
                                          {"role", imaging::role_name(series.role)},
                                          {"role_evidence", series.role_evidence},
                                          {"files", series.files.size()},
                                          {"volumes", series.volumes},
                                          {"size", series.grid.size},
                                          {"spacing_mm", json_of(series.grid.spacing_mm)},
                                          {"unit", series.unit},
                                          {"problems", series.problems}});
    outcome.text += fmt::format(
        "{:14}  {:3}  {} x {} x {}{}  {:.3g} x {:.3g} x {:.3g} mm  {}\n                {}\n",
        imaging::role_name(series.role), series.modality, series.grid.size[0], series.grid.size[1], series.grid.size[2],
        series.volumes > 1 ? fmt::format(" x {} volumes", series.volumes) : "", series.grid.spacing_mm.x(),
        series.grid.spacing_mm.y(), series.grid.spacing_mm.z(), series.description, series.uid);
    outcome.text += bullet_list(series.problems);
  }
  constexpr std::size_t shown = 10;
  for (const imaging::SkippedFile& file : study.skipped) {
    outcome.document["skipped"].push_back({{"file", file.path.string()}, {"reason", file.reason}});
    if (outcome.document["skipped"].size() <= shown) outcome.text += fmt::format("skipped         {}\n", file.reason);
  }
  if (study.skipped.size() > shown) {
    outcome.text += fmt::format("                and {} more (--json lists all)\n", study.skipped.size() - shown);
  }
  outcome.text += fmt::format("{} series, {} files skipped\n", study.series.size(), study.skipped.size());
  return outcome;
}

}  // namespace

void add_scan(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("scan", "List the image series under a folder, a DICOMDIR or in one file");
  auto path = std::make_shared<std::string>();
  command->add_option("path", *path, "Folder, DICOMDIR or file")->required();
  command->callback([&chosen, path] {
    chosen = [path](const Progress& progress) { return imaging::scan(*path, progress).map(describe_scan); };
  });
}

}  // namespace glisson::cli
