#include "opencl/session.h"

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace glisson::opencl {
namespace {

// A handle of OpenCL's that is released with its owner.
template <typename Handle, cl_int (*release)(Handle)>
class Owned {
 public:
  Owned() = default;
  explicit Owned(Handle handle) : handle_(handle) {}
  Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    if (handle_ != nullptr) release(handle_);
  }
  [[nodiscard]] Handle get() const { return handle_; }

 private:
  Handle handle_ = nullptr;
};
using Context = Owned<cl_context, clReleaseContext>;
using Queue = Owned<cl_command_queue, clReleaseCommandQueue>;
using Program = Owned<cl_program, clReleaseProgram>;
using Kernel = Owned<cl_kernel, clReleaseKernel>;
using Memory = Owned<cl_mem, clReleaseMemObject>;

struct FoundDevice {
  cl_device_id id = nullptr;
  std::string name;
};

// A context and a program take a tenth of a second to make; the program keeps them while it runs.
struct Compiled {
  FoundDevice device;
  Context context;  // released last
  Program program;
};

Failure failed(const char* call, cl_int code) {
  return failure("opencl-failed", GLISSON_TEXT("OpenCL's {0} failed with {1}."), {call, std::to_string(code)});
}

std::vector<FoundDevice> found_devices();
Result<FoundDevice> device_named(const std::string& part);
Result<std::shared_ptr<const Compiled>> compiled_for(const FoundDevice& device, const std::string& source);

}  // namespace

struct Buffer::Impl {
  Memory memory;
};
Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;
Buffer::~Buffer() = default;

struct Session::Impl {
  std::shared_ptr<const Compiled> compiled;
  // Released in the reverse order: kernels first.
  Queue queue;
  std::map<std::string, Kernel> kernels;
  std::optional<Error> refused;

  // False once something was refused.
  bool keep(const char* call, cl_int code) {
    if (code != CL_SUCCESS && !refused) refused = failed(call, code).value();
    return !refused;
  }
};
Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

bool built() { return true; }

std::vector<std::string> devices() {
  std::vector<std::string> names;
  for (FoundDevice& device : found_devices()) names.push_back(std::move(device.name));
  return names;
}

Result<Session> Session::open(const std::string& source, const std::string& device_name) {
  auto device = device_named(device_name);
  if (!device) return failure(device.error());
  auto compiled = compiled_for(*device, source);
  if (!compiled) return failure(compiled.error());
  auto impl = std::make_unique<Impl>();
  impl->compiled = std::move(*compiled);
  cl_int code = CL_SUCCESS;
  impl->queue = Queue(clCreateCommandQueue(impl->compiled->context.get(), device->id, 0, &code));
  if (code != CL_SUCCESS) return failed("clCreateCommandQueue", code);
  return Session(std::move(impl));
}

const std::string& Session::device_name() const { return impl_->compiled->device.name; }

std::uint64_t Session::memory_bytes() const {
  cl_ulong bytes = 0;
  clGetDeviceInfo(impl_->compiled->device.id, CL_DEVICE_GLOBAL_MEM_SIZE, sizeof bytes, &bytes, nullptr);
  return bytes;
}

Buffer Session::buffer(std::size_t bytes) {
  Buffer buffer;
  buffer.impl_ = std::make_unique<Buffer::Impl>();
  if (impl_->refused) return buffer;
  cl_int code = CL_SUCCESS;
  const std::size_t some = std::max<std::size_t>(whole_groups(bytes, 16), 16);
  buffer.impl_->memory =
      Memory(clCreateBuffer(impl_->compiled->context.get(), CL_MEM_READ_WRITE, some, nullptr, &code));
  if (!impl_->keep("clCreateBuffer", code)) return buffer;
  const cl_uchar zero = 0;
  impl_->keep("clEnqueueFillBuffer", clEnqueueFillBuffer(impl_->queue.get(), buffer.impl_->memory.get(), &zero,
                                                         sizeof zero, 0, some, 0, nullptr, nullptr));
  return buffer;
}

void Session::write(const Buffer& to, const void* from, std::size_t bytes) {
  if (impl_->refused || bytes == 0) return;
  impl_->keep("clEnqueueWriteBuffer", clEnqueueWriteBuffer(impl_->queue.get(), to.impl_->memory.get(), CL_TRUE, 0,
                                                           bytes, from, 0, nullptr, nullptr));
}

void Session::read(const Buffer& from, void* to, std::size_t bytes) {
  if (impl_->refused || bytes == 0) return;
  impl_->keep("clEnqueueReadBuffer", clEnqueueReadBuffer(impl_->queue.get(), from.impl_->memory.get(), CL_TRUE, 0,
                                                         bytes, to, 0, nullptr, nullptr));
}

