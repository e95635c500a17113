#include "hardware/opencl_product.h"

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <fmt/format.h>
#include <algorithm>
#include <limits>

namespace glisson::hardware {
namespace {

// One work item a block: neighbours in a tile read neighbouring numbers, which every device can fetch together.
constexpr const char* kernel_source = R"(
__kernel void multiply_blocks(__global const float* blocks, __global const float* x, __global float* y,
                              const int columns, const uint nodes) {
  const uint node = get_global_id(0);
  if (node >= nodes) return;
  const ulong tile = node / 16u;
  const uint lane = node % 16u;
  __global const float* b = blocks + tile * columns * 48u + lane;
  __global const float* v = x + tile * columns * 16u + lane;
  float sum0 = 0.0f, sum1 = 0.0f, sum2 = 0.0f;
  for (int c = 0; c < columns; ++c) {
    const float factor = v[c * 16];
    sum0 = fma(b[c * 48], factor, sum0);
    sum1 = fma(b[c * 48 + 16], factor, sum1);
    sum2 = fma(b[c * 48 + 32], factor, sum2);
  }
  __global float* out = y + tile * 48u + lane;
  out[0] = sum0;
  out[16] = sum1;
  out[32] = sum2;
})";
static_assert(blocks_in_tile == 16 && block_rows == 3, "the kernel's numbers");

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
using Buffer = Owned<cl_mem, clReleaseMemObject>;

struct FoundDevice {
  cl_device_id id = nullptr;
  std::string name;
};

Failure failed(const char* call, cl_int code) {
  return failure("opencl-failed", GLISSON_TEXT("OpenCL's {0} failed with {1}."), {call, std::to_string(code)});
}

std::string text_of(cl_platform_id platform) {
  char text[256] = {};
  clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof text - 1, text, nullptr);
  return text;
}

std::string text_of(cl_device_id device) {
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
    cl_device_id devices[maximum];
    cl_uint device_count = 0;
    if (clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, maximum, devices, &device_count) != CL_SUCCESS) continue;
    for (cl_uint d = 0; d < std::min(device_count, maximum); ++d)
      found.push_back({devices[d], text_of(platforms[p]) + ": " + text_of(devices[d])});
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

class OpenClProduct : public ProductKernel {
 public:
  static Result<std::unique_ptr<OpenClProduct>> open(int nodes_in_domain, std::size_t largest_bytes,
                                                     const std::string& device_name) {
    const auto device = device_named(device_name);
    if (!device) return failure(device.error());
    auto product = std::unique_ptr<OpenClProduct>(new OpenClProduct(*device, 3 * nodes_in_domain, largest_bytes));
    if (const auto built = product->build(); !built) return failure(built.error());
    return product;
  }

  [[nodiscard]] std::string name() const override { return "OpenCL, " + device_.name; }

  Result<void> prepare(std::size_t nodes) override {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t bytes_per_node = sizeof(float) * (columns * block_rows + columns + block_rows);
    if (nodes > largest_bytes_ / bytes_per_node || nodes > std::numeric_limits<cl_uint>::max()) {
      return failure("batch-too-large",
                     GLISSON_TEXT("A batch of {0} nodes takes more than the {1} MB there are for it."),
                     {std::to_string(nodes), std::to_string(largest_bytes_ >> 20)});
    }
    const std::size_t padded = (nodes + blocks_in_tile - 1) / blocks_in_tile * blocks_in_tile;
    const auto allocate = [&](std::size_t entries, Buffer& buffer) -> Result<void> {
      cl_int code = CL_SUCCESS;
      const std::size_t bytes = sizeof(float) * padded * entries;
      buffer = Buffer(clCreateBuffer(context_.get(), CL_MEM_READ_WRITE, bytes, nullptr, &code));
      if (code != CL_SUCCESS) return failed("clCreateBuffer", code);
      const float number = 1.0F;
      code = clEnqueueFillBuffer(queue_.get(), buffer.get(), &number, sizeof number, 0, bytes, 0, nullptr, nullptr);
      if (code != CL_SUCCESS) return failed("clEnqueueFillBuffer", code);
      return {};
    };
    for (auto [entries, buffer] : {std::pair(columns * block_rows, &blocks_), {columns, &x_}, {block_rows, &y_}}) {
      if (const auto allocated = allocate(entries, *buffer); !allocated) return allocated;
    }
    return finish();
  }

