#pragma once
// One OpenCL device (OpenCL 1.2; a GPU, or the processors through PoCL). It has the kernels of one source compiled for
// it, and one queue that runs them in the order of the calls. Which device there is shows when the program runs. Built
// without OpenCL (GLISSON_OPENCL off), opening is refused and nothing else is reached.
//
//   auto session = Session::open(source);                     // kernels as OpenCL C
//   Buffer x = session->buffer(sizeof(float) * n);
//   session->write(x, values.data(), sizeof(float) * n);
//   session->run("scale", {n, 64}, {&x, 2.0F, std::int32_t(n)});
//   session->read(x, values.data(), sizeof(float) * n);
//   if (auto done = session->finish(); !done) return failure(done.error());
//
// A call that the driver refuses is kept, later calls do nothing, and finish() says it: what stands between needs no
// tests of its own.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"

namespace glisson::opencl {

[[nodiscard]] bool built();

// "Portable Computing Language: pthread-AMD EPYC". Empty where there is none, or built without.
[[nodiscard]] std::vector<std::string> devices();

// Memory of a session's device; goes with the session at the latest.
class Buffer {
 public:
  Buffer();
  Buffer(Buffer&&) noexcept;
  Buffer& operator=(Buffer&&) noexcept;
  ~Buffer();

 private:
  friend class Session;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// So many bytes of a work-group's own memory.
struct LocalBytes {
  std::size_t bytes = 0;
};
using Argument = std::variant<const Buffer*, LocalBytes, std::int32_t, std::uint32_t, float>;

// Work items along one or two axes, each count a multiple of its group's.
struct Range {
  std::size_t items = 1, group = 1;
  std::size_t items_across = 1;  // the second axis, in groups of one
};
// The next multiple of `group`.
[[nodiscard]] constexpr std::size_t whole_groups(std::size_t items, std::size_t group) {
  return (items + group - 1) / group * group;
}

class Session {
 public:
  // On the first device whose name contains `device_name`. The first session of a source takes a tenth of a second or
  // so to compile it, later ones share what it made. Fails with "opencl-not-built". Fails with "opencl-no-device" where
  // there is no such device, and says which there are. Fails with "opencl-failed" and a number where the driver
  // refuses. Fails with "opencl-source" and its first lines of complaint where it cannot compile a source.
  static Result<Session> open(const std::string& source, const std::string& device_name = {});
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  [[nodiscard]] const std::string& device_name() const;
  [[nodiscard]] std::uint64_t memory_bytes() const;

  // Zeros.
  [[nodiscard]] Buffer buffer(std::size_t bytes);
  // What a vector holds.
  template <typename Numbers>
  [[nodiscard]] Buffer buffer_of(const Numbers& numbers) {
    const std::size_t bytes = sizeof(numbers[0]) * numbers.size();
    Buffer held = buffer(bytes);
    write(held, numbers.data(), bytes);
    return held;
  }
  void write(const Buffer& to, const void* from, std::size_t bytes);
  // Waits for all that was asked for before.
  void read(const Buffer& from, void* to, std::size_t bytes);
  void run(const char* kernel, const Range& range, std::initializer_list<Argument> arguments);

  // Waits; the first refusal since the last call of finish, "opencl-failed".
  Result<void> finish();

 private:
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::opencl
