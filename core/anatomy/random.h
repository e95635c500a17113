#pragma once
// Random numbers that are the same on every machine: the engine is fixed by the standard, its distributions are not,
// so these are our own.

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace glisson::anatomy {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1), of 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // About normal with mean 0 and standard deviation 1, never beyond 3.5: four uniform values, summed and scaled.
  double bell() { return (uniform() + uniform() + uniform() + uniform() - 2) * 1.7320508075688772; }

  template <typename Value>
  void shuffle(std::vector<Value>& values) {  // Fisher and Yates
    for (std::size_t i = values.size(); i > 1; --i) {
      std::swap(values[i - 1], values[static_cast<std::size_t>(uniform() * static_cast<double>(i))]);
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace glisson::anatomy
