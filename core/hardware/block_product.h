#pragma once
// The batched block product y_k = A_k x_k, k = 1..N, of eqs. 6.1 to 6.5: the work that a platform is measured with.
//
// It does 2 operations for each 4 bytes of A and so runs as fast as memory delivers A. The batch is stored tile by
// tile, 16 blocks side by side: entry e of block k at ((k / 16) entries + e) 16 + k % 16. Every load is then a whole
// vector, whatever width Highway chooses for the machine at run time. Every stream is read front to back, and no lane
// is lost to the odd sizes 3 and 81.

#include <cstddef>
#include <memory>
#include <string>

#include "base/result.h"

namespace glisson::hardware {

inline constexpr int block_rows = 3;
inline constexpr std::size_t blocks_in_tile = 16;

// Numbers for each item of a batch, in tiles as above; zero at first, also in the padding of the last tile.
class TiledBatch {
 public:
  TiledBatch(std::size_t items, int entries);
  [[nodiscard]] std::size_t items() const { return items_; }
  [[nodiscard]] int entries() const { return entries_; }
  [[nodiscard]] std::size_t tiles() const { return (items_ + blocks_in_tile - 1) / blocks_in_tile; }
  [[nodiscard]] float* data() { return values_.get(); }
  [[nodiscard]] const float* data() const { return values_.get(); }
  [[nodiscard]] std::size_t size() const { return tiles() * static_cast<std::size_t>(entries_) * blocks_in_tile; }
  [[nodiscard]] float& at(std::size_t item, int entry) { return values_[index_of(item, entry)]; }
  [[nodiscard]] float at(std::size_t item, int entry) const { return values_[index_of(item, entry)]; }

 private:
  struct Free {
    void operator()(float* values) const;
  };
  [[nodiscard]] std::size_t index_of(std::size_t item, int entry) const {
    return (item / blocks_in_tile * static_cast<std::size_t>(entries_) + static_cast<std::size_t>(entry)) *
               blocks_in_tile +
           item % blocks_in_tile;
  }
  std::size_t items_;
  int entries_;
  std::unique_ptr<float[], Free> values_;
};

// The entry of a block's element: column after column, as the product reads them.
[[nodiscard]] constexpr int block_entry(int row, int column) { return column * block_rows + row; }

// y_k = A_k x_k for the first `nodes` blocks (in whole tiles), on base's threads. A has 3 c entries a block, x has c,
// y has 3; all three hold at least `nodes` items.
void multiply_blocks(const TiledBatch& blocks, const TiledBatch& x, std::size_t nodes, TiledBatch& y);

// "AVX3", "SSE4", ...: the instructions that multiply_blocks uses on this machine.
[[nodiscard]] std::string vector_instructions();

// Bytes a second that this machine's memory gives, over arrays far larger than its caches, on base's threads. It is the
// best of a few rounds, and the larger of two figures. One is of y = x + s z, both reads and the write counted once
// (STREAM's triad). The other is of reading alone, which is most of what the product does. Three arrays are used; the
// default is several times the caches of anything worn, and takes about a fifth of a second.
[[nodiscard]] double memory_bandwidth_GB_s(std::size_t bytes_per_array = std::size_t{96} << 20);

// What stays in the processors' last cache does not ask the memory; 0 where the system does not tell.
[[nodiscard]] std::size_t largest_cache_bytes();

// Something that multiplies batches and can be timed: the machine's processors here, an OpenCL device elsewhere.
class ProductKernel {
 public:
  virtual ~ProductKernel() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  // Fills a batch of so many nodes. Refused: more memory than there is ("batch-too-large").
  virtual Result<void> prepare(std::size_t nodes) = 0;
  // Multiplies the first `nodes` of the batch so many times and returns when the last is done.
  virtual Result<void> run(std::size_t nodes, int times) = 0;
};

// On this machine's processors. `largest_bytes` bounds the batch.
std::unique_ptr<ProductKernel> processor_product(int nodes_in_domain, std::size_t largest_bytes);

}  // namespace glisson::hardware
