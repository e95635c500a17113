// What the texts name is there: links lead somewhere, paths exist, quoted programs stand as they are built, and each
// room has its page.

#include <gmock/gmock.h>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/folders.h"

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

const fs::path root = glisson::test::source_folder();

Lines lines_of(const fs::path& file) {
  std::ifstream stream(file);
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Every text that a reader is led through; the manual has tests of its own.
std::vector<fs::path> texts() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(root))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  for (const char* folder : {"docs", "core", "widgets"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

// The lines outside fenced blocks: what stands inside is quoted from elsewhere.
Lines prose_of(const fs::path& file) {
  Lines prose;
  bool fenced = false;
  for (const std::string& line : lines_of(file)) {
    if (line.rfind("```", 0) == 0) {
      fenced = !fenced;
    } else if (!fenced && line.rfind("    ", 0) != 0) {
      prose.push_back(line);
    }
  }
  return prose;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) found.push_back((*at)[1]);
  return found;
}

// A heading's anchor, as GitHub makes it: lower case, spaces become hyphens, marks fall out.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool has_anchor(const fs::path& file, const std::string& anchor) {
  for (const std::string& line : prose_of(file)) {
    const std::size_t words = line.find_first_not_of('#');
    if (line.rfind('#', 0) == 0 && words != std::string::npos && anchor_of(line.substr(words + 1)) == anchor)
      return true;
  }
  return false;
}

