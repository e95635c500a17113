// Temporary folders. A program that is killed leaves its own behind; the next program that asks for one removes them.

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/internal/abandoned_folders.h"
#include "base/internal/held_files.h"
#include "base/write_file.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

const std::string prefix = "glisson.";
const std::string drawn = "XXXXXX";  // what mkdtemp replaces

// The locks on this process's folders, by which others see that it lives.
struct Locks {
  std::mutex guard;
  std::map<fs::path, int> descriptors;
};

// Never destroyed: folders may be removed as late as the program ends.
Locks& locks() {
  static Locks* const kept = new Locks;
  return *kept;
}

int opened_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
}

}  // namespace

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code problem;
  const fs::path place = fs::temp_directory_path(problem);
  if (problem) return file_not_writable(place, problem.message());
  static std::once_flag once;
  std::call_once(once, [&] { remove_abandoned_folders(place); });
  for (;;) {
    std::string path = (place / (prefix + drawn)).string();
    if (::mkdtemp(path.data()) == nullptr) return file_not_writable(path, std::generic_category().message(errno));
    const int descriptor = opened_folder(path);
    if (descriptor >= 0 && locked(descriptor) && stands_at(descriptor, path)) {
      const std::lock_guard lock(locks().guard);
      locks().descriptors[path] = descriptor;
      return TemporaryFolder(path);
    }
    const int code = errno;
    if (descriptor < 0 && code != ENOENT) {
      ::rmdir(path.c_str());
      return file_not_writable(path, std::generic_category().message(code));
    }
    // Another program took it for abandoned before it was locked.
    if (descriptor >= 0) ::close(descriptor);
  }
}

TemporaryFolder::TemporaryFolder() : TemporaryFolder(make().value()) {}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  const std::lock_guard lock(locks().guard);
  const auto held = locks().descriptors.find(path_);
  if (held == locks().descriptors.end()) return;
  ::close(held->second);
  locks().descriptors.erase(held);
}

void remove_abandoned_folders(const fs::path& place) {
  for (const fs::path& folder : contents_of(place)) {
    const std::string name = folder.filename().string();
    if (name.size() != prefix.size() + drawn.size() || !name.starts_with(prefix)) continue;
    const int descriptor = opened_folder(folder);
    if (descriptor < 0) continue;
    remove_if_abandoned(descriptor, folder);
    ::close(descriptor);
  }
}

}  // namespace glisson
