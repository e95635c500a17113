#pragma once
// Landmarks that moved, as Python sees them.

#include <pybind11/pybind11.h>
#include <vector>

#include "mechanics/simulation.h"

namespace glisson::python {

// A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm.
pybind11::list landmark_dicts(const std::vector<mechanics::DisplacedLandmark>& landmarks);

}  // namespace glisson::python
