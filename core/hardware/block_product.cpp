#include "hardware/block_product.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <new>
#include <numeric>
#include <vector>

#include "base/parallel.h"

// The loop below is compiled once for each width of vectors that the processor family has.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hardware/block_product.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, as Highway asks.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glisson::hardware {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void multiply_tiles(const float* blocks, const float* x, float* y, int columns, std::size_t begin, std::size_t end) {
  const hn::CappedTag<float, blocks_in_tile> lanes;
  const std::size_t width = hn::Lanes(lanes);
  const auto c_count = static_cast<std::size_t>(columns);
  for (std::size_t tile = begin; tile < end; ++tile) {
    const float* tile_blocks = blocks + tile * c_count * block_rows * blocks_in_tile;
    const float* tile_x = x + tile * c_count * blocks_in_tile;
    float* tile_y = y + tile * block_rows * blocks_in_tile;
    for (std::size_t lane = 0; lane < blocks_in_tile; lane += width) {
      auto sum0 = hn::Zero(lanes);
      auto sum1 = hn::Zero(lanes);
      auto sum2 = hn::Zero(lanes);
      for (std::size_t c = 0; c < c_count; ++c) {
        const auto factor = hn::Load(lanes, tile_x + c * blocks_in_tile + lane);
        const float* column = tile_blocks + c * block_rows * blocks_in_tile + lane;
        sum0 = hn::MulAdd(hn::Load(lanes, column), factor, sum0);
        sum1 = hn::MulAdd(hn::Load(lanes, column + blocks_in_tile), factor, sum1);
        sum2 = hn::MulAdd(hn::Load(lanes, column + 2 * blocks_in_tile), factor, sum2);
      }
      hn::Store(sum0, lanes, tile_y + lane);
      hn::Store(sum1, lanes, tile_y + blocks_in_tile + lane);
      hn::Store(sum2, lanes, tile_y + 2 * blocks_in_tile + lane);
    }
  }
}

