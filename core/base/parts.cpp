#include "base/internal/parts.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <system_error>

#include "base/folder_contents.h"
#include "base/internal/held_files.h"
#include "base/write_file.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr int maximum_writers = 100;  // of one target at one time

// Where that writer of the target works until it is done.
fs::path part_path(const fs::path& target, int writer) {
  constexpr std::size_t longest_name = 200;  // a system takes 255 bytes
  const std::string count = writer == 0 ? "" : std::to_string(writer) + "-";
  return target.parent_path() / (std::string(part_prefix) + count + target.filename().string().substr(0, longest_name));
}

// Of writers that were killed, whatever they were writing; once a folder, since a program may write many files into it.
void remove_what_was_left_beside(const fs::path& target);
// Replaces nothing but an empty folder, where the file system cannot refuse even that.
int rename_new(const fs::path& from, const fs::path& to);

}  // namespace

std::string reason_of(int code) { return std::generic_category().message(code); }

int flushed(int descriptor) {
  int outcome = 0;
  do outcome = ::fsync(descriptor);
  while (outcome != 0 && errno == EINTR);
  return outcome == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

Result<Part> Part::begin(const fs::path& target) {
  remove_what_was_left_beside(target);
  for (int number = 0; number < maximum_writers; ++number) {
    fs::path path = part_path(target, number);
    int descriptor = -1;
    do descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) {
      const int code = errno;
      struct stat there {};
      const bool anothers = (code == EACCES || code == ELOOP) && ::lstat(path.c_str(), &there) == 0;
      if (anothers) continue;  // left by another person, or planted
      return file_not_writable(target, reason_of(code));
    }
    // Whoever held it before may have renamed or removed it since it was opened.
    if (locked(descriptor) && stands_at(descriptor, path)) {
      Part part(descriptor, std::move(path));
      if (::ftruncate(descriptor, 0) != 0) return file_not_writable(target, reason_of(errno));
      return part;
    }
    ::close(descriptor);
  }
  return file_not_writable(target, GLISSON_TEXT("others are writing it"));
}

Part::~Part() {
  if (descriptor_ < 0) return;
  if (!path_.empty() && (holds_old_ || stands_at(descriptor_, path_))) ::unlink(path_.c_str());
  ::close(descriptor_);
}

int Part::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

int Part::flush() const { return flushed(descriptor_); }

int Part::put_in_place(const fs::path& target) {
  if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
  path_.clear();
  return 0;
}

// There and back.
int Part::exchange_with(const fs::path& target) {
  if (removes_) return take_away(target);
  std::error_code problem;
  const bool is_there = fs::exists(fs::symlink_status(target, problem));
  const bool mine = stands_at(descriptor_, path_);
  const int code = exchange_files(path_, target);
  if (code == 0) holds_old_ = mine && is_there;
  return code;
}

int Part::take_away(const fs::path& target) {
  const fs::path& from = holds_old_ ? path_ : target;
  const fs::path& to = holds_old_ ? target : path_;
  if (::rename(from.c_str(), to.c_str()) != 0) return errno;
  holds_old_ = !holds_old_;
  return 0;
}

Result<NewFolder> NewFolder::begin(const fs::path& target) {
  remove_what_was_left_beside(target);
  for (int number = 0; number < maximum_writers; ++number) {
    fs::path path = part_path(target, number);
    if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) return file_not_writable(target, reason_of(errno));
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) continue;  // a file, or left by another person, or planted
    if (locked(descriptor) && stands_at(descriptor, path)) {
      NewFolder folder(descriptor, target, path);
      for (const fs::path& left : contents_of(path)) {  // by a killed writer
        std::error_code problem;
        fs::remove_all(left, problem);
        if (problem) return file_not_writable(target, problem.message());
      }
      return folder;
    }
    ::close(descriptor);
  }
  return file_not_writable(target, GLISSON_TEXT("others are writing it"));
}

NewFolder::~NewFolder() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  if (!path_.empty() && stands_at(descriptor_, path_)) fs::remove_all(path_, ignored);
  ::close(descriptor_);
}

std::optional<fs::path> NewFolder::beside(const fs::path& place) const {
  const auto [end_of_target, rest] = std::mismatch(target_.begin(), target_.end(), place.begin(), place.end());
  if (end_of_target != target_.end() || rest == place.end()) return std::nullopt;
  fs::path beside = path_;
  for (auto part = rest; part != place.end(); ++part) beside /= *part;
  return beside;
}

int NewFolder::put_in_place() {
  if (const int code = rename_new(path_, target_); code != 0) return code;
  path_.clear();
  return 0;
}

namespace {

void remove_what_was_left_beside(const fs::path& target) {
  static std::mutex guard;
  static auto* const seen =
      new std::set<fs::path>;  // never destroyed: files may be written as late as the program ends
  std::error_code problem;
  const fs::path folder = fs::absolute(target, problem).lexically_normal().parent_path();
  {
    const std::lock_guard lock(guard);
    if (problem || !seen->insert(folder).second) return;
  }
  for (const fs::path& left : contents_of(folder)) {
    if (!left.filename().string().starts_with(part_prefix)) continue;
    const int descriptor = ::open(left.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    remove_if_abandoned(descriptor, left);
    ::close(descriptor);
  }
}

int rename_new(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace
}  // namespace glisson
