// glisson-cli: every feature of the core, without a window.
//
// Exit codes: 0 done; 1 the input was refused or the computation did not converge; 2 wrong usage; 3 a defect of ours.

#include <fmt/format.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>

#include "base/error_file.h"
#include "base/files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "command.h"

namespace {

using namespace glisson;

enum ExitCode { done = 0, refused = 1, wrong_usage = 2, defect = 3 };

struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;
};

void add_common_options(CLI::App& app, CommonOptions& common);
int run(const cli::Action& action, const CommonOptions& common);
void end_defects_with_their_exit_code();

}  // namespace

int main(int argc, char** argv) {
  end_defects_with_their_exit_code();

  CLI::App app("Glisson plans and reviews liver surgery. Not a medical device.", "glisson-cli");
  app.set_version_flag("--version", "glisson-cli " + version());
  app.require_subcommand(1);
  app.footer(
      "Lengths mm, stiffness kPa, force N; positions are DICOM patient coordinates (LPS).\n"
      "Exit codes: 0 done; 1 refused or not converged; 2 wrong usage; 3 a defect of Glisson.");

  CommonOptions common;
  cli::Action action;
  cli::add_commands(app, action);
  for (CLI::App* command : app.get_subcommands({})) add_common_options(*command, common);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? done : wrong_usage;
  }
  return run(action, common);
}

namespace {

void add_common_options(CLI::App& app, CommonOptions& common) {
  app.add_flag("--json", common.json, "One JSON document on stdout, nothing else there")->group("Common");
  app.add_flag("--quiet", common.quiet, "No progress on stderr")->group("Common");
  app.add_option("--threads", common.threads, "Threads to use (default: as many as there are cores)")
      ->check(CLI::Range(1, 1024))
      ->group("Common");
}

std::stop_source interruption;

// Tells how far it is on stderr: one line that is rewritten on a terminal, one line a stage elsewhere.
class ProgressPrinter {
 public:
  void report(double fraction, std::string_view stage) {
    const std::scoped_lock lock(mutex_);
    const int percent = static_cast<int>(fraction * 100);
    if (terminal_) {
      if (percent == percent_ && stage == stage_) return;
      std::fputs(fmt::format("\r\033[K{:3d} % {}", percent, stage).c_str(), stderr);
    } else if (stage != stage_) {
      std::fputs(fmt::format("{:3d} % {}\n", percent, stage).c_str(), stderr);
    }
    percent_ = percent;
    stage_ = stage;
  }

  ~ProgressPrinter() {
    if (terminal_ && percent_ >= 0) std::fputs("\r\033[K", stderr);
  }

 private:
  std::mutex mutex_;
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  int percent_ = -1;
  std::string stage_;
};

void print_error(const Error& error, const CommonOptions& common) {
  const std::string message = error.message();
  const std::string hint = error.advice();
  const std::string where = file_behind(message, error);
  std::fputs(fmt::format("glisson-cli: {}{}{}{}\n", message, where, hint.empty() ? "" : " ", hint).c_str(), stderr);
  if (!common.json) return;
  Json document{{"code", error.code}, {"message", message}, {"hint", hint}, {"file", error.file.string()}};
  std::puts(Json{{"error", document}}.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

int run(const cli::Action& action, const CommonOptions& common) {
  set_thread_count(common.threads);
  std::signal(SIGINT, [](int) { interruption.request_stop(); });
  std::signal(SIGTERM, [](int) { interruption.request_stop(); });
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error of the write that meets it
  if (common.quiet) set_log_level(LogLevel::off);

  Result<cli::Outcome> outcome = cancelled();
  try {
    ProgressPrinter printer;
    auto listener = [&printer](double fraction, std::string_view stage) { printer.report(fraction, stage); };
    outcome =
        action(common.quiet ? Progress({}, interruption.get_token()) : Progress(listener, interruption.get_token()));
  } catch (const std::bad_alloc&) {
    outcome = failure("out-of-memory", GLISSON_TEXT("There is not enough memory for this."));
  } catch (const std::exception& problem) {
    std::fputs(fmt::format("glisson-cli: a defect in Glisson: {}\n", problem.what()).c_str(), stderr);
    return defect;
  }

  if (!outcome) {
    print_error(outcome.error(), common);
    return refused;
  }
  GLISSON_ASSERT(all_numbers_finite(outcome->document));
  const std::string answer =
      common.json ? outcome->document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : outcome->text;
  const bool said = std::fputs(answer.c_str(), stdout) >= 0 && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (said) return outcome->passed ? done : refused;
  print_error({"answer-not-written",
               GLISSON_TEXT("The command is done, but its answer cannot be written: {0}."),
               {std::generic_category().message(errno)},
               GLISSON_TEXT("Check where standard output goes, and the space there."),
               {}},
              {});
  return refused;
}

void end_defects_with_their_exit_code() {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS}) {
    std::signal(signal, [](int) { std::_Exit(defect); });
  }
}

}  // namespace
