#pragma once
// JSON documents of the core as Python's own values, and back.

#include <pybind11/pybind11.h>
#include <string>

#include "base/json_forward.h"

namespace glisson::python {

[[nodiscard]] pybind11::object python_of(const Json& document);
[[nodiscard]] pybind11::object python_of_text(const std::string& json);

// A text is taken as JSON; whatever else as what json.dumps makes of it. Failure: "document-invalid".
[[nodiscard]] std::string text_of(const pybind11::object& document);

}  // namespace glisson::python
