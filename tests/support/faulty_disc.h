#pragma once
// Runs a program on a disc on which one operation goes wrong.
//
// The kernel stops the program at every system call that changes files below a folder (seccomp's user notification),
// so that libraries and threads are caught as well as ourselves, whatever they call. These stops are counted. At the
// one that is asked for, the call is refused, does half of its work, or the program is killed before it.

#include <filesystem>
#include <string>
#include <vector>

namespace glisson::test {

enum class Fault {
  none,
  no_space,     // ENOSPC
  not_allowed,  // EACCES
  interrupted,  // EINTR, once
  short_write,  // half of the bytes, and then no space
  killed,       // SIGKILL before the call
};

struct DiscRun {
  int exit_code = -1;  // 128 + signal where one ended it
  std::string out, err;
  std::vector<std::string> stops;    // "write results/.part-result.vtu", in order, as far as it came
  std::vector<std::string> outside;  // what was changed elsewhere: neither below the folder nor in memory
};

// False where the system does not let a program watch its child so (an old kernel, a container that forbids it).
bool can_watch_discs();

// `at` counts from 0. With an environment of its own: TMPDIR and HOME lie in `folder`, too.
DiscRun run_on_faulty_disc(const std::filesystem::path& folder, const std::vector<std::string>& words,
                           Fault fault = Fault::none, std::size_t at = 0);

// Which faults a stop can meet at all: opening is never short, and what is being removed needs no space.
std::vector<Fault> faults_of(const std::string& stop);

std::string name_of(Fault fault);

}  // namespace glisson::test
