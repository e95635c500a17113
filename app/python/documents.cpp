#include "documents.h"

#include "base/json.h"
#include "errors.h"

namespace py = pybind11;

namespace glisson::python {

py::object python_of_text(const std::string& json) { return py::module_::import("json").attr("loads")(json); }

py::object python_of(const Json& document) {
  return python_of_text(null_where_not_finite(document).dump(-1, ' ', false, Json::error_handler_t::replace));
}

// numpy's arrays and numbers are written as lists and numbers.
std::string text_of(const py::object& document) {
  if (py::isinstance<py::str>(document)) return document.cast<std::string>();
  const py::cpp_function in_lists([](const py::object& value) {
    if (!py::hasattr(value, "tolist")) {
      throw py::type_error("a " + py::str(value.get_type().attr("__name__")).cast<std::string>() +
                           " is nothing that JSON can hold");
    }
    return value.attr("tolist")();
  });
  try {
    return py::module_::import("json")
        .attr("dumps")(document, py::arg("default") = in_lists, py::arg("allow_nan") = false)
        .cast<std::string>();
  } catch (const py::error_already_set& problem) {
    if (!problem.matches(PyExc_TypeError) && !problem.matches(PyExc_ValueError)) throw;
    raise("document-invalid", "The document cannot be written as JSON: {0}.",
          {py::str(problem.value()).cast<std::string>()});
  }
}

}  // namespace glisson::python
