#pragma once
// Calls of the core that take long: Python runs on, hears how far they are, and can end them.

#include <pybind11/pybind11.h>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/progress.h"
#include "errors.h"

namespace glisson::python {

// Does the work on a thread of its own while the caller waits without the GIL. Some 50 times a second the caller tells
// `listener` how far the work is, and looks for signals. The listener is None, or a callable that takes the fraction
// done and the stage. What the listener raises, and KeyboardInterrupt, cancel the work and are raised when it has
// ended.
void run_watched(const pybind11::object& listener, const std::function<void(const Progress&)>& work);

// What `work(progress)`, a Result, comes to; its failure is raised.
template <typename Work>
auto long_call(const pybind11::object& listener, Work&& work) {
  std::optional<std::invoke_result_t<Work, const Progress&>> outcome;
  run_watched(listener, [&](const Progress& progress) { outcome.emplace(work(progress)); });
  return or_raise(std::move(*outcome));
}

// The same for work that is done soon and cannot be cancelled, on the caller's thread.
template <typename Work>
auto short_call(Work&& work) {
  auto outcome = [&] {
    const pybind11::gil_scoped_release released;
    return work();
  }();
  return or_raise(std::move(outcome));
}

}  // namespace glisson::python
