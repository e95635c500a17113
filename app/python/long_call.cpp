#include "long_call.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace py = pybind11;

namespace glisson::python {
namespace {

struct Report {
  double fraction;
  std::string stage;
};

// What the worker says and the caller hears. Of several reports between two looks the last counts.
struct Shared {
  std::mutex mutex;
  std::condition_variable ended;
  std::optional<Report> latest;
  bool is_done = false;
};

std::exception_ptr look_around(const py::object& listener, const std::optional<Report>& report) {
  const py::gil_scoped_acquire held;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (report && !listener.is_none()) listener(report->fraction, report->stage);
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

// The first thing that Python raised, if any, once the work has ended.
std::exception_ptr watch(Shared& shared, std::stop_source& stop, const py::object& listener) {
  std::exception_ptr raised;
  for (bool is_done = false; !is_done;) {
    std::optional<Report> report;
    {
      std::unique_lock lock(shared.mutex);
      is_done = shared.ended.wait_for(lock, std::chrono::milliseconds(20), [&] { return shared.is_done; });
      report = std::exchange(shared.latest, std::nullopt);
    }
    if (!raised) raised = look_around(listener, report);
    if (raised) stop.request_stop();
  }
  return raised;
}

}  // namespace

void run_watched(const py::object& listener, const std::function<void(const Progress&)>& work) {
  Shared shared;
  std::stop_source stop;
  const Progress progress(
      [&shared](double fraction, std::string_view stage) {
        const std::scoped_lock lock(shared.mutex);
        shared.latest = Report{fraction, std::string(stage)};
      },
      stop.get_token());
  std::exception_ptr defect, raised;
  {
    const py::gil_scoped_release released;
    std::thread worker([&] {
      try {
        work(progress);
      } catch (...) {
        defect = std::current_exception();
      }
      const std::scoped_lock lock(shared.mutex);
      shared.is_done = true;
      shared.ended.notify_one();
    });
    raised = watch(shared, stop, listener);
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (defect) std::rethrow_exception(defect);
}

}  // namespace glisson::python
