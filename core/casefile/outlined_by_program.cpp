#include "casefile/outlined_by_program.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "base/run_program.h"
#include "base/write_file.h"
#include "casefile/label_map.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using imaging::Role;
using imaging::Series;
using imaging::Study;

// Where both sides find what the other one left.
struct Places {
  fs::path image, folder;
};
Result<std::vector<std::string>> words_for(const std::string& command, const Places& places);
Result<std::vector<WantedLabels>> labels_in(const Study& study, const OutliningProgram& program);

}  // namespace

Result<std::vector<ImportedStructure>> outline_by_program(Case& patient, const OutliningProgram& program,
                                                          const Progress& progress) {
  const auto folder = TemporaryFolder::make();
  if (!folder) return failure(folder.error());
  const Places places{folder->path() / "images" / "anatomy_0000.nii.gz", folder->path() / "labels"};
  const auto words = words_for(program.command, places);
  if (!words) return failure(words.error());
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());

  progress.report(0, GLISSON_TEXT("Handing over the images"));
  std::error_code problem;
  fs::create_directories(places.folder, problem);
  if (problem) return file_not_writable(places.folder, problem.message());
  if (auto written = imaging::write_volume_file(places.image, *anatomy); !written) return failure(written.error());
  if (auto run = run_program(*words, progress.part(0.05, 0.9)); !run) return failure(run.error());

  const auto study = imaging::scan(places.folder, progress.part(0.9, 0.92));
  if (!study) return failure(study.error());
  const auto wanted = labels_in(*study, program);
  if (!wanted) return failure(wanted.error());
  std::vector<ImportedStructure> outlined;
  auto taken = patient.together([&]() -> Result<void> {
    auto imported = import_labels(patient, *wanted, anatomy->grid, progress.part(0.92, 1));
    if (!imported) return failure(imported.error());
    outlined = std::move(*imported);
    return {};
  });
  if (!taken) return failure(taken.error());
  return outlined;
}

namespace {

Result<std::vector<std::string>> words_for(const std::string& command, const Places& places) {
  const auto missing = [&](const char* code, const char* text, const char* hint) {
    return failure(Error{code, text, {command}, hint, {}});
  };
  auto words = words_of_command(command);
  if (!words) return words;
  bool has_image = false, has_labels = false;
  const std::pair<std::string, fs::path> meanings[] = {{"{image}", places.image},
                                                       {"{image_folder}", places.image.parent_path()},
                                                       {"{folder}", places.folder},
                                                       {"{labels}", places.folder / "labels.nii.gz"}};
  for (std::string& word : *words) {
    for (const auto& [placeholder, path] : meanings) {
      for (std::size_t at = word.find(placeholder); at != std::string::npos; at = word.find(placeholder)) {
        word.replace(at, placeholder.size(), path.string());
        (placeholder.starts_with("{image") ? has_image : has_labels) = true;
      }
    }
  }
  const char* example = GLISSON_TEXT("As in: TotalSegmentator -i {image} -o {folder}");
  if (!has_image) {
    return missing("command-no-image", GLISSON_TEXT("The command {0} is given no image."), example);
  }
  if (!has_labels) {
    return missing("command-no-labels", GLISSON_TEXT("The command {0} is not told where to put what it outlines."),
                   example);
  }
  return words;
}

// What says that it is labels; where nothing does, every volume.
Result<std::vector<WantedLabels>> labels_in(const Study& study, const OutliningProgram& program) {
  const bool any_says_so = std::any_of(study.series.begin(), study.series.end(),
                                       [](const Series& series) { return series.role == Role::segmentation; });
  std::vector<WantedLabels> wanted;
  for (const Series& series : study.series) {
    if (any_says_so ? series.role != Role::segmentation : !is_label_map(series)) continue;
    WantedLabels labels{&series, {}, program.command};
    if (is_label_map(series) && !program.names.empty()) {
      const auto map = read_label_map(series.files.front());
      if (!map && map.error().code != "labels-empty") return failure(map.error());
      for (const auto& named : program.names) {
        const auto held = [&](const LabelledPart& part) { return part.value == named.first; };
        if (map && std::any_of(map->parts.begin(), map->parts.end(), held)) labels.names.insert(named);
      }
    }
    wanted.push_back(std::move(labels));
  }
  if (!wanted.empty()) return wanted;
  return failure(Error{"program-no-labels",
                       GLISSON_TEXT("The command {0} ended, and left no label map."),
                       {program.command},
                       GLISSON_TEXT("Run it by hand, and see which files it writes, and where."),
                       {}});
}

}  // namespace
}  // namespace glisson::casefile
