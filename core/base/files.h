#pragma once
// Files written whole or not at all, and what identifies their content.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace glisson {

// Calls write(path) with a path beside `target` (same folder, same extension), and renames the outcome onto
// `target` when it succeeded. On failure `target` is as it was and the part-written file is gone.
Result<void> write_atomically(const std::filesystem::path& target,
                              const std::function<Result<void>(const std::filesystem::path& beside)>& write);
Result<void> write_text_file(const std::filesystem::path& target, std::string_view text);

// The whole file as text; refused above `limit_bytes` before memory is asked for.
Result<std::string> read_text_file(const std::filesystem::path& file,
                                   std::uint64_t limit_bytes = std::uint64_t{1} << 30);

// SHA-256 as 64 lower-case hexadecimal digits.
Result<std::string> sha256_of_file(const std::filesystem::path& file);
std::string sha256_of_text(std::string_view text);

// A new folder of its own under the system's place for temporary files, removed with all in it on destruction.
class TemporaryFolder {
 public:
  // Failure: "file-not-writable".
  static Result<TemporaryFolder> make();
  TemporaryFolder();  // for tests: one that cannot be made is a defect
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;  // empty once moved from
};

// The folder with the shipped resources (demo patient, colour maps). It is $GLISSON_RESOURCES if set, else beside the
// installed program, else in the source tree that this was built from.
Result<std::filesystem::path> resource_folder();

// The program's version, "0.1.0".
std::string version();

}  // namespace glisson
