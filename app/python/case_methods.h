#pragma once
// What a Case can do in Python, one subject a file.

#include <pybind11/pybind11.h>

#include "casefile/case.h"

namespace glisson::python {

void add_stages(pybind11::class_<casefile::Case>& bound);
void add_maps(pybind11::class_<casefile::Case>& bound);
void add_rehearsals(pybind11::class_<casefile::Case>& bound);
void add_plans(pybind11::class_<casefile::Case>& bound);

inline constexpr const char* stage_note =
    "\n\nprogress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.";

}  // namespace glisson::python
