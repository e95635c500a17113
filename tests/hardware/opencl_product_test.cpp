// The OpenCL form against the processors', on whatever device there is (PoCL where no other).

#include "hardware/opencl_product.h"

#include <gmock/gmock.h>
#include <random>

#include "opencl/session.h"
#include "support/opencl.h"

namespace glisson::hardware {
namespace {

TEST(OpenClProduct, AgreesWithTheProcessors) {
  GLISSON_NEEDS_OPENCL();
  std::mt19937 random(11);
  std::uniform_real_distribution<float> number(-1, 1);
  for (const int domain : {1, 27}) {
    for (const std::size_t nodes : {1u, 100u, 5000u}) {
      const int columns = 3 * domain;
      TiledBatch blocks(nodes, columns * block_rows);
      TiledBatch x(nodes, columns);
      for (std::size_t i = 0; i < blocks.size(); ++i) blocks.data()[i] = number(random);
      for (std::size_t i = 0; i < x.size(); ++i) x.data()[i] = number(random);
      TiledBatch here(nodes, block_rows);
      TiledBatch there(nodes, block_rows);
      multiply_blocks(blocks, x, nodes, here);
      const auto multiplied = multiply_blocks_opencl(blocks, x, there);
      ASSERT_TRUE(multiplied) << multiplied.error().message();
      for (std::size_t k = 0; k < nodes; ++k) {
        // The same additions in the same order; a device may fuse differently: n roundings of sums below n.
        for (int row = 0; row < block_rows; ++row)
          ASSERT_NEAR(here.at(k, row), there.at(k, row), 6e-8 * columns * columns) << k;
      }
    }
  }
}

TEST(OpenClProduct, RunsAsAKernelToBeMeasured) {
  GLISSON_NEEDS_OPENCL();
  const auto kernel = opencl_product(1, std::size_t{64} << 20);
  ASSERT_TRUE(kernel) << kernel.error().message();
  EXPECT_THAT((*kernel)->name(), testing::StartsWith("OpenCL, "));
  ASSERT_TRUE((*kernel)->prepare(20000));
  EXPECT_TRUE((*kernel)->run(20000, 3));
  EXPECT_EQ((*kernel)->prepare(1000000000).error().code, "batch-too-large");
}

TEST(OpenClProduct, UnknownDeviceIsRefusedWithThoseThereAre) {
  GLISSON_NEEDS_OPENCL();
  const auto refused = opencl_product(1, std::size_t{64} << 20, "no such device");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "opencl-no-device");
  EXPECT_THAT(refused.error().advice(), testing::HasSubstr(opencl::devices().front()));
}

}  // namespace
}  // namespace glisson::hardware
