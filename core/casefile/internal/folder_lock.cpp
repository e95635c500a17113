#include "casefile/internal/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>

namespace glisson::casefile {

FolderLock::FolderLock(const std::filesystem::path& folder, Wait wait) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return;
  const int how = LOCK_EX | (wait == Wait::not_at_all ? LOCK_NB : 0);
  int outcome = 0;
  do outcome = ::flock(descriptor_, how);
  while (outcome != 0 && errno == EINTR);
  taken_ = outcome != 0 && errno == EWOULDBLOCK;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace glisson::casefile
