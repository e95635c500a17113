// Other people's programs: their words, their progress, their failures, and that they end when they are told to.

#include "base/run_program.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>

#include "base/files.h"

namespace glisson {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<void> run_in_shell(const std::string& script, const Progress& progress = {}) {
  return run_program({"sh", "-c", script}, progress);
}

TEST(WordsOfCommand, AreThoseOfAShellWithoutItsOtherMeanings) {
  EXPECT_THAT(*words_of_command("  Total -i {image}\t-o '{folder}' "),
              ElementsAre("Total", "-i", "{image}", "-o", "{folder}"));
  EXPECT_THAT(*words_of_command(R"("C:\a b\net" "say \"x\"" one\ word '' $HOME|x)"),
              ElementsAre(R"(C:\a b\net)", R"(say "x")", "one word", "", "$HOME|x"));
  EXPECT_EQ(words_of_command("a 'b").error().code, "command-quote-open");
  EXPECT_EQ(words_of_command(" \t").error().code, "command-empty");
}

TEST(RunProgram, TellsHowFarItIsByWhatItPrints) {
  std::vector<double> fractions;
  std::vector<std::string> stages;
  const Progress progress([&](double fraction, std::string_view stage) {
    fractions.push_back(fraction);
    stages.emplace_back(stage);
  });
  ASSERT_TRUE(run_in_shell(
      "printf 'Loading\\n'; sleep 0.3; printf ' 25%%|##  |\\r' >&2; sleep 0.3; printf 'at 87.5%%\\n'", progress));
  EXPECT_THAT(fractions, ElementsAre(0, 0.25, 0.875));
  EXPECT_THAT(stages, ElementsAre("Loading", "25%|##  |", "at 87.5%"));
}

TEST(RunProgram, SaysWhyItFailed) {
  const auto ended = run_in_shell("echo some; echo 'no GPU, and no weights' >&2; exit 7");
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, "program-failed");
  EXPECT_THAT(ended.error().message(), HasSubstr("7"));
  EXPECT_THAT(ended.error().message(), HasSubstr("no GPU, and no weights"));
  EXPECT_THAT(run_in_shell("kill -9 $$").error().message(), HasSubstr("signal 9"));
}

TEST(RunProgram, OfAProgramThatIsNotThereThatIsSaid) {
  const auto missing = run_program({"no-such-network", "-i", "x"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, "program-not-found");
  EXPECT_THAT(missing.error().message(), HasSubstr("no-such-network"));
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "not-executable", "text"));
  EXPECT_EQ(run_program({(folder.path() / "not-executable").string()}).error().code, "program-not-started");
}

// A megabyte without an end of line, and a program that prints nowhere and works on.
TEST(RunProgram, WaitsForItsEndWhateverItPrints) {
  EXPECT_TRUE(run_in_shell("head -c 1000000 /dev/zero | tr '\\0' x"));
  const TemporaryFolder folder;
  const auto file = folder.path() / "done";
  EXPECT_TRUE(run_in_shell("exec >&- 2>&-; sleep 0.5; touch '" + file.string() + "'"));
  EXPECT_TRUE(std::filesystem::exists(file));
}

// One child notes its own number and ignores the polite signal; it must be gone all the same.
TEST(RunProgram, CancelledItEndsWithAllThatItStarted) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "child";
  std::stop_source stop;
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  const auto began = std::chrono::steady_clock::now();
  const auto ended = run_in_shell(
      "(trap '' TERM; sh -c 'echo $PPID' > '" + file.string() + "'; echo started; while :; do sleep 0.1; done) & wait",
      progress);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, "cancelled");
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10));
  const pid_t child = std::stoi(read_text_file(file).value_or("0"));
  ASSERT_GT(child, 1);
  const auto gone = [&] {  // a zombie has no command line any more
    return read_text_file("/proc/" + std::to_string(child) + "/cmdline").value_or("").empty();
  };
  for (int n = 0; n < 100 && !gone(); ++n) ::usleep(20000);
  EXPECT_TRUE(gone());
}

}  // namespace
}  // namespace glisson
