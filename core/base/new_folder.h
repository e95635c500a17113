#pragma once
// A folder that appears as a whole: filled beside its place and renamed once.

#include <filesystem>
#include <optional>
#include <utility>

#include "base/result.h"

namespace glisson {

// Beside its place it is called `.part-NAME`, and a lock says that its maker lives. What a killed one left goes when
// somebody next begins one there. Without put_in_place nothing stays.
class NewFolder {
 public:
  // The folder above has to be there. Failure: "file-not-writable".
  static Result<NewFolder> begin(const std::filesystem::path& target);
  NewFolder(NewFolder&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)),
        target_(std::move(other.target_)),
        path_(std::move(other.path_)) {}
  NewFolder& operator=(NewFolder&&) = delete;
  ~NewFolder();

  [[nodiscard]] const std::filesystem::path& target() const { return target_; }
  // Where it is filled.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Where what is to lie at `place`, below the target, is written until then; nothing for any other place.
  [[nodiscard]] std::optional<std::filesystem::path> beside(const std::filesystem::path& place) const;
  // 0, or what the system says of it: the target must not be there.
  [[nodiscard]] int put_in_place();

 private:
  NewFolder(int descriptor, std::filesystem::path target, std::filesystem::path path)
      : descriptor_(descriptor), target_(std::move(target)), path_(std::move(path)) {}
  int descriptor_ = -1;
  std::filesystem::path target_, path_;  // the path is empty once it stands in its place
};

}  // namespace glisson
