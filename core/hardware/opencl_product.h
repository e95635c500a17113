#pragma once
// The block product on an OpenCL device: a GPU, an accelerator on a headset, or the processors through PoCL. Refused
// where there is none, as opencl::Session::open says.

#include <memory>
#include <string>

#include "base/result.h"
#include "hardware/block_product.h"

namespace glisson::hardware {

// On the first device whose name contains `device_name`. `largest_bytes` bounds the batch, besides the device's memory.
Result<std::unique_ptr<ProductKernel>> opencl_product(int nodes_in_domain, std::size_t largest_bytes,
                                                      const std::string& device_name = {});

// One product of given numbers, for comparison with multiply_blocks.
Result<void> multiply_blocks_opencl(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y,
                                    const std::string& device_name = {});

}  // namespace glisson::hardware
