// Finding the voxels of NIfTI, NRRD and MetaImage files by their names and text headers.

#include "imaging/voxel_payload.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// The value of "key: value" or "key = value" in a text header, in lower case, empty if it is not there.
std::string header_value(const std::string& header, const std::string& key) {
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    const auto separator = line.find_first_of(":=");
    if (separator == std::string::npos) continue;
    std::string name = line.substr(0, separator);
    name.erase(name.find_last_not_of(" \t") + 1);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (name != key) continue;
    const auto begin = line.find_first_not_of(" \t", separator + 1);
    if (begin == std::string::npos) return "";
    return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }
  return "";
}

}  // namespace

std::string lower_case_name(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

VoxelPayload voxel_payload(const fs::path& file) {
  constexpr double deflate_limit = 1032;  // the format's own bound: 258 bytes by two bits
  const std::string name = lower_case_name(file);
  if (name.ends_with(".nii")) return {file, 1};
  if (name.ends_with(".nii.gz")) return {file, deflate_limit};

  constexpr std::size_t header_limit = 1 << 16;
  std::string header(header_limit, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(header.data(), static_cast<std::streamsize>(header.size()));
  header.resize(static_cast<std::size_t>(stream.gcount()));

  VoxelPayload payload{file, 1};
  std::string beside;
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) {
    const std::string encoding = header_value(header, "encoding");
    if (encoding == "gzip" || encoding == "gz") payload.most_bytes_per_byte = deflate_limit;
    if (encoding == "bzip2" || encoding == "bz2") payload.most_bytes_per_byte = 1 << 16;
    if (encoding == "ascii" || encoding == "text" || encoding == "txt") payload.most_bytes_per_byte = 4;
    beside = header_value(header, "data file");
    if (beside.empty()) beside = header_value(header, "datafile");
  } else {
    if (header_value(header, "compresseddata") == "True") payload.most_bytes_per_byte = deflate_limit;
    if (header_value(header, "binarydata") == "False") payload.most_bytes_per_byte = 4;
    beside = header_value(header, "elementdatafile");
    if (beside == "LOCAL" || beside == "Local" || beside == "local") beside.clear();
  }
  if (!beside.empty()) payload.file = file.parent_path() / beside;
  return payload;
}

}  // namespace glisson::imaging
