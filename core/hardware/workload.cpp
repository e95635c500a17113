#include "hardware/workload.h"

#include <fmt/format.h>
#include <cmath>

namespace glisson::hardware {
namespace {

Result<void> check(double volume_cm3, double resolution_mm3, const WorkloadOptions& options) {
  // Written so that NaN is refused as well.
  if (!(volume_cm3 >= smallest_liver_cm3 && volume_cm3 <= largest_liver_cm3)) {
    return failure(Error{"volume-not-a-liver",
                         GLISSON_TEXT("A liver of {0} cm3 is outside {1} to {2} cm3."),
                         {fmt::format("{:g}", volume_cm3), fmt::format("{:g}", smallest_liver_cm3),
                          fmt::format("{:g}", largest_liver_cm3)},
                         GLISSON_TEXT("Check the volume and its unit: 1 litre is 1000 cm3."),
                         {}});
  }
  if (!(resolution_mm3 > 0 && std::isfinite(resolution_mm3))) {
    return failure("resolution-invalid", GLISSON_TEXT("A node cannot stand for {0} mm3."),
                   {fmt::format("{:g}", resolution_mm3)});
  }
  if (options.nodes_in_domain != 1 && options.nodes_in_domain != 27 && options.nodes_in_domain != 125) {
    return failure(Error{"domain-invalid",
                         GLISSON_TEXT("A domain of influence of {0} nodes is no cube around a node."),
                         {std::to_string(options.nodes_in_domain)},
                         GLISSON_TEXT("Use 1, 27 or 125."),
                         {}});
  }
  if (options.products_per_frame < 1 || options.products_per_frame > 100000) {
    return failure("products-invalid", GLISSON_TEXT("{0} products a frame are not between 1 and 100000."),
                   {std::to_string(options.products_per_frame)});
  }
  return {};
}

}  // namespace

Result<Workload> workload_at_resolution(double volume_cm3, double resolution_mm3, const WorkloadOptions& options) {
  if (const auto checked = check(volume_cm3, resolution_mm3, options); !checked) return failure(checked.error());
  Workload work;
  work.resolution_mm3 = resolution_mm3;
  work.nodes = std::ceil(volume_cm3 * 1e3 / resolution_mm3);
  work.block_columns = 3 * options.nodes_in_domain;
  work.products_per_frame = options.products_per_frame;
  const double entries = static_cast<double>(work.block_rows) * work.block_columns;
  work.bytes_per_node = (entries + work.block_columns + work.block_rows) * options.bytes_per_value;
  work.product_flops = 2 * entries * work.nodes;
  work.product_bytes = work.bytes_per_node * work.nodes;
  work.frame_flops = work.product_flops * options.products_per_frame;
  work.frame_bytes = work.product_bytes * options.products_per_frame;
  return work;
}

Result<Workload> workload_for_accuracy(double volume_cm3, double accuracy_mm, const ConvergenceCurve& curve,
                                       const WorkloadOptions& options) {
  const auto resolution_mm3 = resolution_for_accuracy_mm3(curve, accuracy_mm);
  if (!resolution_mm3) return failure(resolution_mm3.error());
  return workload_at_resolution(volume_cm3, *resolution_mm3, options);
}

}  // namespace glisson::hardware
