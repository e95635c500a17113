#pragma once
// The block product on an OpenCL device: a GPU, an accelerator on a headset, or the processors through PoCL. Built with
// -DGLISSON_OPENCL=ON; without it every call is refused with "opencl-not-built".

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/block_product.h"

namespace glisson::hardware {

[[nodiscard]] bool built_with_opencl();

// "Portable Computing Language: pthread-AMD EPYC". Empty where there is none.
Result<std::vector<std::string>> opencl_devices();

// On the first device whose name contains `device_name`. `largest_bytes` bounds the batch, besides the device's memory.
// Refused: no such device ("opencl-no-device", with the list of those there are), and what the driver refuses
// ("opencl-failed", with its number).
Result<std::unique_ptr<ProductKernel>> opencl_product(int nodes_in_domain, std::size_t largest_bytes,
                                                      const std::string& device_name = {});

// One product of given numbers, for comparison with multiply_blocks.
Result<void> multiply_blocks_opencl(const TiledBatch& blocks, const TiledBatch& x, TiledBatch& y,
                                    const std::string& device_name = {});

}  // namespace glisson::hardware
