#pragma once
// What is pressed in `study palpation`, and how it was scanned before: fixed before any trial was looked at.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/tissue.h"

namespace glisson::studies {

// A round gel with its axis along z and its bottom at z = 0: two strata of half the height each, and a ball of another
// gel in the middle of its height, on the axis. Moduli are Young's in kPa, for usual_poisson_ratio.
struct PalpationSpecimen {
  std::string name;
  double upper_kPa = 0, lower_kPa = 0;
  double inclusion_kPa = 0, inclusion_radius_mm = 0;  // 0: none
  double radius_mm = 112.5, height_mm = 26;           // table 4.2

  [[nodiscard]] bool in_inclusion(const Eigen::Vector3d& at_mm) const {
    return (at_mm - Eigen::Vector3d(0, 0, height_mm / 2)).norm() < inclusion_radius_mm;
  }
  [[nodiscard]] double youngs_kPa(const Eigen::Vector3d& at_mm) const {
    if (in_inclusion(at_mm)) return inclusion_kPa;
    return at_mm.z() > height_mm / 2 ? upper_kPa : lower_kPa;
  }
};

// The compounds as section 4.6's testing machine found them: the medians of table 4.5's samples.
constexpr double machine_soft_kPa = 18.163;
constexpr double machine_stiff_kPa = 35.07;

// "A", "B", "AB" of tables 4.2 and 4.3; "A+b" and "B+a", with a ball 18 mm across of the other compound.
[[nodiscard]] const std::vector<PalpationSpecimen>& palpation_specimens();

// The simulated elastography of the gels: waves of 60 Hz in voxels of 2 mm, three directions, four instants, 2 rad at
// the strongest, noise of 0.1 rad in each image, a tenth of the storage modulus lost.
struct PalpationScan {
  double frequency_Hz = 60;
  double voxel_mm = 2;
  int instants = 4;
  double amplitude_rad = 2, noise_rad = 0.1;
  double loss = 0.1;
  unsigned seed = 1;
};

}  // namespace glisson::studies
