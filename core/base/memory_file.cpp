#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/internal/parts.h"
#include "base/write_file.h"

namespace glisson {

namespace fs = std::filesystem;

Result<MemoryFile> MemoryFile::create(const fs::path& named_like) {
  auto folder = TemporaryFolder::make();
  if (!folder) return failure(std::move(folder.error()));
  const int descriptor = ::memfd_create("glisson", MFD_CLOEXEC);
  if (descriptor < 0) return file_not_writable(named_like, reason_of(errno));
  // Endings are short; the rest of the name says nothing to a writer.
  const std::string name = named_like.filename().string();
  fs::path path = folder->path() / ("file" + name.substr(name.size() - std::min<std::size_t>(name.size(), 12)));
  MemoryFile made(std::move(*folder), descriptor, std::move(path));
  std::error_code problem;
  fs::create_symlink("/proc/self/fd/" + std::to_string(descriptor), made.path_, problem);
  if (problem) return file_not_writable(made.path_, problem.message());
  return made;
}

MemoryFile::MemoryFile(TemporaryFolder folder, int descriptor, fs::path path)
    : folder_(std::move(folder)), descriptor_(descriptor), path_(std::move(path)) {}

MemoryFile::MemoryFile(MemoryFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)) {}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> MemoryFile::write_to(const fs::path& target) const {
  struct stat facts {};
  if (::fstat(descriptor_, &facts) != 0) return file_not_writable(target, reason_of(errno));
  const auto size = static_cast<std::size_t>(facts.st_size);
  // No format is empty: a library that could not open the file did not say so.
  if (size == 0) return file_not_writable(target, GLISSON_TEXT("nothing was written into it"));
  // A limit on the size of files (ulimit -f) cuts those in memory too, and a library did not notice.
  rlimit longest{};
  if (::getrlimit(RLIMIT_FSIZE, &longest) == 0 && size >= longest.rlim_cur) {
    return file_not_writable(target, reason_of(EFBIG));
  }
  void* bytes = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, descriptor_, 0);
  if (bytes == MAP_FAILED) return file_not_writable(target, reason_of(errno));
  auto written = write_file(target, {static_cast<const char*>(bytes), size});
  ::munmap(bytes, size);
  return written;
}

}  // namespace glisson
