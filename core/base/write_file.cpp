#include "base/write_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/internal/held_files.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

const std::string part_prefix = ".part-";
constexpr int maximum_writers = 100;  // of one target at one time

// Where that writer of the target works until it is done.
fs::path part_path(const fs::path& target, int writer) {
  constexpr std::size_t longest_name = 200;  // a system takes 255 bytes
  const std::string count = writer == 0 ? "" : std::to_string(writer) + "-";
  return target.parent_path() / (part_prefix + count + target.filename().string().substr(0, longest_name));
}

// A file beside the target that this writer alone writes, known by a lock that ends with the process.
class Part {
 public:
  static Result<Part> begin(const fs::path& target);
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
  [[nodiscard]] int put_in_place(const fs::path& target);
  [[nodiscard]] int exchange_with(const fs::path& target);
  // Nothing comes to the target in exchange for what is there.
  void remove_instead() { removes_ = true; }

 private:
  [[nodiscard]] int take_away(const fs::path& target);
  Part(int descriptor, fs::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  int descriptor_ = -1;
  fs::path path_;           // empty once it stands in its place
  bool holds_old_ = false;  // what was at the target stands at the path
  bool removes_ = false;
};

// A folder that is not there yet: it is filled beside its place, known by a lock as a part is, and renamed once.
class NewFolder {
 public:
  static Result<NewFolder> begin(const fs::path& target);
  NewFolder(NewFolder&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)),
        target_(std::move(other.target_)),
        path_(std::move(other.path_)) {}
  NewFolder& operator=(NewFolder&&) = delete;
  ~NewFolder();

  [[nodiscard]] const fs::path& target() const { return target_; }
  // Where what is to lie at `place`, below the target, is written until then; nothing for any other place.
  [[nodiscard]] std::optional<fs::path> beside(const fs::path& place) const;
  // 0, or what the system says of it.
  [[nodiscard]] int put_in_place();

 private:
  NewFolder(int descriptor, fs::path target, fs::path path)
      : descriptor_(descriptor), target_(std::move(target)), path_(std::move(path)) {}
  int descriptor_ = -1;
  fs::path target_, path_;  // the path is empty once it stands in its place
};

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
int rename_new(const fs::path& from, const fs::path& to);
void flush_folder_of(const fs::path& target);
int flushed(int descriptor);
std::string reason_of(int code) { return std::generic_category().message(code); }

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

Result<Part> Part::begin(const fs::path& target) {
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
  for (int number = 0; number < maximum_writers; ++number) {
    fs::path path = part_path(target, number);
    if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) return file_not_writable(target, reason_of(errno));
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) continue;  // a file, or left by another person, or planted
    if (locked(descriptor) && stands_at(descriptor, path)) {
      NewFolder folder(descriptor, target, path);
      std::error_code problem;  // what a killed writer left in it
      for (const auto& left : fs::directory_iterator(path, problem)) fs::remove_all(left.path(), problem);
      if (problem) return file_not_writable(target, problem.message());
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

// Replaces nothing but an empty folder, where the file system cannot refuse even that.
int rename_new(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

void flush_folder_of(const fs::path& target) {
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (const int folder = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    (void)flushed(folder);  // the file is whole in either place
    ::close(folder);
  }
}

int flushed(int descriptor) {
  int outcome = 0;
  do outcome = ::fsync(descriptor);
  while (outcome != 0 && errno == EINTR);
  return outcome == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

}  // namespace
}  // namespace glisson
