// glisson._core: the core's values and functions for Python. The package glisson shows it under its own name.

#include <pybind11/pybind11.h>

#include "base/files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "errors.h"
#include "rooms.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  using namespace glisson;
  const py::object own_name = module.attr("__name__");
  module.attr("__name__") = "glisson";  // that classes and functions say they are of

  module.attr("__version__") = version();
  python::add_errors(module);
  module.def(
      "set_thread_count",
      [](int threads) {
        if (threads < 0) python::raise("threads-invalid", "There cannot be {0} threads.", {std::to_string(threads)});
        set_thread_count(threads);
      },
      py::arg("threads"), "How many threads loops use; 0 means as many as the machine has.");
  python::add_imaging(module);
  python::add_geometry(module);
  python::add_segmentation(module);
  python::add_elastography(module);
  python::add_mechanics(module);
  python::add_hardware(module);
  python::add_meshing(module);
  python::add_registration(module);
  python::add_vision(module);
  python::add_registration_quality(module);
  python::add_vasculature(module);
  python::add_planning(module);
  python::add_rehearsal(module);
  python::add_guidance(module);
  python::add_closedloop(module);
  python::add_casefile(module);
  python::add_growth(module);
  python::add_scene(module);
  python::add_report(module);

  module.attr("__name__") = own_name;
}
