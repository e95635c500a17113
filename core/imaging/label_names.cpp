// Names of labels: from the header of the map, else from a description beside it.

#include "imaging/label_names.h"

#include <zlib.h>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <sstream>
#include <vector>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/text.h"
#include "imaging/internal/volume_header.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

using Names = std::map<int, std::string>;

constexpr std::size_t maximum_names_bytes = std::size_t{1} << 20;

Names slicer_segments(const fs::path& file);
Names nifti_table(const fs::path& file);
Names described_beside(const fs::path& file);

}  // namespace

LabelNames label_names(const fs::path& label_map) {
  const std::string name = lower_case_name(label_map);
  LabelNames names;
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) names = {slicer_segments(label_map), NamedBy::slicer_fields};
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) names = {nifti_table(label_map), NamedBy::nifti_table};
  if (names.name_of.empty()) names = {described_beside(label_map), NamedBy::description_file};
  if (names.name_of.empty()) names.by = NamedBy::nothing;
  return names;
}

std::optional<std::map<int, std::string>> label_descriptions(const std::string& text) {
  Names names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string first;
    if (!(fields >> first) || first.front() == '#') continue;
    int colour = 0;
    const auto value = read_whole_number<int>(first);
    if (!value || *value < 0 || *value > 65535) return std::nullopt;
    for (int channel = 0; channel < 3; ++channel) {
      if (!(fields >> colour) || colour < 0 || colour > 255) return std::nullopt;
    }
    double alpha = 0;
    int visible = 0, meshed = 0;
    if (!(fields >> alpha >> visible >> meshed)) return std::nullopt;
    const std::size_t opens = line.find('"'), closes = line.rfind('"');
    if (opens == std::string::npos || closes == opens) return std::nullopt;
    if (*value > 0) names[*value] = line.substr(opens + 1, closes - opens - 1);
  }
  return names.empty() ? std::nullopt : std::optional(std::move(names));
}

namespace {

// The beginning of a file, unpacked where it is packed.
std::string unpacked_beginning(const fs::path& file, std::size_t bytes) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> opened(gzopen(file.c_str(), "rb"), gzclose);
  if (!opened) return {};
  std::string text(bytes, '\0');
  const int read = gzread(opened.get(), text.data(), static_cast<unsigned>(bytes));
  text.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
  return text;
}

std::optional<int> label_value(const std::string& text) {
  int value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || value < 1 || value > 65535) return std::nullopt;
  return value;
}

// The header of an NRRD ends with an empty line; "key:=value" stands on lines of their own.
Names slicer_segments(const fs::path& file) {
  std::map<std::string, std::string> name_of, value_of;  // by the segment's number
  std::istringstream header(unpacked_beginning(file, maximum_names_bytes));
  for (std::string line; std::getline(header, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) break;
    const std::size_t assigns = line.find(":="), parts = line.find('_');
    if (!line.starts_with("Segment") || assigns == std::string::npos || parts > assigns) continue;
    const std::string segment = line.substr(7, parts - 7), key = line.substr(parts + 1, assigns - parts - 1);
    if (key == "Name") name_of[segment] = line.substr(assigns + 2);
    if (key == "LabelValue") value_of[segment] = line.substr(assigns + 2);
  }
  Names names;
  for (const auto& [segment, name] : name_of) {
    const auto value = value_of.contains(segment) ? label_value(value_of[segment]) : std::nullopt;
    if (value && !name.empty()) names[*value] = name;
  }
  return names;
}

// NIfTI-1: a header of 348 bytes, 4 that say whether extensions follow, and those up to where the voxels begin.
// https://nifti.nimh.nih.gov/nifti-1/documentation/nifti1fields
Names nifti_table(const fs::path& file) {
  constexpr std::size_t header_bytes = 352, offset_at = 108;
  const std::string header = unpacked_beginning(file, header_bytes);
  std::int32_t size = 0;
  float voxels_at = 0;
  if (header.size() < header_bytes || header[348] == 0) return {};
  std::memcpy(&size, header.data(), sizeof size);
  std::memcpy(&voxels_at, header.data() + offset_at, sizeof voxels_at);
  if (size != 348 || !(voxels_at > header_bytes)) return {};  // the bytes of another machine name nothing
  const auto bytes = static_cast<std::size_t>(std::min(voxels_at, static_cast<float>(maximum_names_bytes)));
  const std::string extension = unpacked_beginning(file, bytes).substr(header_bytes);

  Names names;
  for (std::size_t at = extension.find("<Label "); at != std::string::npos; at = extension.find("<Label ", at + 1)) {
    const std::size_t ends = extension.find("</Label>", at), key = extension.find("Key=\"", at);
    const std::size_t text = extension.find("<![CDATA[", at);
    if (ends == std::string::npos || key > ends || text > ends) continue;
    const std::size_t begins = text + 9, closes = extension.find("]]>", begins);
    const auto value = label_value(extension.substr(key + 5, 6));
    if (value && closes < ends) names[*value] = extension.substr(begins, closes - begins);
  }
  return names;
}

// One of the map's own name, else the only one of the folder.
Names described_beside(const fs::path& file) {
  constexpr std::uint64_t maximum_bytes = std::uint64_t{1} << 18;
  const std::string own = file.filename().string().substr(0, file.filename().string().find('.'));
  std::vector<Names> found;
  for (const fs::path& beside : contents_of(file.parent_path())) {
    const std::string type = beside.extension().string();
    if (type != ".txt" && type != ".label") continue;
    const auto text = read_text_file(beside, maximum_bytes);
    auto names = text ? label_descriptions(*text) : std::nullopt;
    if (!names) continue;
    if (beside.stem() == own) return *std::move(names);
    found.push_back(*std::move(names));
  }
  return found.size() == 1 ? found.front() : Names{};
}

}  // namespace
}  // namespace glisson::imaging
