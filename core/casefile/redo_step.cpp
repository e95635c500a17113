#include "casefile/redo_step.h"

#include <algorithm>
#include <optional>

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/internal/history_journal.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

Result<Step> step_of(const fs::path& recorded_case, int number);
Result<void> check_fits(const Case& patient, const Step& step, const std::vector<EntryChange>& changes,
                        const fs::path& recorded_case);
Result<fs::path> content_in(const fs::path& recorded_case, const Entry& entry);
Replacement replacement_of(const Case& patient, const fs::path& recorded_case, int number, const EntryChange& change);

}  // namespace

Result<void> redo_step(Case& patient, const fs::path& recorded_case, int number) {
  const auto step = step_of(recorded_case, number);
  if (!step) return failure(step.error());
  const auto changes = read_changes(file_of_step(recorded_case, number));
  if (!changes) return failure(changes.error());
  for (const FileChange& change : step->followed) {
    if (change.after.empty()) continue;
    if (auto there = content_in(recorded_case, entry_for(change.file, change.after)); !there) {
      return failure(std::move(there.error()));
    }
  }
  auto replaced = patient.together([&]() -> Result<void> {
    if (auto fits = check_fits(patient, *step, *changes, recorded_case); !fits) return fits;
    std::vector<Replacement> replacements;
    for (const EntryChange& change : *changes) {
      replacements.push_back(replacement_of(patient, recorded_case, number, change));
    }
    try {
      return patient.replace(replacements);
    } catch (const Json::exception&) {
      return history_damaged(file_of_step(recorded_case, number));
    }
  });
  if (!replaced) return replaced;
  const PlaceOf place_of = [&](const Entry& entry) { return content_in(recorded_case, entry).value_or(fs::path()); };
  return bring_followed(patient.folder(), place_of, step->followed, Towards::after);
}

namespace {

Result<Step> step_of(const fs::path& recorded_case, int number) {
  const auto listing = read_listing(recorded_case);
  if (!listing) return failure(listing.error());
  const auto step = std::find_if(listing->steps.begin(), listing->steps.end(),
                                 [&](const Step& each) { return each.number == number; });
  if (step == listing->steps.end()) {
    return failure(Error{"step-unknown",
                         GLISSON_TEXT("The history of {0} has no step {1}."),
                         {recorded_case.string(), std::to_string(number)},
                         GLISSON_TEXT("See which there are: glisson-cli macro CASE."),
                         recorded_case});
  }
  if (!step->values.empty()) {
    return failure(Error{"step-changes-nothing",
                         GLISSON_TEXT("Step {1} of {0} changed a view and nothing in the case."),
                         {recorded_case.string(), std::to_string(number)},
                         {},
                         recorded_case});
  }
  return *step;
}

std::string content_of(const Entry* entry) { return entry != nullptr ? entry->sha256 : std::string(); }

Result<void> check_fits(const Case& patient, const Step& step, const std::vector<EntryChange>& changes,
                        const fs::path& recorded_case) {
  const auto other = [&](const std::string& what) -> Result<void> {
    return failure(Error{"step-does-not-fit",
                         GLISSON_TEXT("Step {0} of {1} began with another {2} than {3} holds."),
                         {std::to_string(step.number), recorded_case.string(), what, patient.folder().string()},
                         GLISSON_TEXT("Begin with the case as it was, and do all steps in their order."),
                         patient.folder()});
  };
  for (const EntryChange& change : changes) {
    const Entry* before = change.sides.before ? &*change.sides.before : nullptr;
    if (content_of(patient.find(change.id)) != content_of(before)) return other(change.id);
  }
  const FollowedFiles now = followed_files(patient.folder());
  for (const FileChange& change : step.followed) {
    const auto there = now.find(change.file);
    if ((there == now.end() ? std::string() : there->second) != change.before) return other(change.file);
  }
  return {};
}

// Kept under its content, or still in the recorded case.
Result<fs::path> content_in(const fs::path& recorded_case, const Entry& entry) {
  const fs::path kept = KeptFiles(recorded_case / "history" / "kept").place_of(entry);
  std::error_code ignored;
  if (fs::exists(kept, ignored)) return kept;
  const fs::path there = recorded_case / entry.file;
  if (sha256_of_file(there).value_or("") == entry.sha256) return there;
  return failure(Error{"step-content-gone",
                       GLISSON_TEXT("{0} no longer holds what a step of its history led to: {1}."),
                       {recorded_case.string(), entry.file.string()},
                       GLISSON_TEXT("Another program has changed it; do this step in the window."),
                       recorded_case});
}

Replacement replacement_of(const Case& patient, const fs::path& recorded_case, int number, const EntryChange& change) {
  const Entry* now = patient.find(change.id);
  const auto from = now != nullptr ? std::optional(*now) : std::nullopt;
  return {change.id, change.sides.after,
          [&patient, recorded_case, number, change, from](const fs::path& target) -> Result<void> {
            if (is_whole_file(change.content)) {
              const auto source = content_in(recorded_case, *change.sides.after);
              return source ? write_copy(*source, target) : failure(source.error());
            }
            const KeptFiles kept(recorded_case / "history" / "kept");
            return write_other_side(patient.folder(), kept, change.content, from, *change.sides.after,
                                    file_of_runs(recorded_case, number, change.id), target);
          }};
}

}  // namespace
}  // namespace glisson::casefile
