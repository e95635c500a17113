#include "base/internal/held_files.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>

namespace glisson {

bool locked(int descriptor) {
  int outcome = 0;
  do outcome = ::flock(descriptor, LOCK_EX | LOCK_NB);
  while (outcome != 0 && errno == EINTR);
  return outcome == 0 || errno != EWOULDBLOCK;
}

bool stands_at(int descriptor, const std::filesystem::path& path) {
  struct stat open_file {
  }, named_file{};
  return ::fstat(descriptor, &open_file) == 0 && ::lstat(path.c_str(), &named_file) == 0 &&
         open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

void remove_if_abandoned(int descriptor, const std::filesystem::path& path) {
  struct stat facts {};
  const bool mine = ::fstat(descriptor, &facts) == 0 && facts.st_uid == ::geteuid();
  if (!mine || ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || !stands_at(descriptor, path)) return;
  std::error_code problem;
  std::filesystem::remove_all(path, problem);
}

}  // namespace glisson
