#pragma once
// Guidance answered, as Python has it.

#include <pybind11/pybind11.h>

#include "guidance/guidance_answer.h"

namespace glisson::python {

// The document as it is written to files, with each frame's arrays and the mesh.
pybind11::object guided_dict(guidance::GuidanceCase asked, guidance::GuidanceAnswer answer);

}  // namespace glisson::python
