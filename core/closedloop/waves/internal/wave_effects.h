#pragma once
// What could be undeclared in waves: the catalogue of an experiment, each effect with its ranges and where its search
// begins. What an effect changes is in wave_state.h.

#include <vector>

#include <Eigen/Core>

#include "closedloop/experiment/effect.h"
#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

// Effects that the experiment could show: no pressure-free ones without three components, none of slices in a single
// one, no layer in a region as narrow as a patch. `typical_radius_mm` is that of its patches, which reach from `low_mm`
// to `high_mm` (patient LPS).
[[nodiscard]] std::vector<Effect> wave_effects(const Elastography& waves, double typical_radius_mm,
                                               const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm);

}  // namespace glisson::closedloop
