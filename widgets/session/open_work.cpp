#include "widgets/session/open_work.h"

#include <unistd.h>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <fstream>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/json.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t maximum_work_bytes = 1 << 16;

fs::path file_of(const fs::path& folder, long process) { return folder / (std::to_string(process) + ".json"); }

// Killed, and its parent has not asked after it yet: the system still knows its number.
bool only_its_number_is_left(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string state;
  std::getline(file, state);  // "4711 (glisson) Z 1 ..."
  const std::size_t name_ends = state.rfind(')');
  return name_ends != std::string::npos && state.compare(name_ends, 3, ") Z") == 0;
}

bool runs(long process) {
  const bool known = kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
  return known && !only_its_number_is_left(process);
}

Json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json json_of(const OpenWork& work) {
  Json json{{"case", work.case_folder.string()}, {"workspace", work.workspace}};
  if (work.tool) {
    json["tool"] = {{"center_mm", json_of(work.tool->center_mm)},
                    {"radius_mm", work.tool->radius_mm},
                    {"force_N", work.tool->force_N},
                    {"direction", json_of(work.tool->direction)}};
  }
  return json;
}

std::optional<OpenWork> read_work(const fs::path& file) {
  const auto text = read_text_file(file, maximum_work_bytes);
  if (!text) return std::nullopt;
  try {
    const Json json = Json::parse(*text);
    OpenWork work;
    work.case_folder = json.at("case").get<std::string>();
    work.workspace = json.at("workspace").get<std::string>();
    if (json.contains("tool")) {
      const Json& tool = json.at("tool");
      work.tool = {vector_of(tool.at("center_mm")), tool.at("radius_mm").get<double>(),
                   tool.at("force_N").get<double>(), vector_of(tool.at("direction"))};
    }
    return work;
  } catch (const std::exception&) {
    return std::nullopt;  // where one was is not worth a question when it cannot be read
  }
}

}  // namespace

OpenWorkFile::OpenWorkFile(fs::path folder) : folder_(std::move(folder)) {
  std::error_code problem;
  fs::create_directories(folder_, problem);
}

OpenWorkFile::~OpenWorkFile() { forget(); }

Result<void> OpenWorkFile::keep(const OpenWork& work) {
  return write_text_file(file_of(folder_, getpid()), json_of(work).dump(1));
}

void OpenWorkFile::forget() {
  std::error_code problem;
  fs::remove(file_of(folder_, getpid()), problem);
}

std::optional<OpenWork> OpenWorkFile::take_lost() {
  std::vector<std::pair<fs::file_time_type, fs::path>> left;
  std::error_code problem;
  for (const fs::path& file : contents_of(folder_)) {
    const std::string stem = file.stem().string();
    long process = 0;
    const auto [end, wrong] = std::from_chars(stem.data(), stem.data() + stem.size(), process);
    if (wrong != std::errc{} || end != stem.data() + stem.size() || process <= 0) continue;
    if (!runs(process)) left.emplace_back(fs::last_write_time(file, problem), file);
  }
  std::sort(left.rbegin(), left.rend());
  std::optional<OpenWork> lost;
  for (const auto& [when, file] : left) {
    if (!lost) {
      lost = read_work(file);
      if (lost && !fs::exists(lost->case_folder / "case.json", problem)) lost.reset();
    }
    fs::remove(file, problem);
  }
  return lost;
}

}  // namespace glisson::widgets
