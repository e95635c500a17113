#pragma once
// Passes of messages on an OpenCL device. The sums and differences of 16-bit words are those of the processors, so that
// the answer is the same to the bit. A node's messages go out together, one work-group for a few of them; nodes take
// their turns, two launches each.

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "opencl/session.h"
#include "registration/internal/quantised_field.h"

namespace glisson::registration {

class DevicePasses {
 public:
  // Refused as opencl::Session::open does, and where the device has too little memory.
  static Result<DevicePasses> open(const Quantised<std::uint16_t>& field, const std::string& device_name);

  // As ProcessorPasses.
  Result<void> pass(int number, const Progress& progress);
  void add_later_messages(int s, std::uint32_t* costs) const;
  [[nodiscard]] double taken(int number) const;
  void labelling_was_read(int) {}

 private:
  DevicePasses(const Quantised<std::uint16_t>& field, opencl::Session session);
  void sweep(bool back);

  const Quantised<std::uint16_t>* field_;
  opencl::Session session_;
  opencl::Buffer pairs_, costs_;  // distance and weight together, of nodes and of labels
  opencl::Buffer seed_, messages_, totals_, node_taken_, message_taken_, later_;
  std::vector<std::uint32_t> later_sums_;  // of the last pass: nodes x stride
  double taken_ = 0;
};

}  // namespace glisson::registration
