#pragma once
// The files of the plan that Rehearse, Guide and the report follow (results/resection, see plans.h). They are no
// entries of the case, and yet go back and forth with the step of the history that wrote them.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "casefile/internal/history_content.h"

namespace glisson::casefile {

// SHA-256 of those that are there, by their place in the case folder. None where the place is a link to another.
using FollowedFiles = std::map<std::string, std::string>;
[[nodiscard]] FollowedFiles followed_files(const std::filesystem::path& case_folder);

// One of them before and after a step; an empty hash: it was not there.
struct FileChange {
  std::string file;
  std::string before;
  std::string after;
};
[[nodiscard]] std::vector<FileChange> changes_between(const FollowedFiles& before, const FollowedFiles& after);

// As an entry would be kept under its content.
[[nodiscard]] Entry entry_for(const std::string& file, const std::string& sha256);

// Keeps the contents that are in the case now, so that a later step can bring them back.
Result<void> keep_followed(const std::filesystem::path& case_folder, const KeptFiles& kept, const FollowedFiles& files);

// Leaves the files as one side of the changes has them; those that are so already stay. What only this program writes
// comes back from what was kept.
enum class Towards { before, after };
Result<void> bring_followed(const std::filesystem::path& case_folder, const KeptFiles& kept,
                            const std::vector<FileChange>& changes, Towards side);
// The same with each content from where `place_of` says.
using PlaceOf = std::function<std::filesystem::path(const Entry&)>;
Result<void> bring_followed(const std::filesystem::path& case_folder, const PlaceOf& place_of,
                            const std::vector<FileChange>& changes, Towards side);

}  // namespace glisson::casefile
