// In place of opencl_product.cpp where OpenCL was not asked for.

#include "hardware/opencl_product.h"

namespace glisson::hardware {
namespace {

Failure not_built() {
  return failure(Error{"opencl-not-built",
                       GLISSON_TEXT("This build has no OpenCL."),
                       {},
                       GLISSON_TEXT("Build with -DGLISSON_OPENCL=ON."),
                       {}});
}

}  // namespace

bool built_with_opencl() { return false; }

Result<std::vector<std::string>> opencl_devices() { return not_built(); }

Result<std::unique_ptr<ProductKernel>> opencl_product(int, std::size_t, const std::string&) { return not_built(); }

Result<void> multiply_blocks_opencl(const TiledBatch&, const TiledBatch&, TiledBatch&, const std::string&) {
  return not_built();
}

}  // namespace glisson::hardware
