#include "casefile/internal/followed_files.h"

#include <array>
#include <system_error>

#include "base/files.h"
#include "base/write_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* resection_folder = "results/resection";
// The first comes last and goes first: without it the others are no plan.
constexpr std::array<const char*, 3> names{"results/resection/resection.json", "results/resection/cut.vtp",
                                           "results/resection/parts.vtu"};

bool leads_elsewhere(const fs::path& case_folder) {
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(case_folder / "results", ignored)) ||
         fs::is_symlink(fs::symlink_status(case_folder / resection_folder, ignored));
}

}  // namespace

FollowedFiles followed_files(const fs::path& case_folder) {
  FollowedFiles found;
  if (leads_elsewhere(case_folder)) return found;
  for (const char* name : names) {
    std::error_code ignored;
    if (!fs::is_regular_file(fs::symlink_status(case_folder / name, ignored))) continue;
    if (auto content = sha256_of_file(case_folder / name)) found[name] = std::move(*content);
  }
  return found;
}

std::vector<FileChange> changes_between(const FollowedFiles& before, const FollowedFiles& after) {
  const auto content = [](const FollowedFiles& files, const char* name) {
    const auto found = files.find(name);
    return found == files.end() ? std::string() : found->second;
  };
  std::vector<FileChange> changes;
  for (const char* name : names) {
    if (content(before, name) != content(after, name)) {
      changes.push_back({name, content(before, name), content(after, name)});
    }
  }
  return changes;
}

Entry entry_for(const std::string& file, const std::string& sha256) { return {file, file, sha256, {}, {}, {}, {}}; }

Result<void> keep_followed(const fs::path& case_folder, const KeptFiles& kept, const FollowedFiles& files) {
  for (const auto& [file, content] : files) {
    if (auto held = kept.keep(case_folder, entry_for(file, content)); !held) return held;
  }
  return {};
}

Result<void> bring_followed(const fs::path& case_folder, const KeptFiles& kept, const std::vector<FileChange>& changes,
                            Towards side) {
  return bring_followed(
      case_folder, [&](const Entry& entry) { return kept.place_of(entry); }, changes, side);
}

Result<void> bring_followed(const fs::path& case_folder, const PlaceOf& place_of,
                            const std::vector<FileChange>& changes, Towards side) {
  if (changes.empty() || leads_elsewhere(case_folder)) return {};
  const FollowedFiles now = followed_files(case_folder);
  std::error_code problem;
  for (const char* name : names) {
    for (const FileChange& change : changes) {
      const std::string& wanted = side == Towards::before ? change.before : change.after;
      if (change.file == name && wanted.empty()) fs::remove(case_folder / name, problem);
    }
  }
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    for (const FileChange& change : changes) {
      const std::string& wanted = side == Towards::before ? change.before : change.after;
      const auto there = now.find(change.file);
      if (change.file != *name || wanted.empty() || (there != now.end() && there->second == wanted)) continue;
      fs::create_directories(case_folder / resection_folder, problem);  // what is wrong shows in the writing
      const fs::path source = place_of(entry_for(change.file, wanted));
      if (auto written = write_copy(source, case_folder / change.file); !written) return written;
    }
  }
  if (fs::is_empty(case_folder / resection_folder, problem)) fs::remove(case_folder / resection_folder, problem);
  return {};
}

}  // namespace glisson::casefile
