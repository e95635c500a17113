// Every command that writes, on a disc on which one operation goes wrong (support/faulty_disc.h): no space, no
// permission, an interruption, half a write, a kill. What was there stays or what was asked for is there, whole; the
// program says which, and a case opens as it was or as it became.
//
// There are some thousands of stops; a run tries an even part of each command's, and a full disk in all of them. All,
// for hours:
//
//   GLISSON_ALL_FAULTS=1 build/release/bin/test_faults          (packaging/faults)
//   GLISSON_FAULTS_OF=export-nifti build/release/bin/test_faults

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "casefile/case.h"
#include "faults/writing_commands.h"
#include "support/faulty_disc.h"
#include "support/folders.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

// What lies in a folder: the bytes of each file by its name; a folder has none.
using Content = std::map<std::string, std::string>;
Content content_of(const fs::path& folder);

class Trial {
 public:
  Trial(const WritingCommand& command, const fs::path& prepared);

  // The run without a fault, which must do its work.
  void run_whole();
  [[nodiscard]] const std::vector<std::string>& stops() const { return whole_.stops; }
  void run_with(Fault fault, std::size_t at);
  void clean() const { fs::remove_all(room_); }

 private:
  DiscRun run_afresh(Fault fault, std::size_t at);
  void expect_said(const DiscRun& run) const;
  void expect_no_traces(const Content& now) const;
  void expect_cases_sound(Fault fault) const;
  void expect_old_or_new(const Content& now, bool killed) const;

  const WritingCommand& command_;
  fs::path prepared_, room_;
  Content before_, after_;
  DiscRun whole_;
};

// An even part of all (stop, fault), other ones for each command, and a full disk at the first write.
std::vector<std::pair<std::size_t, Fault>> chosen_of(const std::vector<std::string>& stops, const std::string& name) {
  std::vector<std::pair<std::size_t, Fault>> all, chosen;
  for (std::size_t at = 0; at < stops.size(); ++at) {
    for (const Fault fault : faults_of(stops[at])) all.emplace_back(at, fault);
  }
  if (std::getenv("GLISSON_ALL_FAULTS") != nullptr) return all;
  constexpr std::size_t tried = 2;
  const std::size_t first = std::hash<std::string>()(name) % 97;
  for (std::size_t n = 0; n < std::min(tried, all.size()); ++n) {
    // A stride that is prime to small numbers, so that all kinds of faults come.
    chosen.push_back(all[(first + n * (all.size() / tried | 1)) % all.size()]);
  }
  const auto write =
      std::find_if(stops.begin(), stops.end(), [](const std::string& stop) { return stop.starts_with("write"); });
  const std::pair full{static_cast<std::size_t>(write - stops.begin()), Fault::no_space};
  if (write != stops.end() && std::find(chosen.begin(), chosen.end(), full) == chosen.end()) chosen.push_back(full);
  return chosen;
}

