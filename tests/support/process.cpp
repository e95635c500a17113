#include "support/process.h"
#include "support/folders.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include "base/files.h"

extern char** environ;

namespace glisson::test {

Json Finished::json() const {
  auto document = parse_json(out);
  EXPECT_TRUE(document) << "stdout is not one JSON document:\n" << out << "\nstderr:\n" << err;
  return document.value_or(Json::object());
}

// Through files, so that neither stream can fill a pipe while the other is read.
Finished run(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto err = folder.path() / "err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);

  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  pid_t child = 0;
  const int started = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  Finished finished;
  EXPECT_EQ(started, 0) << program << " cannot be started";
  if (started != 0) return finished;
  int status = 0;
  waitpid(child, &status, 0);
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  finished.out = read_text_file(out).value_or("");
  finished.err = read_text_file(err).value_or("");
  return finished;
}

Finished glisson_cli(const std::vector<std::string>& arguments) {
  return run(glisson::test::build_folder() / "bin" / "glisson-cli", arguments);
}

}  // namespace glisson::test
