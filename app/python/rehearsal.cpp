// Live rehearsals: a force on a placed tool, and sessions with tools in contact, recorded and replayed.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "documents.h"
#include "elastography/cell_stiffness.h"
#include "landmark_dicts.h"
#include "long_call.h"
#include "mechanics/scenario/scenario_file.h"
#include "rehearsal/liver_supports.h"
#include "rehearsal/session.h"
#include "rehearsal/static_rehearsal.h"
#include "rehearsal/tool_presets.h"
#include "rooms.h"
#include "session_held.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace rehearsal;
using SharedState = std::shared_ptr<const SessionState>;

RehearsalSetup setup_of(const geometry::TetMesh& mesh, const py::object& scenario,
                        const std::optional<double>& reference_youngs_kPa) {
  const mechanics::Scenario asked = or_raise(mechanics::parse_scenario(text_of(scenario)));
  RehearsalSetup setup = or_raise(rehearsal_setup(mesh, asked));
  setup.reference_youngs_kPa = reference_youngs_kPa;
  return setup;
}

void add_placement(py::module_& module) {
  module.def(
      "mark_attachments",
      [](const geometry::TetMesh& liver) {
        auto marked = std::make_shared<geometry::TetMesh>(liver);
        short_call([&] { return mark_attachments(*marked); });
        return marked;
      },
      py::arg("liver"),
      "The liver with the point fields \"bare_area\" and \"diaphragm\" (0 or 1), found by its shape: what holds it in "
      "the body.\n\nRaises glisson.Error: liver-no-attachment.");
  module.def(
      "usual_supports",
      [] {
        mechanics::Scenario scenario;
        scenario.supports = usual_supports();
        return python_of_text(mechanics::scenario_text(scenario))["supports"].cast<py::list>();
      },
      "The supports of a scenario that go with mark_attachments: the bare area held, the diaphragm on a foundation.");
  module.def(
      "hoist_segment_vi",
      [](const geometry::TetMesh& liver) {
        const ToolPlacement placed = short_call([&] { return hoist_segment_vi(liver); });
        py::dict dict;
        dict["tool"] = placed.preset.id;
        dict["center_mm"] = placed.center_mm;
        dict["direction"] = placed.direction;
        dict["radius_mm"] = placed.preset.radius_mm;
        dict["usual_force_N"] = placed.preset.usual_force_N;
        return dict;
      },
      py::arg("liver"),
      "Where a retractor lifts segment VI: a dict of tool, center_mm (LPS), direction (unit), radius_mm, "
      "usual_force_N. A scenario's load: {\"tool\": {\"center_mm\": ..., \"radius_mm\": ..., \"force_N\": ...}}.");
}

// ---- a tool placed, whose force is free

// Both bodies at once: who gives an atlas compares with it.
Result<StaticRehearsal> with_both_bodies(RehearsalSetup setup, const Progress& progress) {
  return StaticRehearsal::create(std::move(setup), progress.part(0, 0.5)).and_then([&](StaticRehearsal made) {
    return made.make_reference(progress.part(0.5, 1)).map([&] { return std::move(made); });
  });
}

