// A fuzzer that needs no more than the compiler. For each target: good files first, then broken ones (mutator.h), for a
// bounded number and time, in a process of its own with bounded memory. A run that brings the reader down, or that does
// not end within 10 s, is named by its number and can be repeated.
//
//   fuzz_ROOM [TARGET ...] [--mutations N] [--seconds S] [--from N] [--memory-MB M]
//   fuzz_ROOM TARGET --only N [--write FILE]     one mutation, in this process; FILE gets its bytes
//   fuzz_ROOM TARGET --write-seeds FOLDER        the good files, as a corpus for libFuzzer
//   fuzz_ROOM --list

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "base/files.h"
#include "fuzz/mutator.h"
#include "fuzz/target.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> targets;
  std::map<std::string, std::string> values;  // by option

  [[nodiscard]] long number(const std::string& option, long otherwise) const {
    const auto found = values.find(option);
    return found == values.end() ? otherwise : std::strtol(found->second.c_str(), nullptr, 10);
  }
};

Options options_from(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word.rfind("--", 0) != 0) {
      options.targets.push_back(word);
    } else if (word == "--list" || i + 1 == count) {
      options.values[word] = "";
    } else {
      options.values[word] = words[++i];
    }
  }
  return options;
}

// What the process that reads tells the one that watches it; lies in memory that both see.
struct Told {
  long under_way;  // the mutation, or -1 for a good file
  long done;
};

// The most that this process may ask for, beyond what its libraries take. Sanitizers reserve far more than they use.
void limit_memory(long megabytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  long pages = 0;
  if (std::ifstream statm("/proc/self/statm"); !(statm >> pages)) return;
  const rlim_t bytes = rlim_t(pages) * rlim_t(::sysconf(_SC_PAGESIZE)) + (rlim_t(megabytes) << 20);
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &limit);
#else
  static_cast<void>(megabytes);
#endif
}

constexpr unsigned longest_run_s = 10;

void run_all(const Target& target, const fs::path& folder, const Options& options, long from,
             std::chrono::steady_clock::time_point end, Told& told) {
  fs::create_directories(folder / "seeds");
  const std::vector<std::string> good = target.seeds(folder / "seeds");
  limit_memory(options.number("--memory-MB", 1024));
  const auto run = [&](const std::string& bytes, long number) {
    told.under_way = number;
    ::alarm(longest_run_s);
    target.run(bytes, folder);
    ::alarm(0);
  };
  if (from == options.number("--from", 0)) {
    for (const std::string& bytes : good) run(bytes, -1);
  }
  const long to = options.number("--from", 0) + options.number("--mutations", 20000);
  for (long number = from; number < to && std::chrono::steady_clock::now() < end; ++number) {
    run(broken(good, static_cast<unsigned>(number)), number);
    ++told.done;
  }
}

std::string end_of(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
    return "took more than " + std::to_string(longest_run_s) + " s";
  }
  if (WIFSIGNALED(status)) return std::string("ended by: ") + ::strsignal(WTERMSIG(status));
  return "ended with code " + std::to_string(WEXITSTATUS(status));
}

// Reads in a process of its own until that is through; goes on behind what brought it down, ten times.
bool fuzz(const Target& target, const Options& options) {
  void* shared = ::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return false;
  Told& told = *new (shared) Told{-1, 0};
  const TemporaryFolder folder;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(options.number("--seconds", 20));
  int fell = 0;
  for (long from = options.number("--from", 0);;) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0) return false;
    if (child == 0) {
      // Libraries complain at every other file; what counts is whether the reader stands.
      if (std::freopen("/dev/null", "w", stderr) == nullptr) std::_Exit(2);
      run_all(target, folder.path(), options, from, end, told);
      std::fflush(nullptr);
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    std::printf("%s: mutation %ld %s; repeat with: %s --only %ld\n", target.name.c_str(), told.under_way,
                end_of(status).c_str(), target.name.c_str(), told.under_way);
    if (++fell == 10 || told.under_way < 0) break;
    from = told.under_way + 1;
  }
  std::printf("%s: %ld mutations, %d of which brought the reader down\n", target.name.c_str(), told.done, fell);
  ::munmap(shared, sizeof(Told));
  return fell == 0;
}

void run_one(const Target& target, const Options& options) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "seeds");
  const std::vector<std::string> good = target.seeds(folder.path() / "seeds");
  const std::string bytes = broken(good, static_cast<unsigned>(options.number("--only", 0)));
  if (const auto file = options.values.find("--write"); file != options.values.end()) {
    std::ofstream(file->second, std::ios::binary) << bytes;
  }
  limit_memory(options.number("--memory-MB", 1024));
  target.run(bytes, folder.path());
}

void write_seeds(const Target& target, const fs::path& to) {
  const TemporaryFolder folder;
  fs::create_directories(to);
  const std::vector<std::string> good = target.seeds(folder.path());
  for (std::size_t n = 0; n < good.size(); ++n) file_of(good[n], to, target.name + "-" + std::to_string(n));
}

}  // namespace

void promise(bool kept, const char* what) {
  if (kept) return;
  std::printf("A promise was broken: %s\n", what);
  std::fflush(stdout);
  std::abort();
}

fs::path file_of(const std::string& bytes, const fs::path& folder, const std::string& name) {
  fs::path file = folder / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

}  // namespace glisson::fuzz

#ifdef GLISSON_LIBFUZZER_TARGET
// libFuzzer brings its own main, and one program a target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glisson::fuzz;
  static const glisson::TemporaryFolder folder;
  static const std::vector<Target> all = targets();
  for (const Target& target : all) {
    if (target.name != GLISSON_LIBFUZZER_TARGET) continue;
    target.run(std::string(reinterpret_cast<const char*>(data), size), folder.path());
  }
  return 0;
}
#else
int main(int count, char** words) {
  using namespace glisson::fuzz;
  // Files in memory: no disc is worn.
  if (std::filesystem::is_directory("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
  const Options options = options_from(count, words);
  bool sound = true, any = false;
  for (const Target& target : targets()) {
    if (options.values.count("--list") > 0) {
      std::printf("%s\n", target.name.c_str());
      any = true;
      continue;
    }
    const auto& asked = options.targets;
    if (!asked.empty() && std::find(asked.begin(), asked.end(), target.name) == asked.end()) continue;
    any = true;
    if (const auto folder = options.values.find("--write-seeds"); folder != options.values.end()) {
      write_seeds(target, folder->second);
    } else if (options.values.count("--only") > 0) {
      run_one(target, options);
    } else {
      sound &= fuzz(target, options);
    }
  }
  if (!any) std::fprintf(stderr, "No such target; --list names them.\n");
  return sound && any ? 0 : 1;
}
#endif
