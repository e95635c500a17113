#include "base/folder_contents.h"

#include <algorithm>
#include <system_error>

namespace glisson {
namespace fs = std::filesystem;

std::vector<fs::path> contents_of(const fs::path& folder) {
  std::vector<fs::path> contents;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
    contents.push_back(entry->path());
  }
  std::sort(contents.begin(), contents.end());
  return contents;
}

}  // namespace glisson
