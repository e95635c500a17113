#pragma once
// Another program, run to its end without a shell: what it prints is followed, and it can be stopped.

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson {

// A command line as words, split at blanks, with "...", '...' and \ as in a POSIX shell. Nothing else of a shell is
// known: no variables, pipes or patterns. Fails with "command-empty" and with "command-quote-open".
[[nodiscard]] Result<std::vector<std::string>> words_of_command(const std::string& command);

// Runs words[0], searched in PATH, with the other words, and waits for its end. Its standard output and error are read
// together: a percentage in a line ("  45%|####") is the progress, the line itself the stage. When cancelled, it and
// all that it started get SIGTERM, and three seconds later SIGKILL. `words` is not empty.
// Fails with "program-not-found", "program-not-started", "program-failed" (with its last line) or "cancelled".
Result<void> run_program(const std::vector<std::string>& words, const Progress& progress = {});

}  // namespace glisson
