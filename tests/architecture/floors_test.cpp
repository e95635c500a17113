// The folders are the architecture: a room includes only rooms on lower floors, third-party types stay inside the
// rooms that own them, as the table of ARCHITECTURE.md says, and Qt stays above the core. Read from the includes
// themselves. Tests stay apart from each other too: each in a temporary folder of its own.

#include <gmock/gmock.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/folders.h"

namespace {

namespace fs = std::filesystem;

// Rooms with folders inside: a folder includes only those that stand before it. What lies in no folder is "", last.
const std::map<std::string, std::vector<std::string>> folders_of = {
    {"mechanics",
     {"materials", "scenario", "elements", "solvers", "potentials", "statics", "cutting", "contact", "dynamics",
      "meshfree", ""}},
    {"closedloop",
     {"experiment", "inference", "palpation", "guidance", "material", "hardware", "fullfield", "waves", ""}},
    {"studies", {"demo", "dissertation", "gate", "review"}},
};

// How the headers of each third party are named.
const std::map<std::string, std::regex> headers_of = {
    {"Qt", std::regex("Q[A-Z].*|Qt[A-Z].*")},
    {"QCustomPlot", std::regex("qcustomplot\\.h")},
    {"VTK", std::regex("vtk.*")},
    {"ITK", std::regex("itk.*")},
    {"DCMTK", std::regex("dcmtk/.*")},
    {"GDCM", std::regex("gdcm.*")},
    {"CGAL", std::regex("CGAL/.*")},
    {"OpenCV", std::regex("opencv.*")},
    {"CHOLMOD", std::regex("cholmod.*|suitesparse/.*|Eigen/CholmodSupport")},
    {"FFTW", std::regex("fftw3\\.h")},
    {"spdlog", std::regex("spdlog/.*")},
    {"Ceres", std::regex("ceres/.*|glog/.*")},
    {"Boost", std::regex("boost/.*")},
    {"CLI11", std::regex("CLI/.*")},
    {"pybind11", std::regex("pybind11/.*|Python\\.h")},
    {"Highway", std::regex("hwy/.*")},
    {"TBB", std::regex("(oneapi/)?tbb/.*")},
    {"OpenSSL", std::regex("openssl/.*")},
    {"OpenGL", std::regex("GL/.*|EGL/.*")},
    {"libpng", std::regex("png\\.h")},
    {"nanoflann", std::regex("nanoflann\\.hpp")},
    {"nlohmann::json", std::regex("nlohmann/.*")},
    {"zlib", std::regex("zlib\\.h")},
    {"OpenCL", std::regex("CL/.*")},
};
const std::set<std::string> without_headers = {"LAPACK"};  // called by its symbols

// A room as ARCHITECTURE.md's table has it: its floor, and the third parties that its .cpp files may use.
struct Room {
  int floor = 0;
  std::set<std::string> third_parties;
};

// "| 3 | meshing | what it is for | CGAL (one file), VTK (one file) |"
std::map<std::string, Room> rooms_of_the_table() {
  const std::regex row(R"(\| (\d+) \| (?:app/)?(\w+) \| .* \|\s*(.*)\|)");
  const std::regex party(R"(([\w:]+)( \([^)]*\))?,? *)");
  std::map<std::string, Room> rooms;
  std::ifstream page(glisson::test::source_folder() / "ARCHITECTURE.md");
  for (std::string line; std::getline(page, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    Room& room = rooms[match[2]];
    room.floor = std::stoi(match[1]);
    const std::string parties = match[3];
    for (std::sregex_iterator at(parties.begin(), parties.end(), party), end; at != end; ++at)
      room.third_parties.insert((*at)[1]);
  }
  return rooms;
}
const std::map<std::string, Room> rooms = rooms_of_the_table();

const std::set<std::string> json_headers = {"base/json.h", "base/json_reading.h", "base/json_value.h",
                                            "base/json_forward.h"};
const std::regex allowed_in_any_public_header("Eigen/.*|tl/expected\\.hpp|[a-z_]+|[a-z_]+\\.h");

struct Include {
  fs::path file;
  std::string room;
  std::string header;
  enum class Form { quoted, angled } form;
};

std::string room_of(const fs::path& relative) {
  auto part = relative.begin();
  if (*part == "widgets") return "widgets";
  return (++part)->string();  // core/<room>/... and app/<room>/...
}

std::vector<Include> all_includes() {
  const fs::path root = glisson::test::source_folder();
  const std::regex pattern("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::vector<Include> includes;
  for (const char* top : {"core", "app", "widgets"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const fs::path relative = entry.path().lexically_relative(root);
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, pattern)) continue;
        includes.push_back(
            {relative, room_of(relative), match[2], match[1] == "<" ? Include::Form::angled : Include::Form::quoted});
      }
    }
  }
  return includes;
}

TEST(Floors, TheSourcesAndTheTableAreFound) {
  EXPECT_GT(all_includes().size(), 20u);
  EXPECT_GT(rooms.size(), 20u);
}

TEST(Floors, ARoomIncludesOnlyRoomsBelowIt) {
  for (const Include& include : all_includes()) {
    const std::string target = include.header.substr(0, include.header.find('/'));
    if (include.form == Include::Form::angled || include.header.find('/') == std::string::npos ||
        target == include.room)
      continue;
    ASSERT_TRUE(rooms.contains(include.room)) << include.file << " is in a room that has no floor";
    ASSERT_TRUE(rooms.contains(target)) << include.file << " includes \"" << include.header << "\", which is no room";
    EXPECT_LT(rooms.at(target).floor, rooms.at(include.room).floor)
        << include.file << " includes \"" << include.header << "\"";
  }
}