void Session::run(const char* name, const Range& range, std::initializer_list<Argument> arguments) {
  if (impl_->refused) return;
  Kernel& kernel = impl_->kernels[name];
  cl_int code = CL_SUCCESS;
  if (kernel.get() == nullptr) kernel = Kernel(clCreateKernel(impl_->compiled->program.get(), name, &code));
  if (!impl_->keep("clCreateKernel", code)) return;
  cl_uint place = 0;
  for (const Argument& argument : arguments) {
    if (const auto* buffer = std::get_if<const Buffer*>(&argument)) {
      const cl_mem memory = (*buffer)->impl_->memory.get();
      code = clSetKernelArg(kernel.get(), place, sizeof(cl_mem), &memory);
    } else if (const auto* local = std::get_if<LocalBytes>(&argument)) {
      code = clSetKernelArg(kernel.get(), place, local->bytes, nullptr);
    } else if (const auto* whole = std::get_if<std::int32_t>(&argument)) {
      code = clSetKernelArg(kernel.get(), place, sizeof *whole, whole);
    } else if (const auto* natural = std::get_if<std::uint32_t>(&argument)) {
      code = clSetKernelArg(kernel.get(), place, sizeof *natural, natural);
    } else {
      code = clSetKernelArg(kernel.get(), place, sizeof(float), &std::get<float>(argument));
    }
    if (!impl_->keep("clSetKernelArg", code)) return;
    ++place;
  }
  const std::size_t items[] = {range.items, range.items_across};
  const std::size_t group[] = {range.group, 1};
  impl_->keep("clEnqueueNDRangeKernel",
              clEnqueueNDRangeKernel(impl_->queue.get(), kernel.get(), 2, nullptr, items, group, 0, nullptr, nullptr));
}

Result<void> Session::finish() {
  impl_->keep("clFinish", clFinish(impl_->queue.get()));
  if (!impl_->refused) return {};
  Error error = std::move(*impl_->refused);
  impl_->refused.reset();
  return failure(std::move(error));
}

namespace {

std::string name_of(cl_platform_id platform) {
  char text[256] = {};
  clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof text - 1, text, nullptr);
  return text;
}

std::string name_of(cl_device_id device) {
  char text[256] = {};
  clGetDeviceInfo(device, CL_DEVICE_NAME, sizeof text - 1, text, nullptr);
  return text;
}

std::vector<FoundDevice> found_devices() {
  constexpr cl_uint maximum = 64;
  cl_platform_id platforms[maximum];
  cl_uint platform_count = 0;
  std::vector<FoundDevice> found;
  if (clGetPlatformIDs(maximum, platforms, &platform_count) != CL_SUCCESS) return found;
  for (cl_uint p = 0; p < std::min(platform_count, maximum); ++p) {
    cl_device_id ids[maximum];
    cl_uint device_count = 0;
    if (clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, maximum, ids, &device_count) != CL_SUCCESS) continue;
    for (cl_uint d = 0; d < std::min(device_count, maximum); ++d)
      found.push_back({ids[d], name_of(platforms[p]) + ": " + name_of(ids[d])});
  }
  return found;
}

Result<FoundDevice> device_named(const std::string& part) {
  std::string known;
  for (FoundDevice& device : found_devices()) {
    if (device.name.find(part) != std::string::npos) return device;
    known += (known.empty() ? "" : "; ") + device.name;
  }
  return failure(
      Error{"opencl-no-device",
            GLISSON_TEXT("There is no OpenCL device \"{0}\"."),
            {part, known.empty() ? "none" : known},
            GLISSON_TEXT("Found: {1}. A device shows once its driver is installed (pocl-opencl-icd for processors)."),
            {}});
}

std::string complaint(cl_program program, cl_device_id device) {
  constexpr std::size_t maximum = 400;
  std::size_t size = 0;
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
  std::string text(size, '\0');
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, text.data(), nullptr);
  return text.substr(0, std::min(text.find('\0'), maximum));
}

Result<std::shared_ptr<const Compiled>> compiled_for(const FoundDevice& device, const std::string& source) {
  using Kept = std::map<std::pair<cl_device_id, std::string>, std::shared_ptr<const Compiled>>;
  static std::mutex mutex;
  static Kept& kept = *new Kept;  // never released: the driver may be gone by then
  const std::lock_guard lock(mutex);
  std::shared_ptr<const Compiled>& place = kept[{device.id, source}];
  if (place) return place;
  auto compiled = std::make_shared<Compiled>();
  compiled->device = device;
  cl_int code = CL_SUCCESS;
  compiled->context = Context(clCreateContext(nullptr, 1, &device.id, nullptr, nullptr, &code));
  if (code != CL_SUCCESS) return failed("clCreateContext", code);
  const char* text = source.c_str();
  compiled->program = Program(clCreateProgramWithSource(compiled->context.get(), 1, &text, nullptr, &code));
  if (code != CL_SUCCESS) return failed("clCreateProgramWithSource", code);
  code = clBuildProgram(compiled->program.get(), 1, &device.id, "-cl-std=CL1.2", nullptr, nullptr);
  if (code == CL_BUILD_PROGRAM_FAILURE) {
    return failure("opencl-source", GLISSON_TEXT("{0} cannot compile the kernels: {1}"),
                   {device.name, complaint(compiled->program.get(), device.id)});
  }
  if (code != CL_SUCCESS) return failed("clBuildProgram", code);
  place = std::move(compiled);
  return place;
}

}  // namespace
}  // namespace glisson::opencl
