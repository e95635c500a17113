#pragma once
// What was done to a case in the window, as commands that do it again without one. Run on the case as it was before the
// first of them, they lead to the same files, byte for byte.
//
// A step of the history becomes the commands that computed its entries, where Glisson computed them from the case
// alone. How an entry was made says from what, and with which options. What a hand drew or placed, and what came from
// outside, is taken over from the recorded history (`redo`, redo_step.h).
//
// What changed nothing in the case becomes the command that answers it. A tool on a patch becomes a simulation, a cut
// in the making the answer to it as a plan. Tools in contact, and cuts led on under them, become a session. That comes
// to the same digests as in the window, or fails. A liver laid by hand on a frame becomes guidance that begins there.

#include <filesystem>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/case.h"

namespace glisson::casefile {

// One call, twice. In `words`, what comes after "glisson-cli", the_case and recorded_case stand for folders,
// "{sequence-1}" for a file: a case does not know where its videos lie.
inline constexpr const char* the_case = "{case}";
inline constexpr const char* recorded_case = "{recorded}";
inline constexpr const char* sequence_word = "{sequence-";  // and "1}" for the first of Macro::sequences
struct Command {
  std::vector<std::string> words;
  std::string python;     // statements about `patient`, a glisson.Case, and `recorded`, the folder
  std::string file = {};  // which the command line reads, and the JSON in it
  std::string document = {};
};

struct MacroStep {
  int number = 0;  // in the case's history
  Sentence name;
  std::vector<Command> commands;  // none: it moved a view, or
  int told_in = 0;                // the session of this later step holds it too
};

struct Macro {
  std::filesystem::path recorded;           // the case
  bool earlier_forgotten = false;           // the history keeps a limited number of steps
  std::vector<MacroStep> steps;             // that are done, not those that were undone
  std::vector<std::string> sequences = {};  // SHA-256 of each sequence.json that a step is of
};

// Fails as Case::open does, and with "history-damaged".
Result<Macro> macro_of(const std::filesystem::path& case_folder);

// A script for a POSIX shell, which ends at the first command that fails; a program in Python. Both begin with what
// they need and which names to change.
[[nodiscard]] std::string as_command_line(const Macro& macro);
[[nodiscard]] std::string as_python(const Macro& macro);

}  // namespace glisson::casefile
