// Where an organ and its hidden targets are in a camera's frames.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "base/json.h"
#include "documents.h"
#include "guidance/guidance_answer.h"
#include "guidance/guidance_file.h"
#include "guided_dict.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

struct Guided {
  guidance::GuidanceCase asked;
  guidance::GuidanceAnswer answer;
};

Result<Guided> guided(const std::filesystem::path& file, const Progress& progress) {
  auto asked = guidance::read_guidance(file);
  if (!asked) return failure(std::move(asked.error()));
  auto answer = guidance::answer(*asked, progress);
  if (!answer) return failure(Error(answer.error()).in_file(file));
  return Guided{*std::move(asked), *std::move(answer)};
}

}  // namespace

py::object guided_dict(guidance::GuidanceCase asked, guidance::GuidanceAnswer answer) {
  const py::object document = python_of(guidance::answer_json(asked, answer));
  const py::list frames = document["frames"];
  for (std::size_t n = 0; n < answer.frames.size(); ++n) {
    guidance::ElasticPlacement& placed = answer.frames[n].placement;
    if (!placed.converged) continue;
    const py::object frame = frames[n];
    frame["pose"] = Eigen::Matrix4d(placed.pose.matrix());
    frame["displacement_mm"] = handed_over(std::move(placed.displacement_mm));
  }
  document["mesh"] = std::make_shared<geometry::TetMesh>(std::move(asked.mesh));
  document["notes"] = answer.notes;
  return document;
}

void add_guidance(py::module_& module) {
  module.def(
      "guide",
      [](const std::filesystem::path& file, const py::object& progress) {
        Guided found = long_call(progress, [&](const Progress& told) { return guided(file, told); });
        return guided_dict(std::move(found.asked), std::move(found.answer));
      },
      py::arg("file"), py::kw_only(), py::arg("progress") = py::none(),
      R"(The organ and its hidden targets in each frame of a guidance case (guidance.json, "glisson-guidance/1").

A dict: mesh (the TetMesh at rest); frames, a dict each: id, converged (where not, a note says why), residual_rms_mm,
seconds; and where it did: pose (4 x 4, scan to camera, mm); displacement_mm (points, 3), in the scan's frame: a place x of the scan lies
at pose (x + displacement); targets (id, position_mm in the camera's frame, sd_mm), tools (id, force_N, sd_N); notes.

progress is told (fraction, stage); KeyboardInterrupt cancels.
Raises glisson.Error: what is wrong with the case.)");
}

}  // namespace glisson::python
