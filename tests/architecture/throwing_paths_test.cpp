// Paths come from outside: a link that leads to itself or a disk that fails throws in each std::filesystem call that is
// given no std::error_code, and would end the program as a defect. Read from the sources themselves.

#include <gmock/gmock.h>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "support/folders.h"

namespace {

namespace fs = std::filesystem;

// The text of a call's last argument; `begin` is the place behind its parenthesis.
std::string last_argument(const std::string& text, std::size_t begin) {
  std::size_t last = begin, at = begin;
  for (int depth = 1; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (depth == 0) break;
    if (c == ',' && depth == 1) last = at + 1;
  }
  while (last < at && std::isspace(static_cast<unsigned char>(text[last])) != 0) ++last;
  return text.substr(last, at - last);
}

bool is_declared(const std::string& text, const std::string& type, const std::string& name) {
  return std::regex_search(text, std::regex(type + "&? [^;]*\\b" + name + "\\b"));
}

// Or what another call answered, which asks no disk.
bool takes_an_error_code(const std::string& text, const std::string& argument) {
  static const std::regex name("\\w+"), of_status(R"((std::)?(fs|filesystem)::(symlink_)?status\([\s\S]*)");
  if (std::regex_match(argument, of_status)) return true;
  if (!std::regex_match(argument, name)) return false;
  return is_declared(text, "error_code", argument) || is_declared(text, "file_status", argument);
}

// Each throwing call of a source.
std::vector<std::string> throwing_calls(const std::string& text) {
  static const std::regex call(
      R"(\b(fs|filesystem)::(exists|is_(regular_file|directory|symlink|empty|other|fifo|socket)|file_size|create_\w+|)"
      R"((weakly_)?canonical|absolute|relative|proximate|equivalent|remove|remove_all|rename|last_write_time|copy|)"
      R"(copy_file|copy_symlink|(current|temp_directory)_path|symlink_status|status|read_symlink|permissions|)"
      R"(hard_link_count|resize_file|space)\()");
  static const std::regex of_entry(
      R"((\.|->)(is_regular_file|is_directory|is_symlink|last_write_time|symlink_status|hard_link_count|file_size)\(\))");
  static const std::regex loop(R"(for \([^;{]*?:\s*(std::)?(fs|filesystem)::(recursive_)?directory_iterator)");
  std::vector<std::string> throwing;
  const std::sregex_iterator end;
  for (std::sregex_iterator found(text.begin(), text.end(), call); found != end; ++found) {
    const auto behind = static_cast<std::size_t>(found->position() + found->length());
    if (!takes_an_error_code(text, last_argument(text, behind))) throwing.push_back(found->str());
  }
  for (const std::regex& form : {of_entry, loop}) {
    for (std::sregex_iterator found(text.begin(), text.end(), form); found != end; ++found) {
      throwing.push_back(found->str());
    }
  }
  return throwing;
}

TEST(ThrowingPaths, TheThrowingFormsAreTold) {
  EXPECT_EQ(throwing_calls("if (fs::exists(folder / \"a\")) fs::remove(file);").size(), 2U);
  EXPECT_EQ(throwing_calls("if (entry->is_regular_file()) return entry.file_size();").size(), 2U);
  EXPECT_EQ(throwing_calls("for (const auto& entry : fs::directory_iterator(folder, problem)) {}").size(), 1U);
  EXPECT_TRUE(throwing_calls("std::error_code problem; fs::rename(a, b / name(c, d), problem);").empty());
  EXPECT_TRUE(throwing_calls("std::error_code e; return fs::is_symlink(fs::symlink_status(file, e));").empty());
}

TEST(ThrowingPaths, NoCallOnAPathThrows) {
  std::size_t read = 0;
  for (const char* top : {"core", "app", "widgets"}) {
    for (const auto& entry : fs::recursive_directory_iterator(glisson::test::source_folder() / top)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      ++read;
      if (text.find("filesystem") == std::string::npos && text.find("fs::") == std::string::npos) continue;
      EXPECT_THAT(throwing_calls(text), testing::IsEmpty())
          << entry.path() << ": give the call a std::error_code, or take contents_of(folder).";
    }
  }
  EXPECT_GT(read, 900U);
}

}  // namespace