TEST(Docs, LinksLeadSomewhere) {
  const std::regex link(R"(\]\(([^)\s]+)\))");
  int checked = 0;
  for (const fs::path& file : texts()) {
    for (const std::string& line : prose_of(file)) {
      for (const std::string& target : matches(line, link)) {
        if (target.find("://") != std::string::npos) continue;
        const std::size_t hash = target.find('#');
        const fs::path path = hash == 0 ? file : file.parent_path() / target.substr(0, hash);
        EXPECT_TRUE(fs::exists(path)) << file << " links to " << target;
        if (hash != std::string::npos && fs::exists(path)) {
          EXPECT_TRUE(has_anchor(path, target.substr(hash + 1))) << file << " links to " << target;
        }
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 30);
}

std::set<std::string> folders_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  return names;
}

// There as it is named, or with the ending left out ("casefile/evidence").
bool stands(const fs::path& path) {
  return fs::exists(path) || fs::exists(path.string() + ".h") || fs::exists(path.string() + ".cpp");
}

// `core/base/units.h`, `mechanics/data_driven.h`, `tests/benchmarks`: what begins with a folder of ours is a path.
TEST(Docs, NamedPathsExist) {
  const std::regex code("`([^`]+)`");
  const std::regex path("[a-z_]+(/[A-Za-z0-9_.,-]+)+/?");
  const std::set<std::string> tops = {"app",   "core",         "widgets",   "resources",
                                      "tests", "translations", "packaging", "docs"};
  const std::set<std::string> rooms = folders_in(root / "core");
  const std::regex placeholder("[A-Z]{2,}");
  int checked = 0;
  for (const fs::path& file : texts()) {
    if (file.filename() == "CHANGELOG.md") continue;  // names what was
    for (const std::string& line : prose_of(file)) {
      for (const std::string& named : matches(line, code)) {
        const std::string word = named.substr(0, named.find(' '));
        if (!std::regex_match(word, path)) continue;
        const std::string top = word.substr(0, word.find('/'));
        if (std::regex_search(word, placeholder) && !stands(root / word)) continue;
        if (tops.contains(top)) {
          EXPECT_TRUE(stands(root / word)) << file << " names " << word;
        } else if (rooms.contains(top)) {
          EXPECT_TRUE(stands(root / "core" / word) || stands(root / "widgets" / word)) << file << " names " << word;
        } else {
          continue;
        }
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 50);
}

// A room's page names its files from the room on, or by their bare names.
bool holds(const fs::path& room, const std::string& name) {
  if (name.find('/') != std::string::npos)
    return fs::exists(room / name) || fs::exists(room.parent_path() / name) || fs::exists(root / name);
  for (const auto& entry : fs::recursive_directory_iterator(room))
    if (entry.path().filename() == name) return true;
  return false;
}

TEST(Docs, EachRoomHasAPageThatNamesItsFiles) {
  const std::regex source("`([a-z_0-9/]+\\.(?:h|cpp))`");
  for (const std::string& room : folders_in(root / "core")) {
    const fs::path page = root / "core" / room / "README.md";
    ASSERT_TRUE(fs::exists(page)) << "core/" << room << " has no README.md";
    int named = 0;
    for (const std::string& line : prose_of(page)) {
      for (const std::string& name : matches(line, source)) {
        EXPECT_TRUE(holds(page.parent_path(), name)) << page << " names " << name;
        ++named;
      }
    }
    EXPECT_GT(named, 0) << page << " names no file";
    EXPECT_LE(lines_of(page).size(), 60U) << page << " is a page, not a book";
  }
}

std::vector<fs::path> sources() {
  std::vector<fs::path> found;
  for (const char* top : {"core", "app", "widgets"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") found.push_back(entry.path());
  return found;
}

bool any_ends_with(const std::vector<fs::path>& files, const std::string& name) {
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    return file.filename() == name || file.generic_string().ends_with("/" + name);
  });
}

// "(statics/validity.h)": what a comment sends its reader to is there.
TEST(Docs, FilesNamedInCommentsExist) {
  const std::set<std::string> of_others = {"nifti1.h", "qcustomplot.h"};
  const std::regex name("((?:[a-z_0-9]+/)*[a-z_0-9]+\\.(?:h|cpp))\\b");
  std::vector<fs::path> files = sources();
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) files.push_back(entry.path());
  int checked = 0;
  for (const fs::path& file : sources()) {
    for (const std::string& line : lines_of(file)) {
      const std::size_t comment = line.find("//");
      if (comment == std::string::npos || (comment > 0 && line[comment - 1] == ':')) continue;
      for (const std::string& named : matches(line.substr(comment), name)) {
        EXPECT_TRUE(of_others.contains(named) || any_ends_with(files, named)) << file << " names " << named;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 100);
}

// Every word of our sources.
std::set<std::string> words_in(const fs::path& folder) {
  std::set<std::string> words;
  std::string word;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    std::ifstream stream(entry.path());
    for (char c; stream.get(c);) {
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
        word += c;
      } else if (!word.empty()) {
        words.insert(std::exchange(word, ""));
      }
    }
  }
  return words;
}

bool any_holds(const std::set<std::string>& words, const std::string& part) {
  return std::any_of(words.begin(), words.end(),
                     [&](const auto& word) { return word.find(part) != std::string::npos; });
}

// test_mechanics --gtest_filter='DataDriven*' and bench_mechanics --benchmark_filter=SetUp/15: such tests are there.
TEST(Docs, NamedTestsAndBenchmarksExist) {
  const std::set<std::string> tests = words_in(root / "tests");
  const std::regex filter("--gtest_filter='([^']+)'");
  const std::regex suite("([A-Za-z0-9_]+)[^:]*");
  const std::regex benchmark("--benchmark_filter='?(\\w+)");
  int checked = 0;
  for (const fs::path& file : texts()) {
    for (const std::string& line : lines_of(file)) {
      std::vector<std::string> names = matches(line, benchmark);
      for (const std::string& filters : matches(line, filter))
        for (const std::string& name : matches(filters, suite)) names.push_back(name);
      for (const std::string& name : names) EXPECT_TRUE(any_holds(tests, name)) << file << " names " << name;
      checked += static_cast<int>(names.size());
    }
  }
  EXPECT_GT(checked, 20);
}

// A term of the glossary that is a type or function of ours is still called so.
TEST(Docs, TermsOfTheGlossaryStandInTheCode) {
  const std::regex code("`([A-Z][A-Za-z]*[a-z][A-Za-z]*)`");
  std::set<std::string> words = words_in(root / "core");
  words.merge(words_in(root / "widgets"));
  int checked = 0;
  for (const std::string& line : prose_of(root / "docs" / "glossary.md")) {
    for (const std::string& term : matches(line, code)) {
      EXPECT_TRUE(words.contains(term)) << "no " << term << " in the code";
      ++checked;
    }
  }
  EXPECT_GT(checked, 30);
}

// <!--quote:docs/examples/NAME.cpp--> stands before a fenced block whose lines follow each other in that file, all
// indented alike.
struct Quote {
  fs::path in, of;
  Lines lines;
};
std::vector<Quote> quotes() {
  const std::regex mark("<!--quote:(.+)-->");
  std::vector<Quote> found;
  for (const fs::path& file : texts()) {
    const Lines lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_match(lines[i], match, mark)) continue;
      Quote quote{file, root / match[1].str(), {}};
      for (i += 2; i < lines.size() && lines[i] != "```"; ++i) quote.lines.push_back(lines[i]);
      found.push_back(quote);
    }
  }
  return found;
}

bool stands_at(const Lines& quoted, const Lines& file, std::size_t start) {
  if (start + quoted.size() > file.size() || quoted.empty()) return false;
  if (file[start].size() < quoted[0].size()) return false;
  const std::string indent(file[start].size() - quoted[0].size(), ' ');
  for (std::size_t i = 0; i < quoted.size(); ++i)
    if (file[start + i] != (quoted[i].empty() ? "" : indent + quoted[i])) return false;
  return true;
}

TEST(Docs, QuotedProgramsStandAsTheyAre) {
  std::set<fs::path> quoted;
  for (const Quote& quote : quotes()) {
    const Lines file = lines_of(quote.of);
    bool found = false;
    for (std::size_t start = 0; start < file.size() && !found; ++start) found = stands_at(quote.lines, file, start);
    EXPECT_TRUE(found) << quote.in << " quotes " << quote.of << " otherwise than it is";
    quoted.insert(quote.of.filename());
  }
  for (const auto& entry : fs::directory_iterator(root / "docs" / "examples"))
    if (entry.path().extension() == ".cpp") {
      EXPECT_TRUE(quoted.contains(entry.path().filename())) << entry.path() << " is quoted nowhere";
    }
}

}  // namespace
