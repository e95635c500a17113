// Reading a file piece by piece, with the system's pread. Threads share no position. A file that shrinks meanwhile
// gives fewer bytes, where a memory map would end the program.

#include "imaging/internal/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <utility>

namespace glisson::imaging {
namespace {

// Most headers fit in the first piece.
constexpr std::uint64_t piece_bytes = 32 * 1024;

}  // namespace

Result<OpenFile> OpenFile::open(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat facts {};
  if (descriptor < 0 || ::fstat(descriptor, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    const bool forbidden = descriptor < 0 && errno == EACCES;
    if (descriptor >= 0) ::close(descriptor);
    return failure(Error{"file-not-readable",
                         forbidden ? GLISSON_TEXT("{0} may not be read by you.")
                                   : GLISSON_TEXT("{0} cannot be opened: it has gone, or is no ordinary file."),
                         {file.string()},
                         GLISSON_TEXT("Check that it exists and that you may read it."),
                         file});
  }
  return OpenFile(descriptor, static_cast<std::uint64_t>(facts.st_size));
}

OpenFile::OpenFile(OpenFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), bytes_(other.bytes_) {}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint64_t OpenFile::read(std::uint64_t offset, std::uint64_t count, void* into) const {
  std::uint64_t done = 0;
  while (done < count) {
    const ::ssize_t got =
        ::pread(descriptor_, static_cast<char*>(into) + done, count - done, static_cast<::off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::uint64_t>(got);
  }
  return done;
}

Result<FileBytes> FileBytes::open(const std::filesystem::path& file) {
  Result<OpenFile> opened = OpenFile::open(file);
  if (!opened) return failure(opened.error());
  return FileBytes(file, std::move(*opened));
}

const std::uint8_t* FileBytes::view(std::uint64_t index, std::uint64_t count) const {
  if (index > end() || count > end() - index) return nullptr;
  if (kept_.size() < index + count) {
    const std::uint64_t have = kept_.size();
    const std::uint64_t wanted = std::min(std::max(index + count, have + piece_bytes), end());
    kept_.resize(wanted);
    kept_.resize(have + file_.read(have + left_out_, wanted - have, kept_.data() + have));
    if (kept_.size() < index + count) return nullptr;
  }
  return reinterpret_cast<const std::uint8_t*>(kept_.data()) + index;
}

const std::uint8_t* FileBytes::view_far(std::uint64_t index, std::uint64_t count) const {
  if (index > end() || count > end() - index) return nullptr;
  if (index + count <= kept_.size()) return view(index, count);
  if (index < far_begin_ || index + count > far_begin_ + far_.size()) {
    far_.resize(std::min(std::max<std::uint64_t>(count, 4096), end() - index));
    far_begin_ = index;
    far_.resize(file_.read(index + left_out_, far_.size(), far_.data()));
    if (far_.size() < count) return nullptr;
  }
  return reinterpret_cast<const std::uint8_t*>(far_.data()) + (index - far_begin_);
}

void FileBytes::leave_out(std::uint64_t begin, std::uint64_t end_index) {
  kept_.resize(std::min<std::uint64_t>(kept_.size(), begin));
  left_out_ += end_index - begin;
}

std::string FileBytes::copy(std::uint64_t begin, std::uint64_t end_index) const {
  if (view(begin, end_index - begin) == nullptr) return {};
  return kept_.substr(begin, end_index - begin);
}

}  // namespace glisson::imaging
