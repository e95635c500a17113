#pragma once
// The cuts of a resection plan, as Python gives them.

#include <pybind11/pybind11.h>
#include <vector>

#include "planning/cut.h"

namespace glisson::python {

// One cut, or a list of them, each a dict as plan files have it. Failure: "plan-invalid".
std::vector<planning::Cut> cuts_from(const pybind11::object& cuts);

}  // namespace glisson::python
