// Built without OpenCL.

#include "opencl/session.h"

namespace glisson::opencl {

struct Buffer::Impl {};
Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;
Buffer::~Buffer() = default;

struct Session::Impl {
  std::string no_name;
};
Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

bool built() { return false; }

std::vector<std::string> devices() { return {}; }

Result<Session> Session::open(const std::string&, const std::string&) {
  return failure(Error{"opencl-not-built",
                       GLISSON_TEXT("This build has no OpenCL."),
                       {},
                       GLISSON_TEXT("Build with -DGLISSON_OPENCL=ON."),
                       {}});
}

// No session is ever open here.
const std::string& Session::device_name() const { return impl_->no_name; }
std::uint64_t Session::memory_bytes() const { return 0; }
Buffer Session::buffer(std::size_t) { return {}; }
void Session::write(const Buffer&, const void*, std::size_t) {}
void Session::read(const Buffer&, void*, std::size_t) {}
void Session::run(const char*, const Range&, std::initializer_list<Argument>) {}
Result<void> Session::finish() { return {}; }

}  // namespace glisson::opencl
