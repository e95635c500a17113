#include "hardware/opencl_product.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "opencl/session.h"

namespace glisson::hardware {
namespace {

// One work item a block: neighbours in a tile read neighbouring numbers, which every device can fetch together.
constexpr const char* product_source = R"(
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

class OpenClProduct : public ProductKernel {
 public:
  OpenClProduct(opencl::Session session, int columns, std::size_t largest_bytes)
      : session_(std::move(session)), columns_(columns), largest_bytes_(largest_bytes) {}

  [[nodiscard]] std::string name() const override { return "OpenCL, " + session_.device_name(); }

  Result<void> prepare(std::size_t nodes) override {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t bytes_per_node = sizeof(float) * (columns * block_rows + columns + block_rows);
    if (nodes > largest_bytes_ / bytes_per_node || nodes > std::numeric_limits<std::uint32_t>::max()) {
      return failure("batch-too-large",
                     GLISSON_TEXT("A batch of {0} nodes takes more than the {1} MB there are for it."),
                     {std::to_string(nodes), std::to_string(largest_bytes_ >> 20)});
    }
    const std::size_t padded = opencl::whole_groups(nodes, blocks_in_tile);
    const auto ones = [&](std::size_t entries) {
      return session_.buffer_of(std::vector<float>(padded * entries, 1.0F));
    };
    blocks_ = ones(columns * block_rows);
    x_ = ones(columns);
    y_ = ones(block_rows);
    return session_.finish();
  }

  Result<void> run(std::size_t nodes, int times) override {
    constexpr std::size_t group = 64;
    for (int i = 0; i < times; ++i) {
      session_.run("multiply_blocks", {opencl::whole_groups(nodes, group), group},
                   {&blocks_, &x_, &y_, std::int32_t{columns_}, static_cast<std::uint32_t>(nodes)});
    }
    return session_.finish();
  }

  Result<void> multiply(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y) {
    if (const auto prepared = prepare(blocks.items()); !prepared) return prepared;
    session_.write(blocks_, blocks.data(), sizeof(float) * blocks.size());
    session_.write(x_, x.data(), sizeof(float) * x.size());
    if (const auto ran = run(blocks.items(), 1); !ran) return ran;
    session_.read(y_, y.data(), sizeof(float) * y.size());
    return session_.finish();
  }

 private:
  opencl::Session session_;
  int columns_;
  std::size_t largest_bytes_;
  opencl::Buffer blocks_, x_, y_;
};

Result<std::unique_ptr<OpenClProduct>> opened(int columns, std::size_t largest_bytes, const std::string& device_name) {
  auto session = opencl::Session::open(product_source, device_name);
  if (!session) return failure(session.error());
  return std::make_unique<OpenClProduct>(std::move(*session), columns, largest_bytes);
}

}  // namespace

Result<std::unique_ptr<ProductKernel>> opencl_product(int nodes_in_domain, std::size_t largest_bytes,
                                                      const std::string& device_name) {
  auto product = opened(3 * nodes_in_domain, largest_bytes, device_name);
  if (!product) return failure(product.error());
  return std::unique_ptr<ProductKernel>(std::move(*product));
}

Result<void> multiply_blocks_opencl(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y,
                                    const std::string& device_name) {
  GLISSON_ASSERT(blocks.entries() == x.entries() * block_rows && y.entries() == block_rows);
  GLISSON_ASSERT(blocks.items() == x.items() && blocks.items() == y.items());
  const auto product = opened(x.entries(), std::numeric_limits<std::size_t>::max(), device_name);
  if (!product) return failure(product.error());
  return (*product)->multiply(blocks, x, y);
}

}  // namespace glisson::hardware
