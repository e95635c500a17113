#pragma once
// What a writer works in until it is done: a hidden file or folder beside the target, locked as long as it lives.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "base/new_folder.h"
#include "base/result.h"

namespace glisson {

inline constexpr std::string_view part_prefix = ".part-";

// What the system says of one of its codes.
[[nodiscard]] std::string reason_of(int code);

// Every byte on the device: 0, or what the system says of it.
[[nodiscard]] int flushed(int descriptor);

// A file beside the target that this writer alone writes, known by a lock that ends with the process.
class Part {
 public:
  static Result<Part> begin(const std::filesystem::path& target);
  Part(Part&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)),
        path_(std::move(other.path_)),
        holds_old_(other.holds_old_),
        removes_(other.removes_) {}
  Part& operator=(Part&&) = delete;
  ~Part();

  // 0, or what the system says of it.
  [[nodiscard]] int write(std::string_view bytes) const;
  [[nodiscard]] int flush() const;
  [[nodiscard]] int put_in_place(const std::filesystem::path& target);
  [[nodiscard]] int exchange_with(const std::filesystem::path& target);
  // Nothing comes to the target in exchange for what is there.
  void remove_instead() { removes_ = true; }

 private:
  [[nodiscard]] int take_away(const std::filesystem::path& target);
  Part(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  int descriptor_ = -1;
  std::filesystem::path path_;  // empty once it stands in its place
  bool holds_old_ = false;      // what was at the target stands at the path
  bool removes_ = false;
};

}  // namespace glisson
