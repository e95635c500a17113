#pragma once
// Failures of the core as the Python exception glisson.Error, with the code, the sentence, the hint and the arguments.

#include <exception>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/result.h"

namespace pybind11 {
class module_;
}

namespace glisson::python {

// Becomes glisson.Error where it leaves the module.
class Raised : public std::exception {
 public:
  explicit Raised(Error error) : error_(std::move(error)), message_(error_.message()) {}
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
  std::string message_;
};

// The value, or glisson.Error.
template <typename T>
T or_raise(Result<T> result) {
  if (!result) throw Raised(std::move(result.error()));
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

[[noreturn]] void raise(std::string code, std::string text, std::vector<std::string> arguments = {},
                        std::string hint = {});

void add_errors(pybind11::module_& module);

}  // namespace glisson::python