const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace glisson::hardware
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glisson::hardware {
namespace {

HWY_EXPORT(multiply_tiles);
HWY_EXPORT(target_name);

// A thread's share below which waking it costs more than it saves: 10 to 20 us of work from a cache.
constexpr std::size_t bytes_worth_a_thread = std::size_t{1} << 20;

class ProcessorProduct : public ProductKernel {
 public:
  ProcessorProduct(int nodes_in_domain, std::size_t largest_bytes)
      : columns_(3 * nodes_in_domain), largest_bytes_(largest_bytes), blocks_(0, 1), x_(0, 1), y_(0, 1) {}

  [[nodiscard]] std::string name() const override {
    return fmt::format("{} threads, {}", thread_count(), vector_instructions());
  }

  Result<void> prepare(std::size_t nodes) override {
    const auto bytes_per_node = sizeof(float) * static_cast<std::size_t>(columns_ * block_rows + columns_ + block_rows);
    if (nodes > largest_bytes_ / bytes_per_node) return too_large(nodes);
    try {
      blocks_ = TiledBatch(nodes, columns_ * block_rows);
      x_ = TiledBatch(nodes, columns_);
      y_ = TiledBatch(nodes, block_rows);
    } catch (const std::bad_alloc&) {
      return too_large(nodes);
    }
    // Any numbers of ordinary size: denormals would be slow, zeros might be skipped.
    for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_.data()[i] = 1.0F + 0.001F * static_cast<float>(i % 997);
    for (std::size_t i = 0; i < x_.size(); ++i) x_.data()[i] = 1.0F - 0.001F * static_cast<float>(i % 499);
    return {};
  }

  Result<void> run(std::size_t nodes, int times) override {
    for (int i = 0; i < times; ++i) multiply_blocks(blocks_, x_, nodes, y_);
    return {};
  }

 private:
  [[nodiscard]] Failure too_large(std::size_t nodes) const {
    return failure("batch-too-large", GLISSON_TEXT("A batch of {0} nodes takes more than the {1} MB there are for it."),
                   {std::to_string(nodes), std::to_string(largest_bytes_ >> 20)});
  }

  int columns_;
  std::size_t largest_bytes_;
  TiledBatch blocks_, x_, y_;
};

}  // namespace

TiledBatch::TiledBatch(std::size_t items, int entries) : items_(items), entries_(entries) {
  constexpr std::size_t alignment = 64;
  const std::size_t bytes = std::max(size() * sizeof(float), alignment);
  values_.reset(static_cast<float*>(std::aligned_alloc(alignment, bytes)));
  if (!values_) throw std::bad_alloc();
  std::memset(values_.get(), 0, bytes);
}

void TiledBatch::Free::operator()(float* values) const { std::free(values); }

void multiply_blocks(const TiledBatch& blocks, const TiledBatch& x, std::size_t nodes, TiledBatch& y) {
  const int columns = x.entries();
  GLISSON_ASSERT(blocks.entries() == columns * block_rows && y.entries() == block_rows);
  GLISSON_ASSERT(nodes <= blocks.items() && nodes <= x.items() && nodes <= y.items());
  const std::size_t tile_bytes = sizeof(float) * blocks_in_tile * static_cast<std::size_t>(columns) * (block_rows + 1);
  const std::size_t grain = std::max<std::size_t>(1, bytes_worth_a_thread / tile_bytes);
  parallel_for((nodes + blocks_in_tile - 1) / blocks_in_tile, grain, [&](std::size_t begin, std::size_t end) {
    HWY_DYNAMIC_DISPATCH(multiply_tiles)(blocks.data(), x.data(), y.data(), columns, begin, end);
  });
}

std::string vector_instructions() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

namespace {

constexpr int bandwidth_rounds = 5;

double best_seconds(const std::function<void()>& work) {
  double best_s = HUGE_VAL;
  for (int round = 0; round < bandwidth_rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best_s = std::min(best_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best_s;
}

}  // namespace

double memory_bandwidth_GB_s(std::size_t bytes_per_array) {
  const std::size_t count = bytes_per_array / sizeof(float);
  const TiledBatch x(count, 1);
  const TiledBatch z(count, 1);
  TiledBatch y(count, 1);
  const double bytes = static_cast<double>(count * sizeof(float));
  const double triad_s = best_seconds([&] {
    parallel_for(count, count / 64, [&](std::size_t begin, std::size_t end) {
      const float* from_x = x.data();
      const float* from_z = z.data();
      float* to = y.data();
      for (std::size_t i = begin; i < end; ++i) to[i] = from_x[i] + 3.0F * from_z[i];
    });
  });
  // Each part's sum is written down, so that no compiler leaves the reading out.
  std::vector<float> sums(64, 0);
  const double reading_s = best_seconds([&] {
    parallel_for(sums.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t part = begin; part < end; ++part) {
        constexpr std::size_t lanes = 64;  // sums side by side: one alone would wait for itself
        float lane[lanes] = {};
        const float* from = x.data() + part * (count / sums.size());
        for (std::size_t i = 0; i + lanes <= count / sums.size(); i += lanes) {
          for (std::size_t l = 0; l < lanes; ++l) lane[l] += from[i + l];
        }
        sums[part] = std::accumulate(lane, lane + lanes, 0.0F);
      }
    });
  });
  GLISSON_ASSERT(std::accumulate(sums.begin(), sums.end(), 0.0F) == 0);
  return std::max(3 * bytes / triad_s, bytes / reading_s) * 1e-9;
}

std::size_t largest_cache_bytes() {
  std::size_t largest = 0;
  for (int index = 0; index < 8; ++index) {
    std::ifstream file(fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/size", index));
    std::size_t size = 0;
    char unit = 'K';  // "32768K"
    if (file >> size >> unit) largest = std::max(largest, size << (unit == 'M' ? 20 : 10));
  }
  return largest;
}

std::unique_ptr<ProductKernel> processor_product(int nodes_in_domain, std::size_t largest_bytes) {
  return std::make_unique<ProcessorProduct>(nodes_in_domain, largest_bytes);
}

}  // namespace glisson::hardware
#endif
