#pragma once
// The contents that a step of the history leads between, as differences of labels or as kept files.

#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"
#include "casefile/case.h"

namespace glisson::casefile {

// Files by their content, as further names of what the case already holds (hard links) wherever the disk can do that.
class KeptFiles {
 public:
  explicit KeptFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] std::filesystem::path place_of(const Entry& entry) const;
  Result<void> keep(const std::filesystem::path& case_folder, const Entry& entry) const;

 private:
  std::filesystem::path folder_;
};

// How each side of a change can be made from the other; as JSON, which a step keeps. `runs_file` is written where the
// content is a label whose sides differ by runs. Else both sides are whole files, and the earlier one is kept already.
struct Sides {
  std::optional<Entry> before;
  std::optional<Entry> after;
};
Result<Json> difference_of(const std::filesystem::path& case_folder, const KeptFiles& kept, const Sides& sides,
                           const std::filesystem::path& runs_file);

// Writes the side that is not in the case now. `content` is what difference_of gave, `from` the side that is.
Result<void> write_other_side(const std::filesystem::path& case_folder, const KeptFiles& kept, const Json& content,
                              const std::optional<Entry>& from, const Entry& to, const std::filesystem::path& runs_file,
                              const std::filesystem::path& target);

// Whether the content is whole files, so that the side which leaves the case has to be kept.
[[nodiscard]] bool is_whole_file(const Json& content);

}  // namespace glisson::casefile