// "room/folder/internal/x.h" -> "folder"; "" for what lies in no folder.
std::string folder_in_room(const std::string& path_from_room) {
  const std::string rest = path_from_room.substr(path_from_room.find('/') + 1);
  const std::string first = rest.substr(0, rest.find('/'));
  return first == rest || first == "internal" ? std::string() : first;
}

TEST(Floors, AFolderInARoomIncludesOnlyThoseBeforeIt) {
  std::size_t seen = 0;
  for (const Include& include : all_includes()) {
    const auto folders = folders_of.find(include.room);
    if (folders == folders_of.end() || include.form == Include::Form::angled ||
        include.header.rfind(include.room + "/", 0) != 0)
      continue;
    const auto place = [&](const std::string& path) {
      return std::find(folders->second.begin(), folders->second.end(), folder_in_room(path));
    };
    const auto from = place(include.file.lexically_relative("core").generic_string());
    const auto to = place(include.header);
    ASSERT_NE(from, folders->second.end()) << include.file << " is in a folder that the table lacks";
    ASSERT_NE(to, folders->second.end()) << include.header << " is in a folder that the table lacks";
    EXPECT_LE(to - from, 0) << include.file << " includes \"" << include.header << "\"";
    ++seen;
  }
  EXPECT_GT(seen, 300u);
}

TEST(Floors, InternalHeadersStayInTheirRoom) {
  for (const Include& include : all_includes()) {
    if (include.form == Include::Form::angled || include.header.find("/internal/") == std::string::npos) continue;
    EXPECT_EQ(include.header.substr(0, include.header.find('/')), include.room)
        << include.file << " includes " << include.header;
  }
}

// "Inside of this room" in a header that any room could include would be a wish, however it is worded.
TEST(Floors, WhatIsInsideOfARoomLiesInAnInternalFolder) {
  const fs::path core = glisson::test::source_folder() / "core";
  const std::regex claim(R"((inside( of)?|within)\s+(//\s*)?(of\s+)?(this|the)\s+room)", std::regex::icase);
  for (const auto& entry : fs::recursive_directory_iterator(core)) {
    if (entry.path().extension() != ".h") continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!std::regex_search(text, claim)) continue;
    EXPECT_EQ(entry.path().parent_path().filename(), "internal") << entry.path();
  }
}

TEST(Floors, EachRoomUsesTheThirdPartiesThatTheTableGivesIt) {
  std::map<std::string, std::set<std::string>> used;
  for (const Include& include : all_includes())
    for (const auto& [name, header] : headers_of)
      if (include.form == Include::Form::angled && std::regex_match(include.header, header)) {
        EXPECT_TRUE(rooms.at(include.room).third_parties.contains(name)) << include.file << " uses " << name;
        used[include.room].insert(name);
      }
  for (const auto& [name, room] : rooms)
    for (const std::string& party : room.third_parties)
      EXPECT_TRUE(used[name].contains(party) || without_headers.contains(party))
          << "ARCHITECTURE.md gives " << party << " to " << name << ", which includes nothing of it.";
}

TEST(Floors, EveryLibraryIsKnown) {
  const std::regex anywhere("[a-z_]+|[a-z_]+\\.h|sys/.*|Eigen/.*|tl/expected\\.hpp|fmt/.*|sanitizer/.*");
  for (const Include& include : all_includes()) {
    const bool known = include.form == Include::Form::quoted || std::regex_match(include.header, anywhere) ||
                       std::any_of(headers_of.begin(), headers_of.end(),
                                   [&](const auto& party) { return std::regex_match(include.header, party.second); });
    EXPECT_TRUE(known) << include.file << " uses <" << include.header << ">, a library that no room has.";
  }
}

// A header that other rooms include shows only the standard library, Eigen and tl::expected; base/json.h is the stated
// exception, for .cpp files, and base/json_forward.h, a name without the type behind it, for headers. A header that
// shows more is its room's own business and is included nowhere else.
TEST(Floors, HeadersThatShowThirdPartyTypesStayInTheirRoom) {
  const std::vector<Include> includes = all_includes();
  std::map<std::string, std::string> showing;  // "room/header.h" -> what it shows
  for (const Include& include : includes) {
    if (*include.file.begin() != "core" || include.file.extension() != ".h") continue;
    const bool shows = include.form == Include::Form::angled
                           ? !std::regex_match(include.header, allowed_in_any_public_header)
                           : include.header == "base/json.h";
    if (shows) showing[include.file.lexically_relative("core").generic_string()] = include.header;
  }
  for (const Include& include : includes) {
    const auto found = showing.find(include.header);
    if (include.form == Include::Form::angled || found == showing.end()) continue;
    if (json_headers.contains(include.header)) continue;
    EXPECT_EQ(include.header.substr(0, include.header.find('/')), include.room)
        << include.file << " includes " << include.header << ", which shows <" << found->second << ">";
  }
}

// Tests run beside each other: two with a path in common delete each other's files, once in a hundred runs.
TEST(Tests, KeepTheirFilesInFoldersOfTheirOwn) {
  const std::regex shared(R"(TempDir\(\)|temp_directory_path|"/tmp[/"])");
  std::size_t read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(glisson::test::source_folder() / "tests")) {
    const fs::path extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".h") continue;
    if (entry.path().filename() == fs::path(__FILE__).filename()) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_FALSE(std::regex_search(text, shared)) << entry.path() << ": TemporaryFolder gives a folder of its own.";
    ++read;
  }
  EXPECT_GT(read, 300U);
}

}  // namespace