void add_static_rehearsal(py::module_& module) {
  py::class_<RehearsalState>(module, "RehearsalState", "The body under a force on a placed tool.")
      .def_property_readonly(
          "surface_mm",
          [](const py::object& self) { return view(self.cast<const RehearsalState&>().patient.surface_mm, self); },
          "float64, shape (points, 3): the displaced points of the rehearsal's surface, LPS, mm. Without a copy.")
      .def_property_readonly(
          "landmarks", [](const RehearsalState& self) { return landmark_dicts(self.patient.landmarks); },
          "A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm.")
      .def_property_readonly(
          "max_displacement_mm", [](const RehearsalState& self) { return self.patient.max_displacement_mm; },
          "Over the surface, mm.")
      .def_readonly("max_difference_mm", &RehearsalState::max_difference_mm,
                    "Between patient and atlas over the surface, mm; 0 without an atlas.")
      .def_readonly("force_N", &RehearsalState::force_N, "(3,), N.")
      .def_readonly("relative_residual", &RehearsalState::relative_residual,
                    "The larger of the solves that it is made from: a ratio.")
      .def_property_readonly(
          "state", [](const RehearsalState& self) { return std::string(to_string(self.validity.state())); },
          "As Simulation.state.")
      .def_readonly("answer_ms", &RehearsalState::answer_ms, "What the answer took, ms.");
  py::class_<PlacedTool>(module, "PlacedTool", "A tool on the surface; only its force is free.")
      .def(
          "answer",
          [](const PlacedTool& self, const Numbers& force_N) {
            const Eigen::Vector3d force = vector_from(force_N, "force_N");
            const py::gil_scoped_release released;
            return self.answer(force);
          },
          py::arg("force_N"), "The body under that force (3,), N, LPS: well under a millisecond.")
      .def(
          "displacement_mm",
          [](const PlacedTool& self, const Numbers& force_N) {
            const Eigen::Vector3d force = vector_from(force_N, "force_N");
            return handed_over(self.patient_displacement_mm(force));
          },
          py::arg("force_N"), "float64, shape (points, 3): of every point of the mesh, mm.")
      .def_property_readonly("center_mm", &PlacedTool::center_mm, "(3,), LPS, mm.")
      .def_property_readonly("radius_mm", &PlacedTool::radius_mm, "Of the disc that it touches, mm.")
      .def_property_readonly("touched_faces", &PlacedTool::touched_faces, "Faces of the surface under it.");
  py::class_<StaticRehearsal>(module, "StaticRehearsal",
                              R"(A liver ready for a tool: its stiffness is factorised once.

Made of a TetMesh and a scenario (supports, moduli, landmarks; its loads stand), as simulate() takes it. With
atlas_youngs_kPa a reference body of that one modulus is computed beside it.

Raises glisson.Error: as simulate, landmark-outside; place_tool: tool-touches-nothing, not-converged.)")
      .def(py::init([](const geometry::TetMesh& mesh, const py::object& scenario,
                       const std::optional<double>& reference_youngs_kPa, const py::object& progress) {
             RehearsalSetup setup = setup_of(mesh, scenario, reference_youngs_kPa);
             return long_call(progress, [&](const Progress& told) { return with_both_bodies(std::move(setup), told); });
           }),
           py::arg("mesh"), py::arg("scenario"), py::kw_only(), py::arg("atlas_youngs_kPa") = py::none(),
           py::arg("progress") = py::none())
      .def(
          "place_tool",
          [](const StaticRehearsal& self, const Numbers& center_mm, double radius_mm) {
            const Eigen::Vector3d center = vector_from(center_mm, "center_mm");
            return short_call([&] { return self.place_tool(center, radius_mm); });
          },
          py::arg("center_mm"), py::arg("radius_mm"),
          "A PlacedTool on the disc of surface around that place (LPS, mm).")
      .def_property_readonly(
          "surface", [](const StaticRehearsal& self) { return std::make_shared<geometry::Surface>(self.surface()); },
          "The outer surface at rest: a copy.");
}

// ---- a session

Recording one_command(const py::object& command) {
  py::list commands;
  commands.append(command);
  py::dict document;
  document["format"] = "glisson-session/1";
  document["commands"] = commands;
  return or_raise(parse_recording(text_of(document)));
}

SharedState step(Session& session, const py::object& command) {
  const Recording asked = one_command(command);
  {
    const py::gil_scoped_release released;
    session.engine.step(asked.front().first);
  }
  SharedState state = session.engine.shared_state();
  session.recording.emplace_back(asked.front().first, state->digest);
  return state;
}

std::optional<std::size_t> replayed(Session& session, const py::object& recording, const py::object& progress) {
  const Recording asked = or_raise(parse_recording(text_of(recording)));
  return long_call(progress, [&](const Progress& told) -> Result<std::optional<std::size_t>> {
    std::optional<std::size_t> first_other;
    for (std::size_t n = 0; n < asked.size(); ++n) {
      told.report(double(n) / double(asked.size()), "Moving the tools");
      if (told.cancelled()) return cancelled();
      const auto& [command, digest] = asked[n];
      const SessionState& state = session.engine.step(command);
      session.recording.emplace_back(command, state.digest);
      if (!first_other && !digest.empty() && digest != state.digest) first_other = n;
    }
    return first_other;
  });
}

py::list tools_of(const SessionState& state) {
  py::list tools;
  for (const mechanics::ToolContact& tool : state.patient_step.tools) {
    py::dict dict;
    dict["id"] = tool.id;
    dict["force_N"] = Eigen::Vector3d(tool.force_mN * 1e-3);
    dict["contacts"] = tool.contacts;
    dict["advance_mm"] = tool.advance_mm;
    dict["penetration_mm"] = tool.penetration_mm;
    tools.append(dict);
  }
  return tools;
}

// A state as Python keeps it; pybind11's holders point to what may be changed, and a state never is.
struct State {
  SharedState held;
};

