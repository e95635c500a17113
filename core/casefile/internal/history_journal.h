#pragma once
// What the files of a case's history hold (see history.h): the journal, and the entries that a step changed. Values;
// reading and writing them as JSON. What is malformed throws Json::exception, or fails with
// "history-damaged".

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "casefile/history.h"
#include "casefile/internal/followed_files.h"
#include "casefile/internal/history_content.h"
#include "casefile/internal/sentence_record.h"

namespace glisson::casefile {

// Which side of a step the case stands on, or is to be brought to.
enum class Side { before, after };

struct Step {
  int number = 0;
  Sentence name;
  std::vector<ValueChange> values;        // of a step about values; empty: it is about entries
  std::vector<std::string> kept;          // the kept files that it needs, by name
  std::vector<FileChange> followed = {};  // of the plan that is followed
};

// The list of steps, as journal.json holds it.
struct Listing {
  std::vector<Step> steps;
  std::size_t done = 0;
  int next = 1;
  bool forgotten = false;  // whether there were earlier steps that are no longer known
  std::map<std::string, std::string> values;
  std::optional<std::pair<int, Side>> moving;  // an undo or redo under way: the step, and where to
};
using glisson::json_of;  // beside those of this room
Json json_of(const Listing& listing);
Listing listing_from(const Json& json);
// None where the case has no history yet. Fails with "history-damaged".
Result<Listing> read_listing(const std::filesystem::path& case_folder);

[[nodiscard]] std::filesystem::path file_of_step(const std::filesystem::path& case_folder, int number);
[[nodiscard]] std::filesystem::path file_of_runs(const std::filesystem::path& case_folder, int number, std::string id);

// Of the recording beside values; no path leads out of the folder, whatever a case names a session.
[[nodiscard]] std::filesystem::path file_of_session(const std::filesystem::path& case_folder,
                                                    const std::string& session);

// One entry of a step about entries; steps/N.json holds a list of them.
struct EntryChange {
  std::string id;
  Sides sides;
  Json content;
};
Json json_of(const std::vector<EntryChange>& changes);
Result<std::vector<EntryChange>> read_changes(const std::filesystem::path& file);

// A change under way: what the case held when it began. begun.json holds it until the change is a step.
struct BegunStep {
  int number = 0;
  Sentence name;
  std::vector<std::string> touches;       // the entries that may change, by id; empty: all
  std::vector<Entry> entries;             // of these, those that were there
  std::optional<FollowedFiles> followed;  // where all may change
};
Json json_of(const BegunStep& begun);
Result<BegunStep> read_begun_step(const std::filesystem::path& file);

Failure history_damaged(const std::filesystem::path& file);

}  // namespace glisson::casefile
