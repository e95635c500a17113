#pragma once
// Couinaud's segments as Python sees them.

#include <pybind11/pybind11.h>

#include "vasculature/couinaud.h"

namespace glisson::python {

// segment (LabelMap, 1 to 8), doubt (uint8, [i, j, k], percent), volume_ml and confidence (9: all, then each), from.
pybind11::dict segment_dict(vasculature::CouinaudSegments segments);

}  // namespace glisson::python
