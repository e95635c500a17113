// The batched product against the slow, obvious one.

#include "hardware/block_product.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

#include "base/parallel.h"
#include "hardware/workload.h"

namespace glisson::hardware {
namespace {

struct Batch {
  TiledBatch blocks, x, y;
};

Batch random_batch(std::size_t nodes, int nodes_in_domain) {
  const int columns = 3 * nodes_in_domain;
  Batch batch{TiledBatch(nodes, columns * block_rows), TiledBatch(nodes, columns), TiledBatch(nodes, block_rows)};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-1, 1);
  for (std::size_t k = 0; k < nodes; ++k) {
    for (int e = 0; e < columns * block_rows; ++e) batch.blocks.at(k, e) = number(random);
    for (int e = 0; e < columns; ++e) batch.x.at(k, e) = number(random);
  }
  return batch;
}

// y_k = A_k x_k as eqs. 6.1 to 6.5 write it, in double precision.
double slow_entry(const Batch& batch, std::size_t node, int row) {
  double sum = 0;
  for (int column = 0; column < batch.x.entries(); ++column) {
    sum += static_cast<double>(batch.blocks.at(node, block_entry(row, column))) *
           static_cast<double>(batch.x.at(node, column));
  }
  return sum;
}

TEST(BlockProduct, AgreesWithTheSlowOneForEverySizeOfBatchAndBlock) {
  for (const int domain : {1, 27, 125}) {
    for (const std::size_t nodes : {1u, 15u, 16u, 17u, 1000u}) {
      Batch batch = random_batch(nodes, domain);
      multiply_blocks(batch.blocks, batch.x, nodes, batch.y);
      // Each of n additions of numbers below n rounds by at most n x 2^-24: n^2 x 6e-8 is beyond any sum of them.
      const double n = 3.0 * domain;
      const double tolerance = 6e-8 * n * n;
      for (std::size_t k = 0; k < nodes; ++k) {
        for (int row = 0; row < block_rows; ++row)
          ASSERT_NEAR(batch.y.at(k, row), slow_entry(batch, k, row), tolerance) << domain << " " << nodes << " " << k;
      }
    }
  }
}

TEST(BlockProduct, IsTheSameOnOneThreadAndOnAll) {
  Batch batch = random_batch(100000, 1);
  multiply_blocks(batch.blocks, batch.x, 100000, batch.y);
  TiledBatch alone(100000, block_rows);
  set_thread_count(1);
  multiply_blocks(batch.blocks, batch.x, 100000, alone);
  set_thread_count(0);
  EXPECT_TRUE(std::equal(alone.data(), alone.data() + alone.size(), batch.y.data()));
}

TEST(BlockProduct, MultipliesOnlyTheNodesAskedFor) {
  Batch batch = random_batch(64, 1);
  multiply_blocks(batch.blocks, batch.x, 32, batch.y);
  EXPECT_NE(batch.y.at(31, 0), 0);
  EXPECT_EQ(batch.y.at(32, 0), 0);
}

TEST(BlockProduct, StoresWhatTheWorkloadCounts) {
  const auto work = workload_at_resolution(1000, 1e6 / 1600, {27, 200, 4});
  const Batch batch{TiledBatch(1600, 243), TiledBatch(1600, 81), TiledBatch(1600, 3)};
  EXPECT_EQ(work->nodes, 1600);
  EXPECT_EQ(work->product_bytes,
            static_cast<double>(sizeof(float) * (batch.blocks.size() + batch.x.size() + batch.y.size())));
}

TEST(BlockProduct, BatchBeyondTheMemoryAllowedIsRefused) {
  const auto kernel = processor_product(27, std::size_t{1} << 20);
  EXPECT_TRUE(kernel->prepare(100));
  const auto refused = kernel->prepare(1000000000000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "batch-too-large");
}

}  // namespace
}  // namespace glisson::hardware