void add_session(py::module_& module) {
  py::class_<State>(module, "SessionState", "A session after a command.")
      .def_property_readonly(
          "number", [](const State& self) { return self.held->number; }, "Of the commands that led here.")
      .def_property_readonly(
          "surface_mm",
          [](const py::object& self) { return view(self.cast<const State&>().held->patient.surface_mm, self); },
          "float64, shape (points, 3): displaced points of the session's surface, LPS, mm. Without a copy.")
      .def_property_readonly(
          "landmarks", [](const State& self) { return landmark_dicts(self.held->patient.landmarks); },
          "A dict each: id, rest_mm, displaced_mm, displacement_mm, outside_by_mm.")
      .def_property_readonly(
          "tools", [](const State& self) { return tools_of(*self.held); },
          "A dict each: id, force_N (on the body), contacts, advance_mm, penetration_mm.")
      .def_property_readonly(
          "max_displacement_mm", [](const State& self) { return self.held->patient.max_displacement_mm; },
          "Over the surface, mm.")
      .def_property_readonly(
          "state", [](const State& self) { return std::string(to_string(self.held->validity.state())); },
          "As Simulation.state; \"not-converged\" too.")
      .def_property_readonly(
          "refused", [](const State& self) { return self.held->refused; },
          "Why the last command was not carried out; empty where it was.")
      .def_property_readonly(
          "settled", [](const State& self) { return self.held->settled; }, "At rest, which at large strain takes time.")
      .def_property_readonly(
          "beside_elements",
          [](const State& self) -> py::object {
            const auto& beside = self.held->beside_elements;
            if (!beside) return py::none();
            py::dict dict;
            dict["landmarks_mm"] = beside->landmarks_mm;
            dict["surface_mm"] = beside->surface_mm;
            dict["meshfree_ms"] = beside->meshfree_ms;
            dict["ms"] = beside->elements_ms;
            if (beside->largest_opening_mm) dict["largest_opening_mm"] = *beside->largest_opening_mm;
            return dict;
          },
          "Of the meshfree engine: how far finite elements are apart at most, and what both took; None otherwise.")
      .def_property_readonly(
          "step_ms", [](const State& self) { return self.held->step_ms; }, "What the command took, ms.")
      .def_property_readonly(
          "digest", [](const State& self) { return self.held->digest; },
          "SHA-256 of every displacement and force: equal for equal bits.");
  py::class_<Session>(module, "Session",
                      R"(A rehearsal with tools in contact, command by command, recorded.

Made of a TetMesh and a scenario as StaticRehearsal is. The same commands give the same states, to the bit.)")
      .def(py::init([](const geometry::TetMesh& mesh, const py::object& scenario,
                       const std::optional<double>& reference_youngs_kPa, const py::object& progress) {
             RehearsalSetup setup = setup_of(mesh, scenario, reference_youngs_kPa);
             return Session{
                 long_call(progress,
                           [&](const Progress& told) { return SessionEngine::create(std::move(setup), told); }),
                 {}};
           }),
           py::arg("mesh"), py::arg("scenario"), py::kw_only(), py::arg("atlas_youngs_kPa") = py::none(),
           py::arg("progress") = py::none())
      .def(
          "step", [](Session& self, const py::object& command) { return State{step(self, command)}; },
          py::arg("command"),
          R"(Carries a command out and returns the SessionState: a dict as files of sessions have it.

{"hold": {"id": "probe", "shape": "palpation-probe", "position_mm": [...], "direction": [...], "push_mN": 500}}
{"hold": {"id": "jaws", "grasp": {"at_rest_mm": [...], "radius_mm": 5}, "displacement_mm": [...]}}
{"release": "probe"}, {"undo": True}, {"settle": True}

Raises glisson.Error: session-invalid, document-invalid. What cannot be carried out is said in `refused`.)")
      .def_property_readonly(
          "state", [](const Session& self) { return State{self.engine.shared_state()}; }, "The present one.")
      .def_property_readonly(
          "surface", [](const Session& self) { return std::make_shared<geometry::Surface>(self.engine.surface()); },
          "The outer surface at rest: a copy.")
      .def(
          "displacement_mm",
          [](const Session& self) {
            auto result = short_call([&] { return self.engine.whole_result(); });
            return handed_over(std::move(result.displacement_mm));
          },
          "float64, shape (points, 3): of every point of the mesh in the present state, mm, by a solve of its own.")
      .def(
          "recording", [](const Session& self) { return python_of_text(recording_text(self.recording)); },
          "What was carried out with each state's digest, as files of sessions have it.")
      .def("replay", &replayed, py::arg("recording"), py::kw_only(), py::arg("progress") = py::none(),
           "Carries all commands of a recording out (a dict, or its JSON text). The first, from 0, whose state is not "
           "the one recorded; None where all are.\n\nRaises glisson.Error: session-invalid.");
}

}  // namespace

void add_rehearsal(py::module_& module) {
  add_placement(module);
  add_static_rehearsal(module);
  add_session(module);
  module.def(
      "atlas_youngs_kPa",
      [](double poisson_ratio) {
        return elastography::reference_youngs_kPa(elastography::PopulationMean::dissertation_cohort, poisson_ratio);
      },
      py::arg("poisson_ratio") = usual_poisson_ratio,
      "Young's modulus (kPa) of healthy adults' livers: a mean shear modulus of 2.1 kPa.");
}

}  // namespace glisson::python
