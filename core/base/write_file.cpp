#include "base/write_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/internal/held_files.h"
#include "base/internal/parts.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

// The files of a write_together under way in this thread.
struct Together {
  std::vector<NewFolder> folders;
  std::vector<std::pair<Part, fs::path>> written;
};
thread_local Together* together = nullptr;

// `at_once`: or kept as a part of what is written together.
Result<void> write_bytes(const fs::path& target, std::string_view bytes, bool at_once);
Result<std::optional<fs::path>> place_in_new_folder(Together& files, const fs::path& target);
Result<void> put_all_in_place(Together& files);
void flush_folder_of(const fs::path& target);

}  // namespace

Result<void> write_file(const fs::path& target, std::string_view bytes) {
  if (together == nullptr) return write_bytes(target, bytes, true);
  auto beside = place_in_new_folder(*together, target);
  if (!beside) return failure(std::move(beside.error()));
  return *beside ? write_bytes(**beside, bytes, true) : write_bytes(target, bytes, false);
}

Result<void> remove_file(const fs::path& file) {
  if (together == nullptr) return write_together([&] { return remove_file(file); });
  auto part = Part::begin(file);
  if (!part) return failure(std::move(part.error()));
  part->remove_instead();
  together->written.emplace_back(std::move(*part), file);
  return {};
}

Result<void> write_copy(const fs::path& source, const fs::path& target) {
  return read_text_file(source).and_then([&](const std::string& bytes) { return write_file(target, bytes); });
}

Result<void> write_together(const std::function<Result<void>()>& write) {
  if (together != nullptr) return write();
  Together files;
  together = &files;
  Result<void> outcome;
  try {
    outcome = write();
  } catch (...) {
    together = nullptr;
    throw;
  }
  together = nullptr;
  return outcome ? put_all_in_place(files) : outcome;
}

int exchange_files(const fs::path& one, const fs::path& other) {
  if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0) return 0;
  const bool by_renaming = errno == ENOENT || errno == EINVAL || errno == ENOSYS;
  if (!by_renaming) return errno;
  std::error_code problem;
  const bool forwards = fs::exists(fs::symlink_status(one, problem));
  return ::rename((forwards ? one : other).c_str(), (forwards ? other : one).c_str()) == 0 ? 0 : errno;
}

Result<void> write_text_file(const fs::path& target, std::string_view text) { return write_file(target, text); }

Result<void> write_atomically(const fs::path& target, const std::function<Result<void>(const fs::path&)>& write) {
  return MemoryFile::create(target).and_then(
      [&](const MemoryFile& memory) { return write(memory.path()).and_then([&] { return memory.write_to(target); }); });
}

Failure file_not_writable(const fs::path& file, const std::string& reason) {
  return failure(Error{"file-not-writable",
                       GLISSON_TEXT("{0} cannot be written: {1}."),
                       {file.string(), reason},
                       GLISSON_TEXT("Check the folder, your rights there and the free space."),
                       file});
}

void remove_abandoned_parts(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code problem;
  for (fs::recursive_directory_iterator file(folder, fs::directory_options::skip_permission_denied, problem), end;
       !problem && file != end; file.increment(problem)) {
    if (!file->path().filename().string().starts_with(part_prefix)) continue;
    parts.push_back(file->path());
    file.disable_recursion_pending();
  }
  for (const fs::path& part : parts) {
    const int descriptor = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (locked(descriptor)) fs::remove_all(part, problem);
    ::close(descriptor);
  }
}

namespace {

Result<void> write_bytes(const fs::path& target, std::string_view bytes, bool at_once) {
  std::error_code problem;
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), problem);
  if (problem) return file_not_writable(target, problem.message());
  auto part = Part::begin(target);
  if (!part) return failure(std::move(part.error()));
  if (const int code = part->write(bytes); code != 0) return file_not_writable(target, reason_of(code));
  // A disk may find out only now that it is full (quotas, network), and after a rename it would be too late.
  if (const int code = part->flush(); code != 0) return file_not_writable(target, reason_of(code));
  if (!at_once) {
    together->written.emplace_back(std::move(*part), target);
    return {};
  }
  if (const int code = part->put_in_place(target); code != 0) return file_not_writable(target, reason_of(code));
  flush_folder_of(target);
  return {};
}

// The first folder above the target that is missing is made as a whole.
Result<std::optional<fs::path>> place_in_new_folder(Together& files, const fs::path& target) {
  for (const NewFolder& folder : files.folders) {
    if (auto beside = folder.beside(target)) return beside;
  }
  if (target != target.lexically_normal()) return std::nullopt;  // "new/../here" needs the folder now
  fs::path missing;
  std::error_code problem;
  for (fs::path above = target.parent_path();
       !above.empty() && fs::symlink_status(above, problem).type() == fs::file_type::not_found;
       above = above.parent_path()) {
    missing = above;
  }
  if (missing.empty()) return std::nullopt;
  auto folder = NewFolder::begin(missing);
  if (!folder) return failure(std::move(folder.error()));
  files.folders.push_back(std::move(*folder));
  return files.folders.back().beside(target);
}

// One right after the other; what was there stands by, to come back where one of them cannot take its place.
Result<void> put_all_in_place(Together& files) {
  std::vector<std::pair<Part, fs::path>>& written = files.written;
  const auto take_back = [&](std::size_t count) {
    for (std::size_t done = count; done-- > 0;) (void)written[done].first.exchange_with(written[done].second);
  };
  for (std::size_t n = 0; n < written.size(); ++n) {
    const int code = written[n].first.exchange_with(written[n].second);
    if (code == 0) continue;
    take_back(n);
    return file_not_writable(written[n].second, reason_of(code));
  }
  for (NewFolder& folder : files.folders) {
    const int code = folder.put_in_place();
    if (code == 0) continue;
    take_back(written.size());
    return file_not_writable(folder.target(), reason_of(code));
  }
  for (const auto& [part, target] : written) flush_folder_of(target);
  for (const NewFolder& folder : files.folders) flush_folder_of(folder.target());
  return {};
}

void flush_folder_of(const fs::path& target) {
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (const int folder = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    (void)flushed(folder);  // the file is whole in either place
    ::close(folder);
  }
}

}  // namespace
}  // namespace glisson
