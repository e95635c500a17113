#pragma once
// What was done to a case and can be undone, kept in the case folder, so that it outlives the program.
//
//   history/journal.json     which steps there are, in order, and how many of them are done
//   history/steps/N.json     one step: the entries of case.json before and after, and small values before and after
//   history/steps/N-ID.runs  of a label: the voxels that the step turned
//   history/kept/SHA256.EXT  of any other file: what it held before it was replaced
//                            (of the plan that is followed, results/resection, too)
//   history/kept/session-ID.json  commands of a session that led to small values
//   history/begun.json       while a change is under way: what the case was when it began
//
// A step is a difference, never a whole volume where runs of voxels say the same. Beyond the caps the oldest steps are
// forgotten. If the program is killed at any moment, the case and its history open together. A change that was recorded
// is there with its step. A change under way is there as far as it came, with a step that takes it back.
//
// One History at a time may be open on a case; it may be used from several threads, whose changes wait for each other.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/case.h"

namespace glisson::casefile {

// A small value that a case does not hold as a file: where a tool stands, what was accepted. `key` is its owner's
// ("rehearse/tool"); the values are JSON documents as text, empty where there was none.
struct ValueChange {
  std::string key;
  std::string before;
  std::string after;
};

// What led to a value and would be too long to stand in it: commands of a session, which grow from step to step. It is
// kept as long as a step with it is.
struct RecordingBeside {
  std::string session;  // letters, digits and dashes
  std::string text;     // JSON; takes the place of what was kept of that session
};
// As it was kept; empty where there is none.
[[nodiscard]] std::string recording_beside(const std::filesystem::path& case_folder, const std::string& session);

struct HistoryCaps {
  // Of everything under history/. A stroke of the brush takes about a kilobyte, a model that was built anew some
  // megabytes: weeks of drawing, or dozens of models.
  std::uintmax_t disk_bytes = std::uintmax_t{256} << 20;
  // Each also takes some hundred bytes of memory: no volume is held there.
  std::size_t steps = 1000;
};

class History {
 public:
  // What an undo or redo has changed: entries that are other than before (or gone), and values with what they are now.
  struct Moved {
    Sentence name;
    std::vector<std::string> entries;  // and the files in results/resection
    std::vector<ValueChange> values;   // `after` is what holds now
  };

  // Takes up what was interrupted. Fails with "history-in-use" where another window has it open. A history that cannot
  // be read must not keep anybody from the case. It is put aside (history.damaged) and begun anew.
  static Result<std::unique_ptr<History>> open(const std::filesystem::path& case_folder, HistoryCaps caps = {});

  // Runs `change`, which may add, replace and remove entries of the case, and keeps what it did as one step under
  // `name`. A change that failed half-way leaves a step with what it had done; one that did nothing leaves none. Steps
  // that were undone are dropped. Returns what `change` returned. `touches` names the entries that it may change;
  // empty: any.
  Result<void> record(const Sentence& name, const std::function<Result<void>()>& change,
                      const std::vector<std::string>& touches = {});

  // The same for values. Within `joins`, a change of the same keys as the last step becomes part of that step. So a
  // slider that is dragged is one step.
  enum class Joins { no, last_of_same_keys };
  Result<void> record_values(const Sentence& name, const std::vector<ValueChange>& values, Joins joins = Joins::no,
                             const std::optional<RecordingBeside>& beside = {});

  // What a key holds as things stand; empty where nothing is known of it.
  [[nodiscard]] std::string value_of(const std::string& key) const;

  // Of the step that would be undone or redone next.
  [[nodiscard]] std::optional<Sentence> undo_name() const;
  [[nodiscard]] std::optional<Sentence> redo_name() const;

  // Fails with "history-overtaken" where something else (glisson-cli, another program) changed the same entries since.
  // The history then ends here and is empty. Fails with "history-nothing-left" where there is no step.
  Result<Moved> undo();
  Result<Moved> redo();

  [[nodiscard]] std::size_t steps_to_undo() const;
  [[nodiscard]] std::size_t steps_to_redo() const;
  [[nodiscard]] std::uintmax_t disk_bytes() const;

  ~History();

 private:
  struct Impl;
  explicit History(std::unique_ptr<Impl> parts);
  std::unique_ptr<Impl> impl_;
  std::mutex changing_;  // held throughout a change
};

}  // namespace glisson::casefile
