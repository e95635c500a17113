// Walks to every file, reads headers on all threads, and puts the pictures of each series together.

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/parallel.h"
#include "base/text.h"
#include "imaging/internal/assemble_series.h"
#include "imaging/internal/dicom_fields.h"
#include "imaging/internal/dicom_image.h"
#include "imaging/internal/roles.h"
#include "imaging/internal/voxel_layout.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// What became of one file: one of the three.
struct Inspected {
  std::optional<DicomImage> image;
  std::optional<Series> volume_file;
  std::string reason_to_skip;
};

Result<std::vector<fs::path>> files_under(const fs::path& path, const Progress& progress);
Inspected inspect(const fs::path& file);
Result<std::vector<Inspected>> inspect_all(const std::vector<fs::path>& files, const Progress& progress);
void compare_frames_of_reference(std::vector<Series>& series);

bool is_dicomdir(const fs::path& file) { return upper_case(file.filename().string()) == "DICOMDIR"; }

}  // namespace

std::string_view role_name(Role role) {
  switch (role) {
    case Role::anatomy: return "anatomy";
    case Role::mre_magnitude: return "mre_magnitude";
    case Role::mre_phase: return "mre_phase";
    case Role::mre_wave: return "mre_wave";
    case Role::mre_stiffness: return "mre_stiffness";
    case Role::mre_confidence: return "mre_confidence";
    case Role::segmentation: return "segmentation";
    case Role::other: break;
  }
  return "other";
}

Result<Study> scan(const fs::path& path, const Progress& progress) {
  const Result<std::vector<fs::path>> files = files_under(path, progress.part(0, 0.05));
  if (!files) return failure(files.error());
  Result<std::vector<Inspected>> inspected = inspect_all(*files, progress.part(0.05, 0.95));
  if (!inspected) return failure(inspected.error());

  Study study;
  std::vector<std::string> uids;
  std::map<std::string, std::vector<DicomImage>> images_of_series;
  for (std::size_t i = 0; i < files->size(); ++i) {
    Inspected& file = (*inspected)[i];
    if (file.image) {
      std::vector<DicomImage>& images = images_of_series[file.image->series_uid];
      if (images.empty()) uids.push_back(file.image->series_uid);
      images.push_back(std::move(*file.image));
    } else if (file.volume_file) {
      study.series.push_back(std::move(*file.volume_file));
    } else {
      study.skipped.push_back({(*files)[i], std::move(file.reason_to_skip)});
    }
  }
  for (std::size_t i = 0; i < uids.size(); ++i) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.95 + 0.05 * static_cast<double>(i) / static_cast<double>(uids.size()),
                    GLISSON_TEXT("Sorting the series"));
    for (Series& series : assemble_series(std::move(images_of_series[uids[i]]))) {
      study.series.push_back(std::move(series));
    }
  }
  std::stable_sort(study.series.begin(), study.series.end(),
                   [](const Series& a, const Series& b) { return a.number < b.number; });
  compare_frames_of_reference(study.series);
  progress.report(1, GLISSON_TEXT("Sorting the series"));
  return study;
}

namespace {

Result<std::vector<fs::path>> files_in_folder(const fs::path& folder, const Progress& progress) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  if (error) {
    return failure(Error{"path-not-readable",
                         GLISSON_TEXT("The folder {0} cannot be read."),
                         {folder.string()},
                         GLISSON_TEXT("Check your rights there."),
                         folder});
  }
  std::vector<fs::path> files;
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (error) break;
    if (progress.cancelled()) return cancelled();
    std::error_code ignored;
    if (entry->is_directory(ignored) || is_dicomdir(entry->path())) continue;
    files.push_back(entry->path());
    if (files.size() % 512 == 0) progress.report(0.5, fmt::format("{}: {}", GLISSON_TEXT("Files found"), files.size()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Discs written on other systems come with their names in capitals or not.
fs::path as_found_on_disc(const fs::path& named, const fs::path& root) {
  std::error_code ignored;
  if (fs::exists(named, ignored)) return named;
  fs::path lower = root;
  for (const fs::path& part : named.lexically_relative(root)) lower /= in_lower_case(part.string());
  return fs::exists(lower, ignored) ? lower : named;
}

Result<std::vector<fs::path>> files_under(const fs::path& path, const Progress& progress) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return failure(Error{"path-not-found",
                         GLISSON_TEXT("There is nothing at {0}."),
                         {path.string()},
                         GLISSON_TEXT("Check the path."),
                         path});
  }
  if (fs::is_directory(status)) return files_in_folder(path, progress);
  if (!is_dicomdir(path)) return std::vector<fs::path>{path};
  Result<std::vector<fs::path>> named = files_named_in_dicomdir(path);
  if (!named) return named;
  for (fs::path& file : *named) file = as_found_on_disc(file, path.parent_path());
  return named;
}

Inspected inspect_volume_file(const fs::path& file) {
  const Result<VolumeFileHeader> header = read_volume_file_header(file);
  if (!header) return {{}, {}, header.error().message()};
  Series series;
  series.uid = file.string();
  series.description = file.filename().string();
  series.grid = header->grid;
  series.files = {file};
  series.unit = header->unit;
  if (!series.unit.empty()) series.unit_evidence = "the key \"unit\" of the file";
  const RoleFinding finding = role_of_volume_file(series.description, header->holds_bytes);
  series.role = finding.role;
  series.role_evidence = finding.evidence;
  auto layout = std::make_shared<VoxelLayout>();
  layout->volume_file = file;
  series.layout = std::move(layout);
  return {{}, std::move(series), {}};
}

Inspected inspect(const fs::path& file) {
  if (has_volume_file_name(file)) return inspect_volume_file(file);
  Result<DicomImage> image = read_dicom_image_header(file);
  if (image) return {std::move(*image), {}, {}};
  return {{}, {}, image.error().message()};
}

Result<std::vector<Inspected>> inspect_all(const std::vector<fs::path>& files, const Progress& progress) {
  std::vector<Inspected> inspected(files.size());
  std::atomic<std::size_t> done{0};
  std::mutex reporting;
  parallel_for(files.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) {
      inspected[i] = inspect(files[i]);
      const std::size_t count = ++done;
      if (count % 32 != 0) continue;
      const std::scoped_lock one_at_a_time(reporting);
      progress.report(static_cast<double>(count) / static_cast<double>(files.size()),
                      fmt::format("{}: {} / {}", GLISSON_TEXT("Files looked at"), count, files.size()));
    }
  });
  if (progress.cancelled()) return cancelled();
  return inspected;
}

// A stiffness map can be laid on an anatomy only if both were measured in the same frame, without moving the patient.
void compare_frames_of_reference(std::vector<Series>& series) {
  for (Series& stiffness : series) {
    if (stiffness.role != Role::mre_stiffness || stiffness.frame_of_reference_uid.empty()) continue;
    const Series* other_frame = nullptr;
    bool shared = false;
    for (const Series& anatomy : series) {
      if (anatomy.role != Role::anatomy || anatomy.study_uid != stiffness.study_uid) continue;
      if (anatomy.frame_of_reference_uid == stiffness.frame_of_reference_uid) shared = true;
      if (other_frame == nullptr) other_frame = &anatomy;
    }
    if (shared || other_frame == nullptr) continue;
    stiffness.problems.push_back(fmt::format(
        "Its frame of reference is not that of the anatomy ({}): the patient may "
        "have moved between them.",
        other_frame->description.empty() ? fmt::format("series {}", other_frame->number) : other_frame->description));
  }
}

}  // namespace
}  // namespace glisson::imaging