TEST(EveryWriter, LeavesTheOldOrTheNewAndSaysWhich) {
  if (!can_watch_discs()) GTEST_SKIP() << "this system lets no program watch its child (seccomp user notification)";
  // In memory, where flushing costs nothing.
  if (fs::is_directory("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
  const TemporaryFolder rooms;
  const fs::path prepared = rooms.path() / "prepared";
  fs::create_directory(prepared);
  prepare_room(prepared);
  ASSERT_FALSE(HasFailure());
  const char* only = std::getenv("GLISSON_FAULTS_OF");
  std::size_t stops = 0, tried = 0;
  for (const WritingCommand& command : writing_commands()) {
    if (only != nullptr && command.name != only) continue;
    SCOPED_TRACE(command.name);
    Trial trial(command, prepared);
    trial.run_whole();
    stops += trial.stops().size();
    for (const auto& [at, fault] : chosen_of(trial.stops(), command.name)) {
      trial.run_with(fault, at);
      ++tried;
    }
    trial.clean();
  }
  EXPECT_GT(tried, 0u);
  fmt::print("{} stops in {} commands, {} faults tried\n", stops, writing_commands().size(), tried);
}

Trial::Trial(const WritingCommand& command, const fs::path& prepared)
    : command_(command), prepared_(prepared), room_(prepared.parent_path() / "room") {}

DiscRun Trial::run_afresh(Fault fault, std::size_t at) {
  fs::remove_all(room_);
  fs::copy(prepared_, room_, fs::copy_options::recursive);
  std::vector<std::string> words{(build_folder() / "bin" / "glisson-cli").string()};
  for (const std::string& word : command_.words) {
    const std::size_t mark = word.find('@');
    words.push_back(mark == std::string::npos ? word : word.substr(0, mark) + (room_ / word.substr(mark + 1)).string());
  }
  words.insert(words.end(), {"--quiet", "--threads", "1"});
  return run_on_faulty_disc(room_, words, fault, at);
}

void Trial::run_whole() {
  before_ = content_of(prepared_);
  whole_ = run_afresh(Fault::none, 0);
  after_ = content_of(room_);
  ASSERT_EQ(whole_.exit_code, 0) << whole_.err << whole_.out;
  EXPECT_GT(whole_.stops.size(), 0u) << "writes nothing";
  EXPECT_THAT(whole_.outside, testing::IsEmpty());
  expect_no_traces(after_);
}

void Trial::run_with(Fault fault, std::size_t at) {
  SCOPED_TRACE(fmt::format("{} at stop {}, {}", name_of(fault), at, stops()[at]));
  const DiscRun run = run_afresh(fault, at);
  const Content now = content_of(room_);
  if (fault == Fault::killed) {
    EXPECT_EQ(run.exit_code, 128 + 9);
    // Among the renames of files that belong together, in a folder that was there: the one moment in between.
    const bool in_between = stops()[at].starts_with("rename") && command_.replaces;
    expect_old_or_new(now, !in_between && !command_.resumes);
    expect_cases_sound(fault);
    return;
  }
  if (run.exit_code == 0) {
    // An interruption is tried again, and not everything is needed; but then all that was asked for is there.
    for (const auto& [name, bytes] : after_) EXPECT_TRUE(now.contains(name)) << name << " is missing, exit code 0";
  } else {
    expect_said(run);
    for (const auto& [name, bytes] : before_) {
      EXPECT_TRUE(now.contains(name) && now.at(name) == bytes) << name << " is not as it was, though refused";
    }
    for (const auto& [name, bytes] : now) {
      EXPECT_TRUE(bytes == "/" || before_.contains(name) || command_.resumes) << name << " is new, though refused";
    }
  }
  if (!stops()[at].starts_with("remove")) expect_no_traces(now);
  expect_old_or_new(now, false);
  expect_cases_sound(fault);
}

// One sentence that names the file and no defect. The NIfTI library has a line of its own of a file that it cannot
// open, whatever its level of messages; it comes before the sentence.
void Trial::expect_said(const DiscRun& run) const {
  std::string said = run.err;
  if (said.starts_with("** ERROR (nifti_image_write_hdr_img2): cannot open")) said.erase(0, said.find('\n') + 1);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_TRUE(said.starts_with("glisson-cli: ")) << run.err;
  EXPECT_THAT(said, testing::HasSubstr(room_.string())) << "names no file";
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << run.err;
}

bool is_trace(const std::string& name) {
  return ("/" + name).find("/.part-") != std::string::npos || ("/" + name).find("/.next-") != std::string::npos ||
         name.starts_with("tmp/");
}

void Trial::expect_no_traces(const Content& now) const {
  for (const auto& [name, bytes] : now) EXPECT_FALSE(is_trace(name)) << name << " was left";
}

// Dates and times differ between runs; cut files differ in what is compared here.
bool alike(const std::string& name, const std::string& one, const std::string& other) {
  if (one == other) return true;
  const std::string extension = fs::path(name).extension().string();
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  if (extension == ".json") return parse_json(one).has_value() && lines(one) == lines(other);
  if (extension == ".html") return lines(one) == lines(other) && one.ends_with("</html>\n");
  if (extension == ".csv") return lines(one) == lines(other) && one.ends_with("\n");
  if (extension == ".dcm") return one.size() == other.size();
  return false;
}

void Trial::expect_old_or_new(const Content& now, bool killed) const {
  std::set<std::string> old_ones, new_ones;
  for (const auto& [name, bytes] : now) {
    if (is_trace(name) || bytes == "/") continue;
    const bool old = before_.contains(name) && before_.at(name) == bytes;
    const bool whole = after_.contains(name) && alike(name, bytes, after_.at(name));
    EXPECT_TRUE(old || whole) << name << " is neither the old nor the new file";
    if (name.find(".glisson/") != std::string::npos) continue;  // judged as a case
    if (old && !whole) old_ones.insert(name);
    if (whole && !old) new_ones.insert(name);
  }
  if (!killed) return;
  for (const auto& [name, bytes] : after_) {
    if (bytes != "/" && name.find(".glisson/") == std::string::npos && !before_.contains(name) && !now.contains(name)) {
      old_ones.insert(name + " (absent)");
    }
  }
  EXPECT_TRUE(old_ones.empty() || new_ones.empty())
      << "between: old " << testing::PrintToString(old_ones) << ", new " << testing::PrintToString(new_ones);
}

// The entries with their content, after the case has been opened, which mends what a kill left.
std::map<std::string, std::string> entries_of(const fs::path& folder) {
  std::map<std::string, std::string> entries;
  const auto opened = casefile::Case::open(folder);
  EXPECT_TRUE(opened) << opened.error().message();
  if (!opened) return entries;
  for (const casefile::Entry& entry : opened->entries()) {
    entries[entry.id] = entry.sha256;
    EXPECT_EQ(sha256_of_file(folder / entry.file).value_or(""), entry.sha256) << entry.id << " is not what it was";
  }
  for (const auto& [name, bytes] : content_of(folder)) EXPECT_FALSE(is_trace(name)) << name << " stays after opening";
  return entries;
}

void Trial::expect_cases_sound(Fault fault) const {
  for (const auto& entry : fs::directory_iterator(room_)) {
    if (entry.path().extension() != ".glisson" || entry.path().filename().string().starts_with(".")) continue;
    const auto now = entries_of(entry.path());
    if (fault != Fault::killed) continue;
    const std::string record = entry.path().filename().string() + "/case.json";
    // As it was or as it became, by what is in it.
    const auto recorded = [&](const Content& content) {
      std::map<std::string, std::string> entries;
      const auto json = parse_json(content.contains(record) ? content.at(record) : "{}");
      for (const Json& one : json->value("entries", Json::array())) entries[one.at("id")] = one.at("sha256");
      return entries;
    };
    EXPECT_TRUE(now == recorded(before_) || now == recorded(after_)) << entry.path() << " is something in between";
  }
}

Content content_of(const fs::path& folder) {
  Content content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().string().substr(folder.string().size() + 1);
    if (entry.is_directory()) {
      if (name != "tmp" && name != "home") content[name] = "/";
    } else {
      content[name] = read_text_file(entry.path()).value_or("");
    }
  }
  return content;
}

}  // namespace
}  // namespace glisson::test