  Result<void> run(std::size_t nodes, int times) override {
    const cl_mem blocks = blocks_.get();
    const cl_mem x = x_.get();
    const cl_mem y = y_.get();
    const cl_int columns = columns_;
    const auto count = static_cast<cl_uint>(nodes);
    clSetKernelArg(kernel_.get(), 0, sizeof blocks, &blocks);
    clSetKernelArg(kernel_.get(), 1, sizeof x, &x);
    clSetKernelArg(kernel_.get(), 2, sizeof y, &y);
    clSetKernelArg(kernel_.get(), 3, sizeof columns, &columns);
    clSetKernelArg(kernel_.get(), 4, sizeof count, &count);
    const std::size_t group = 64;
    const std::size_t items = (nodes + group - 1) / group * group;
    for (int i = 0; i < times; ++i) {
      const cl_int code =
          clEnqueueNDRangeKernel(queue_.get(), kernel_.get(), 1, nullptr, &items, &group, 0, nullptr, nullptr);
      if (code != CL_SUCCESS) return failed("clEnqueueNDRangeKernel", code);
    }
    return finish();
  }

  Result<void> multiply(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y) {
    if (const auto prepared = prepare(blocks.items()); !prepared) return prepared;
    const auto put = [&](const TiledBatch& from, const Buffer& to) {
      return clEnqueueWriteBuffer(queue_.get(), to.get(), CL_TRUE, 0, sizeof(float) * from.size(), from.data(), 0,
                                  nullptr, nullptr);
    };
    if (const cl_int code = put(blocks, blocks_); code != CL_SUCCESS) return failed("clEnqueueWriteBuffer", code);
    if (const cl_int code = put(x, x_); code != CL_SUCCESS) return failed("clEnqueueWriteBuffer", code);
    if (const auto ran = run(blocks.items(), 1); !ran) return ran;
    const cl_int code = clEnqueueReadBuffer(queue_.get(), y_.get(), CL_TRUE, 0, sizeof(float) * y.size(), y.data(), 0,
                                            nullptr, nullptr);
    if (code != CL_SUCCESS) return failed("clEnqueueReadBuffer", code);
    return {};
  }

 private:
  OpenClProduct(FoundDevice device, int columns, std::size_t largest_bytes)
      : device_(std::move(device)), columns_(columns), largest_bytes_(largest_bytes) {}

  Result<void> build() {
    cl_int code = CL_SUCCESS;
    context_ = Context(clCreateContext(nullptr, 1, &device_.id, nullptr, nullptr, &code));
    if (code != CL_SUCCESS) return failed("clCreateContext", code);
    queue_ = Queue(clCreateCommandQueue(context_.get(), device_.id, 0, &code));
    if (code != CL_SUCCESS) return failed("clCreateCommandQueue", code);
    const char* source = kernel_source;
    program_ = Program(clCreateProgramWithSource(context_.get(), 1, &source, nullptr, &code));
    if (code != CL_SUCCESS) return failed("clCreateProgramWithSource", code);
    code = clBuildProgram(program_.get(), 1, &device_.id, "", nullptr, nullptr);
    if (code != CL_SUCCESS) return failed("clBuildProgram", code);
    kernel_ = Kernel(clCreateKernel(program_.get(), "multiply_blocks", &code));
    if (code != CL_SUCCESS) return failed("clCreateKernel", code);
    return {};
  }

  Result<void> finish() {
    const cl_int code = clFinish(queue_.get());
    if (code != CL_SUCCESS) return failed("clFinish", code);
    return {};
  }

  FoundDevice device_;
  int columns_;
  std::size_t largest_bytes_;
  // Released in the reverse order: buffers first, the context last.
  Context context_;
  Queue queue_;
  Program program_;
  Kernel kernel_;
  Buffer blocks_, x_, y_;
};

}  // namespace

bool built_with_opencl() { return true; }

Result<std::vector<std::string>> opencl_devices() {
  std::vector<std::string> names;
  for (FoundDevice& device : found_devices()) names.push_back(std::move(device.name));
  return names;
}

Result<std::unique_ptr<ProductKernel>> opencl_product(int nodes_in_domain, std::size_t largest_bytes,
                                                      const std::string& device_name) {
  auto product = OpenClProduct::open(nodes_in_domain, largest_bytes, device_name);
  if (!product) return failure(product.error());
  return std::unique_ptr<ProductKernel>(std::move(*product));
}

Result<void> multiply_blocks_opencl(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y,
                                    const std::string& device_name) {
  GLISSON_ASSERT(blocks.entries() == x.entries() * block_rows && y.entries() == block_rows);
  GLISSON_ASSERT(blocks.items() == x.items() && blocks.items() == y.items());
  const auto product = OpenClProduct::open(x.entries() / 3, std::numeric_limits<std::size_t>::max(), device_name);
  if (!product) return failure(product.error());
  return (*product)->multiply(blocks, x, y);
}

}  // namespace glisson::hardware
