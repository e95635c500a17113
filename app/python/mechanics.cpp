// A scenario on a mesh: equilibrium or motion.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "documents.h"
#include "landmark_dicts.h"
#include "long_call.h"
#include "mechanics/scenario/scenario_file.h"
#include "mechanics/simulation.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace mechanics;

// The answer, its mesh apart so that Python may keep it alone.
struct Answer {
  std::shared_ptr<geometry::TetMesh> mesh;
  Simulation rest;
};
using SharedAnswer = std::shared_ptr<Answer>;

SharedAnswer answer(const geometry::TetMesh& mesh, const py::object& scenario, const py::object& progress) {
  const Scenario asked = or_raise(parse_scenario(text_of(scenario)));
  Simulation found = long_call(progress, [&](const Progress& told) { return simulate(mesh, asked, {}, told); });
  if (!found.result.converged()) {
    raise("not-converged", "The computation did not converge: {0}", {found.result.why_stopped});
  }
  auto displaced = std::make_shared<geometry::TetMesh>(std::move(found.mesh));
  return std::make_shared<Answer>(Answer{std::move(displaced), std::move(found)});
}

Eigen::Vector3d in_N(const Eigen::Vector3d& force_mN) { return force_mN * 1e-3; }

py::dict reactions_N(const Answer& self) {
  return py::dict("applied"_a = in_N(self.rest.result.applied_force_mN),
                  "fixed"_a = in_N(self.rest.result.fixed_reaction_mN),
                  "foundations"_a = in_N(self.rest.result.foundation_reaction_mN),
                  "ligaments"_a = in_N(self.rest.result.ligament_reaction_mN));
}

py::list steps_of(const Answer& self) {
  py::list steps;
  for (const TimeStep& step : self.rest.steps) {
    steps.append(py::dict("time_s"_a = step.time_s, "landmarks_mm"_a = handed_over(step.landmarks_mm),
                          "largest_strain"_a = step.largest_strain));
  }
  return steps;
}

}  // namespace

py::list landmark_dicts(const std::vector<DisplacedLandmark>& landmarks) {
  py::list list;
  for (const DisplacedLandmark& landmark : landmarks) {
    list.append(py::dict("id"_a = landmark.id, "rest_mm"_a = landmark.rest_mm, "displaced_mm"_a = landmark.displaced_mm,
                         "displacement_mm"_a = landmark.displacement_mm, "outside_by_mm"_a = landmark.outside_by_mm));
  }
  return list;
}

void add_mechanics(py::module_& module) {
  py::class_<Answer, SharedAnswer>(module, "Simulation", "What simulate() found: an equilibrium, or a motion's end.")
      .def_property_readonly(
          "displacement_mm",
          [](const py::object& self) { return view(self.cast<const Answer&>().rest.result.displacement_mm, self); },
          "float64, shape (points, 3): of each point of the mesh, LPS, mm. Without a copy, read only.")
      .def_readonly("mesh", &Answer::mesh,
                    "The rest mesh with point field \"displacement_mm\" and cell fields \"youngs_modulus_kPa\" and "
                    "\"von_mises_kPa\".")
      .def_property_readonly(
          "landmarks", [](const Answer& self) { return landmark_dicts(self.rest.landmarks); },
          "A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm.")
      .def_property_readonly(
          "state", [](const Answer& self) { return std::string(to_string(validity_of(self.rest).state())); },
          "\"within\" what the model is made for, \"outside-of-the-model\" (strained beyond it), or \"unusable\" "
          "(cells "
          "turned inside out).")
      .def_property_readonly(
          "sentence", [](const Answer& self) { return validity_of(self.rest).sentence().message(); },
          "The same, for a person.")
      .def_property_readonly(
          "max_displacement_mm", [](const Answer& self) { return self.rest.result.max_displacement_mm; }, "mm.")
      .def_property_readonly(
          "relative_residual", [](const Answer& self) { return self.rest.result.relative_residual; },
          "|K u - f| / |f| over what is free to move: a ratio.")
      .def_property_readonly(
          "largest_strain", [](const Answer& self) { return self.rest.result.largest_strain; },
          "Largest principal strain in magnitude: a ratio.")
      .def_property_readonly(
          "strain_energy_uJ", [](const Answer& self) { return self.rest.result.strain_energy_uJ; }, "uJ.")
      .def_property_readonly("reactions_N", &reactions_N,
                             "Sums, N: \"applied\" by the loads; by \"fixed\" points, \"foundations\", \"ligaments\".")
      .def_property_readonly("steps", &steps_of,
                             "Of a motion, a dict a step: time_s, landmarks_mm (landmarks, 3), largest_strain.")
      .def_property_readonly(
          "notes", [](const Answer& self) { return self.rest.result.notes; },
          "What a person should know before trusting the numbers.");
  module.def("simulate", &answer, py::arg("mesh"), py::arg("scenario"), py::kw_only(), py::arg("progress") = py::none(),
             R"(A TetMesh under supports, loads and tools: its equilibrium, or its motion.

scenario  a dict (or JSON text) as scenario files have it: lengths mm, forces N, moduli and pressures kPa, densities
          kg/m3; numpy arrays and numbers may stand in it
progress  is told (fraction, stage); KeyboardInterrupt cancels

Raises glisson.Error: scenario-invalid, landmark-outside, modulus-missing, not-converged, not-available, cut-invalid,
cut-misses, document-invalid, and what a model refuses (no supports, no cells).)");
}

}  // namespace glisson::python
