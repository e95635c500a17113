#pragma once
// Randomness that depends only on a seed and a place, never on the order of computing. So a simulation comes out the
// same, bit for bit, on any number of threads.

#include <cstdint>
#include <Eigen/Core>

namespace glisson {

// A whole number, well mixed, that follows from the seed and the index (splitmix64, Steele et al. 2014).
[[nodiscard]] std::uint64_t mixed(std::uint64_t seed, std::uint64_t index);

// Uniform in (0, 1).
[[nodiscard]] double uniform(std::uint64_t seed, std::uint64_t index);

// Two independent values of the standard normal distribution (Box and Muller 1958).
[[nodiscard]] Eigen::Vector2d normal_pair(std::uint64_t seed, std::uint64_t index);

// A smooth random field in -1..1 that varies over about length_mm: random slopes on a lattice of that pitch, blended
// (Perlin 2002, Improving noise). Its mean is 0, its standard deviation about 0.3.
[[nodiscard]] double smooth_noise(std::uint64_t seed, const Eigen::Vector3d& position_mm, double length_mm);

}  // namespace glisson
