#pragma once
// The one way in which bytes reach a disk: written beside, every byte of them or an error, flushed to the device,
// renamed.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/files.h"
#include "base/result.h"

namespace glisson {

// Writes `bytes` as the whole of `target`, whose folders are made. On failure `target` is as it was and the error says
// what the system said (no space, no permission, ...). A writer that is killed leaves a hidden file beside the target,
// `.part-NAME`; the next program that writes into that folder removes it.
Result<void> write_file(const std::filesystem::path& target, std::string_view bytes);

// The same with the content of another file.
Result<void> write_copy(const std::filesystem::path& source, const std::filesystem::path& target);

// Calls write(). The files that it writes on this thread all take their places together when it succeeds, and none of
// them where it fails. A folder that was not there takes its place as a whole, by one rename. In a folder that was
// there, a kill among the renames, which follow each other at once, is the only thing in between. Inside, no file may
// be read back. A call inside of another joins it.
Result<void> write_together(const std::function<Result<void>()>& write);

// Removes the file, as one of those that are written together where that is under way.
Result<void> remove_file(const std::filesystem::path& file);

// The two files take each other's places, or the one that is there the other's. 0, or what the system says of it. On
// file systems that know no exchange the first takes the second's place, which is then gone.
[[nodiscard]] int exchange_files(const std::filesystem::path& one, const std::filesystem::path& other);

// The error of a file that could not be written.
[[nodiscard]] Failure file_not_writable(const std::filesystem::path& file, const std::string& reason);

// Removes what killed writers left in `folder` and below; what a living one is writing stays. Links are not followed.
void remove_abandoned_parts(const std::filesystem::path& folder);

// A file in memory under a name with an ending, for libraries that write to names and do not notice a full disk.
class MemoryFile {
 public:
  // `named_like`: the name that the file ends like, since writers choose the format by it.
  [[nodiscard]] static Result<MemoryFile> create(const std::filesystem::path& named_like);
  MemoryFile(MemoryFile&& other) noexcept;
  MemoryFile& operator=(MemoryFile&&) = delete;
  ~MemoryFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // What stands in it, as the whole of `target`; refused where nothing does.
  [[nodiscard]] Result<void> write_to(const std::filesystem::path& target) const;

 private:
  MemoryFile(TemporaryFolder folder, int descriptor, std::filesystem::path path);
  TemporaryFolder folder_;  // of the name
  int descriptor_;
  std::filesystem::path path_;
};

}  // namespace glisson
