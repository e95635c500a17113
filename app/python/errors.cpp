#include "errors.h"

#include <pybind11/pybind11.h>

#include "base/error_file.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

PyObject* error_class = nullptr;  // lives as long as the interpreter

constexpr const char* what_it_is =
    R"(Something from outside that cannot be used, or an answer that was not found.

code       stable, for programs: "volume-file-truncated"
message    what is wrong and where: one English sentence
hint       what to do; may be empty
arguments  the values in the message, in order: a list of texts
file       the file that it is about, or "")";

void set_error(const Error& error) {
  const std::string message = error.message();
  const std::string hint = error.advice();
  const std::string said = message + file_behind(message, error) + (hint.empty() ? "" : " " + hint);
  py::object raised = py::handle(error_class)(said);
  raised.attr("code") = error.code;
  raised.attr("message") = message;
  raised.attr("hint") = hint;
  raised.attr("arguments") = [&] {
    py::list arguments;
    for (const std::string& argument : error.arguments) arguments.append(argument);
    return arguments;
  }();
  raised.attr("file") = error.file.string();
  PyErr_SetObject(error_class, raised.ptr());
}

}  // namespace

void raise(std::string code, std::string text, std::vector<std::string> arguments, std::string hint) {
  throw Raised(Error{std::move(code), std::move(text), std::move(arguments), std::move(hint), {}});
}

void add_errors(py::module_& module) {
  error_class = PyErr_NewExceptionWithDoc("glisson.Error", what_it_is, PyExc_Exception, nullptr);
  if (error_class == nullptr) throw py::error_already_set();
  module.attr("Error") = py::handle(error_class);
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 asks for this signature
  py::register_exception_translator([](std::exception_ptr problem) {
    try {
      if (problem) std::rethrow_exception(problem);
    } catch (const Raised& raised) {
      set_error(raised.error());
    }
  });
}

}  // namespace glisson::python
