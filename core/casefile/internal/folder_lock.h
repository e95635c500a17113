#pragma once
// A folder that only one holder may change at a time, across threads and programs. It goes with its holder, also when
// that is killed.

#include <filesystem>

namespace glisson::casefile {

class FolderLock {
 public:
  enum class Wait { until_free, not_at_all };
  FolderLock(const std::filesystem::path& folder, Wait wait);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // Another holds it. Where the file system knows no locks, nobody ever does.
  [[nodiscard]] bool taken() const { return taken_; }

 private:
  int descriptor_ = -1;
  bool taken_ = false;
};

}  // namespace glisson::casefile
