#pragma once
// How much of a liver is in which segment, tumour and state: voxels are counted in stretches, not one by one.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/internal/cut_off.h"
#include "planning/planner.h"

namespace glisson::planning {

inline constexpr std::size_t segments_and_none = 9;

// Voxels one after the other that hang on the same points and are of the same segment: counted at once where none goes.
struct Stretch {
  std::uint32_t first = 0;  // the number of its first voxel
  std::array<std::uint32_t, 2> point{};
  std::uint16_t voxels = 0, trusted = 0;
  float kPa = 0;           // summed
  std::uint8_t place = 0;  // in Counts::voxels, of what no cut changes
};

// Of each voxel of an organ, what no cut changes.
struct VoxelPlaces {
  const std::vector<std::uint8_t>& segment;  // 0: none
  const std::vector<std::uint8_t>& tumour;   // 0: none
  // The point of the portal and of the hepatic tree that it hangs on; empty where that tree is not known.
  const std::array<std::vector<std::uint32_t>, 2>& point;
  const std::vector<float>& trusted_kPa;  // 0 where it is not to be trusted; empty: no map
  std::size_t points;                     // how many there are; also means none
};
[[nodiscard]] std::vector<Stretch> stretches_of(const VoxelPlaces& voxels);

// Voxels counted by segment, tumour, removed, and whether either vessel is cut off.
struct Counts {
  // What a place in `voxels` is made of.
  static constexpr std::size_t segment = 16, tumour = 8, removed = 4, starved = 2, held_up = 1;
  struct Key {
    std::size_t segment;
    bool tumour, removed, starved, held_up;
  };
  std::array<std::size_t, segments_and_none * segment> voxels{};
  std::array<double, segments_and_none> kPa{};  // summed over tissue that stays and is trusted
  std::array<std::size_t, segments_and_none> trusted{};
  std::vector<std::size_t> affected;  // of each place of a cut, what stays; the last: what hangs on no cut

  // How many of those for which `counts(key)`.
  template <typename Asked>
  [[nodiscard]] std::size_t of(const Asked& counts) const {
    std::size_t sum = 0;
    for (std::size_t n = 0; n < voxels.size(); ++n) {
      const Key key{n / segment, (n & tumour) != 0, (n & removed) != 0, (n & starved) != 0, (n & held_up) != 0};
      if (counts(key)) sum += voxels[n];
    }
    return sum;
  }
};

// `removed`: of each voxel, 0 where it stays. `trusted_kPa`: as in VoxelPlaces.
[[nodiscard]] Counts counted(const std::vector<Stretch>& stretches, const std::vector<std::uint8_t>& removed,
                             const CutOff& off, const std::vector<float>& trusted_kPa);

// Voxels of tissue and the stiffness of those that are to be trusted.
struct TissueSum {
  std::size_t voxels = 0, trusted = 0;
  double kPa = 0;  // summed

  void add(float trusted_kPa) {
    ++voxels;
    if (trusted_kPa > 0) kPa += static_cast<double>(trusted_kPa), ++trusted;
  }
  [[nodiscard]] Tissue tissue(double voxel_ml) const;
};

}  // namespace glisson::planning
