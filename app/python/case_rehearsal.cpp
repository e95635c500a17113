// A case rehearsed as the window does it, and its liver found on a video.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "base/json.h"
#include "case_methods.h"
#include "casefile/guide_case.h"
#include "casefile/model.h"
#include "choices.h"
#include "documents.h"
#include "guided_dict.h"
#include "long_call.h"
#include "session_held.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace casefile;
using mechanics::MaterialLaw;
using std::filesystem::path;

Session session_of(const Case& self, const std::string& material, const std::string& engine,
                   const std::optional<double>& step_s, const py::object& progress) {
  using mechanics::Engine;
  const bool meshfree =
      chosen<Engine>("engine", engine, {{"fem", Engine::fem}, {"meshfree", Engine::meshfree}}) == Engine::meshfree;
  const auto law = chosen<MaterialLaw>("material", material,
                                       {{"linear", MaterialLaw::linear},
                                        {"corotational", MaterialLaw::corotational},
                                        {"neo-hookean", MaterialLaw::neo_hookean}});
  return {long_call(progress,
                    [&](const Progress& told) {
                      return read_model(self).and_then([&](PatientModel model) {
                        auto setup = rehearsal::with_law(live_rehearsal_setup(std::move(model)).setup, law);
                        if (meshfree) setup.meshfree.emplace();
                        if (step_s) setup.motion.emplace().step_s = *step_s;
                        return rehearsal::SessionEngine::create(std::move(setup), told,
                                                                rehearsal::WithReference::when_asked);
                      });
                    }),
          {}};
}

py::object guide(const Case& self, const path& sequence, const std::optional<Numbers>& pose, std::size_t frame,
                 double noise_mm, const std::string& sequence_sha256, const py::object& lines,
                 const std::optional<path>& folder, const py::object& progress) {
  GuidedFrom from{frame, std::nullopt, noise_mm, sequence_sha256, {}};
  if (!lines.is_none()) {
    auto marked = marked_lines_from(Json::parse(text_of(lines), nullptr, false));
    if (!marked) raise("lines-invalid", "The lines are no document of the format glisson-marked-lines/1.");
    from.lines = *std::move(marked);
  }
  if (pose) {
    from.pose = guidance::rigid_pose({pose->data(), pose->data() + pose->size()});
    if (!from.pose) raise("pose-not-rigid", "The pose is no rigid motion: 16 numbers, row by row.");
  }
  GuidedCase guided = long_call(progress, [&](const Progress& told) {
    return guide_case(self, sequence, from, told).and_then([&](GuidedCase found) -> Result<GuidedCase> {
      if (folder) {
        if (auto written = write_guided_case(*folder, found); !written) return failure(std::move(written.error()));
      }
      return found;
    });
  });
  return guided_dict(std::move(guided.guided.guidance), std::move(guided.answer));
}

}  // namespace

void add_rehearsals(py::class_<Case>& bound) {
  bound
      .def("session", &session_of, py::kw_only(), py::arg("material") = "linear", py::arg("engine") = "fem",
           py::arg("step_s") = py::none(), py::arg("progress") = py::none(),
           R"(A Session of this patient as the window rehearses, so that its recordings replay to the bit.

material  "linear" (small strain), "neo-hookean" or "corotational" (large)
engine    "fem", or "meshfree": linear alone, with finite elements beside it (SessionState.beside_elements)
step_s    in motion, by steps of so many seconds: linear, by "fem" and uncut; tissue that creeps does so

The reference body, where there is one, comes with the command {"compare": True}.
Raises glisson.Error: case-lacks-entry before there is a model; choice-unknown; not-available.)")
      .def("guide", &guide, py::arg("sequence"), py::kw_only(), py::arg("pose") = py::none(), py::arg("frame") = 0,
           py::arg("noise_mm") = 0.5, py::arg("sequence_sha256") = "", py::arg("lines") = py::none(),
           py::arg("folder") = py::none(), py::arg("progress") = py::none(),
           R"(The patient's liver, its structures and landmarks on the frames of a laparoscope's sequence.json.

pose      about where it lies in that frame, scan to camera, mm: (4, 4), or 16 numbers row by row; else searched for
frame     which is answered first, from 0; the others follow from it
noise_mm  standard deviation of each coordinate of the clouds
sequence_sha256   of sequence.json, where another one is to be refused
lines     marked on the model and on frames, as the workspace Guide keeps them (glisson-marked-lines/1)
folder    where given, guidance.json, a mesh a frame and pictures with outlines are written there

A dict, as guide() answers. Raises glisson.Error: pose-not-rigid, lines-invalid, guide-no-frame, guide-other-sequence, case-lacks-entry.)");
}

}  // namespace glisson::python
