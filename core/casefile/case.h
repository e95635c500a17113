#pragma once
// A case: the folder NAME.glisson with everything known of one patient, and where each piece came from.
//
//   case.json               which files, their SHA-256, how each was made and from what
//   volumes/ID.nrrd         anatomy, stiffness (shear modulus, kPa), confidence, ...
//   labels/ID.nrrd          one structure each, with 3D Slicer's segment name and colour
//   surfaces/ID.vtp, meshes/ID.vtu, results/NAME/...
//
// The folder is the state; a Case is a view of it. Each change is one transaction: new files are written beside the old
// ones, then case.json is replaced, then the new files take their places. Killed at any moment, the case opens as it
// was or as it became; nothing in between. Changes wait for each other, in this program and in others (a lock on the
// folder), and each begins with what case.json says then.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::casefile {

// How an entry was made. `from` names entries of this case; `sources` maps files from outside to their SHA-256.
struct Provenance {
  std::string by;                              // the stage: "import", "segment", "mesh", ...
  std::map<std::string, std::string> options;  // as a person would write them, numbers with a dot
  std::vector<std::string> from;
  std::map<std::string, std::string> sources;
  std::vector<Sentence> notes;  // what a person should know of it ("the liver touches the image border")
};

struct Entry {
  std::string id;              // "volumes/anatomy", "labels/liver", "meshes/liver"
  std::filesystem::path file;  // relative to the case folder
  std::string sha256;
  Provenance made;
  std::map<std::string, std::string> from_sha256;  // the content of each entry in made.from when this was made
  std::string version;                             // of Glisson
  std::string when_utc;                            // ISO 8601
};

// What an entry is to become, or that it is to go.
struct Replacement {
  std::string id;
  std::optional<Entry> entry;                                       // absent: taken out, its file removed
  std::function<Result<void>(const std::filesystem::path&)> write;  // its file, whose content entry->sha256 names
};

enum class Freshness {
  current,          // made from what the case holds now
  stale,            // something that it was made from has changed since
  changed_outside,  // the file is not the one that was saved: another program wrote it
  missing,          // the file is gone
};

class Case {
 public:
  // Makes the folder, which must not exist yet or be empty; its name should end in ".glisson".
  static Result<Case> create(const std::filesystem::path& folder);

  // Reads case.json and finishes or takes back an addition that was interrupted.
  static Result<Case> open(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] const Entry* find(const std::string& id) const;

  // The full path of an entry's file; the error says which stage makes the missing entry.
  [[nodiscard]] Result<std::filesystem::path> file_of(const std::string& id) const;

  // A measured quantity of the case, "volumes/anatomy". Fails as file_of and imaging::read_volume_file do.
  [[nodiscard]] Result<imaging::Volume> volume(const std::string& id) const;

  // "SIMULATED ...", or empty for a real patient: shown wherever anything of the case is shown.
  [[nodiscard]] const std::string& origin() const { return origin_; }
  Result<void> set_origin(std::string origin);

  // Writes a file with write(path) and records it under `id`, replacing an entry of that id.
  Result<void> add(const std::string& id, const std::string& extension, Provenance made,
                   const std::function<Result<void>(const std::filesystem::path&)>& write);

  // Takes an entry out and removes its file.
  Result<void> remove(const std::string& id);

  // Several entries in one transaction. Fails with "case-wrong-content" where a file comes out other than its entry
  // says; then nothing has changed.
  Result<void> replace(const std::vector<Replacement>& replacements);

  // All that change() adds, removes and sets becomes one transaction: where it fails, nothing of it has happened.
  // Inside, what was added can be read (file_of); other programs wait. A call inside of another joins it.
  Result<void> together(const std::function<Result<void>()>& change);

  // Reads files to compare their content: costs time on large volumes.
  [[nodiscard]] Freshness freshness(const std::string& id) const;

 private:
  Result<void> reread();
  Result<void> save() const;
  Result<void> finish_interrupted_addition() const;
  Result<void> stage(const std::vector<Replacement>& replacements);
  Result<void> commit();

  // What a transaction has changed so far: what was before it, the files that wait for their places, and those that go.
  struct Transaction {
    std::vector<Entry> entries_before;
    std::string origin_before;
    std::vector<std::filesystem::path> waiting_for, leaving;
  };
  enum class Recorded { no, yes };  // in case.json
  Result<void> take_back(const Error& error, Recorded recorded = Recorded::no);

  std::filesystem::path folder_;
  std::string origin_;
  std::vector<Entry> entries_;
  std::optional<Transaction> transaction_;
};

}  // namespace glisson::casefile
