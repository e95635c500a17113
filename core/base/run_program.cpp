#include "base/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>

extern char** environ;

namespace glisson {
namespace {

constexpr int look_ms = 100;  // how often it is asked whether to go on
constexpr std::chrono::seconds patience{3};

// The end of a pipe that is read.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) ends_[0] = ends_[1] = -1;
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_writing();
    if (ends_[0] >= 0) ::close(ends_[0]);
  }
  [[nodiscard]] bool open() const { return ends_[0] >= 0; }
  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }
  void close_writing() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
};

// What a program prints, as lines; bars of progress end theirs with a carriage return.
class Printed {
 public:
  // True where a line came to its end.
  bool add(const char* bytes, std::size_t count);
  [[nodiscard]] const std::string& last() const { return last_; }
  [[nodiscard]] std::optional<double> fraction() const;  // of the last line that names one

 private:
  std::string begun_, last_;
  std::optional<double> fraction_;
};

enum class Came { something, nothing, end };
Came follow(int reading, int wait_ms, Printed& printed, const Progress& progress);
int start(const std::vector<std::string>& words, int output, pid_t& child);
bool has_ended(pid_t child);
int end_of(pid_t child, bool stop);
Failure not_started(const std::string& program, int problem);

}  // namespace

Result<void> run_program(const std::vector<std::string>& words, const Progress& progress) {
  Pipe pipe;
  if (!pipe.open()) return not_started(words.front(), errno);
  pid_t child = 0;
  if (const int problem = start(words, pipe.writing(), child); problem != 0) return not_started(words.front(), problem);
  pipe.close_writing();

  Printed printed;
  int reading = pipe.reading();
  bool stop = false;
  while (!stop && !has_ended(child)) {
    if (follow(reading, look_ms, printed, progress) == Came::end) reading = -1;  // poll() passes it over
    stop = progress.cancelled();
  }
  while (follow(reading, 0, printed, progress) == Came::something) {
  }
  const int status = end_of(child, stop);
  if (stop) return cancelled();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string how =
      WIFEXITED(status) ? fmt::format("exit code {}", WEXITSTATUS(status)) : fmt::format("signal {}", WTERMSIG(status));
  return failure(Error{"program-failed",
                       GLISSON_TEXT("{0} failed ({1}): {2}"),
                       {words.front(), how, printed.last().empty() ? "..." : printed.last()},
                       GLISSON_TEXT("Run it by hand to see all that it says."),
                       {}});
}

Result<std::vector<std::string>> words_of_command(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool in_word = false;
  char quote = 0;
  for (std::size_t n = 0; n < command.size(); ++n) {
    const char c = command[n];
    const bool more = n + 1 < command.size();
    if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      if (in_word) words.push_back(std::move(word));
      word.clear();
      in_word = false;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
      in_word = true;
    } else if (c == quote) {
      quote = 0;
    } else if (c == '\\' && more &&
               (quote == 0 || (quote == '"' && (command[n + 1] == '"' || command[n + 1] == '\\')))) {
      word += command[++n];
      in_word = true;
    } else {
      word += c;
      in_word = true;
    }
  }
  if (quote != 0) {
    return failure(Error{"command-quote-open",
                         GLISSON_TEXT("In the command {0} a quotation mark is not closed."),
                         {command},
                         GLISSON_TEXT("Close it, or write \\ before it."),
                         {}});
  }
  if (in_word) words.push_back(std::move(word));
  if (words.empty()) {
    return failure(Error{"command-empty", GLISSON_TEXT("The command is empty."), {}, {}, {}});
  }
  return words;
}

namespace {

bool Printed::add(const char* bytes, std::size_t count) {
  constexpr std::size_t longest = 200;
  bool ended = false;
  for (std::size_t n = 0; n < count; ++n) {
    const char c = bytes[n];
    if (c != '\n' && c != '\r') {
      if (static_cast<unsigned char>(c) >= ' ' && begun_.size() < longest) begun_ += c;
      continue;
    }
    const std::size_t first = begun_.find_first_not_of(' ');
    if (first == std::string::npos) {
      begun_.clear();
      continue;
    }
    last_ = begun_.substr(first);
    begun_.clear();
    ended = true;
    const std::size_t sign = last_.find('%');
    std::size_t digits = sign == std::string::npos ? 0 : sign;
    while (digits > 0 &&
           (std::isdigit(static_cast<unsigned char>(last_[digits - 1])) != 0 || last_[digits - 1] == '.')) {
      --digits;
    }
    if (sign != std::string::npos && digits < sign) {
      fraction_ = std::clamp(std::strtod(last_.c_str() + digits, nullptr) / 100, 0.0, 1.0);
    }
  }
  return ended;
}

std::optional<double> Printed::fraction() const { return fraction_; }

Came follow(int reading, int wait_ms, Printed& printed, const Progress& progress) {
  pollfd waiting{reading, POLLIN, 0};
  if (::poll(&waiting, 1, wait_ms) <= 0) return Came::nothing;
  char bytes[4096];
  const ssize_t count = ::read(reading, bytes, sizeof bytes);
  if (count <= 0) return Came::end;
  if (printed.add(bytes, static_cast<std::size_t>(count))) {
    progress.report(printed.fraction().value_or(0), printed.last());
  }
  return Came::something;
}

// In a group of its own, so that what it starts can be stopped with it. 0, or what the system says.
int start(const std::vector<std::string>& words, int output, pid_t& child) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, 1);
  posix_spawn_file_actions_adddup2(&actions, output, 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int problem = ::posix_spawnp(&child, words.front().c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

bool has_ended(pid_t child) {
  siginfo_t ended{};
  return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == child;
}

// Waits for it; its group is stopped first where that is wanted.
int end_of(pid_t child, bool stop) {
  int status = 0;
  if (stop) {
    ::kill(-child, SIGTERM);
    const auto until = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < until) {
      if (::waitpid(child, &status, WNOHANG) == child) {
        ::kill(-child, SIGKILL);  // what did not listen while the first of them did
        return status;
      }
      ::poll(nullptr, 0, 20);
    }
    ::kill(-child, SIGKILL);
  }
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

Failure not_started(const std::string& program, int problem) {
  if (problem == ENOENT) {
    return failure(Error{"program-not-found",
                         GLISSON_TEXT("There is no program {0} on this computer."),
                         {program},
                         GLISSON_TEXT("Install it, or write where it lies."),
                         {}});
  }
  return failure(Error{"program-not-started",
                       GLISSON_TEXT("{0} could not be started: {1}"),
                       {program, std::strerror(problem)},
                       GLISSON_TEXT("Check that it may be run."),
                       {}});
}

}  // namespace
}  // namespace glisson
