// SIRGn: which places of a registered video are not to be trusted.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "long_call.h"
#include "registration_quality/register_sequence.h"
#include "registration_quality/sirgn.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace registration_quality;

// A row without a number is a frame in which the landmark was not seen.
LandmarkTrack track_from(const std::string& id, const Numbers& positions_mm) {
  LandmarkTrack track{id, {}};
  for (const Eigen::Vector3d& position : points_from(positions_mm, "landmarks[\"" + id + "\"]"))
    track.positions_mm.push_back(position.allFinite() ? std::optional(position) : std::nullopt);
  return track;
}

py::dict judgement(Quality quality) {
  py::dict dict;
  dict["mesh"] = std::make_shared<geometry::Surface>(std::move(quality.mesh));
  dict["correlation"] = handed_over(std::move(quality.correlation));
  dict["error_mm"] = handed_over(std::move(quality.error_mm));
  dict["doubt_mm"] = handed_over(std::move(quality.doubt_mm));
  dict["frames_seen"] = handed_over(std::move(quality.frames_seen));
  dict["mean_correlation"] = quality.mean_correlation;
  dict["rejected_fraction"] = handed_over(std::move(quality.rejected_fraction));
  dict["rmse_mm"] = handed_over(std::move(quality.rmse_mm));
  dict["tre_mm"] = handed_over(std::move(quality.tre_mm));
  dict["notes"] = messages(quality.notes);
  return dict;
}

py::dict judge(const RegisteredSequence& sequence, const std::vector<double>& tolerances_mm,
               const py::object& progress) {
  SirgnOptions options;
  options.tolerances_mm = tolerances_mm;
  return judgement(long_call(progress, [&](const Progress& told) { return sirgn(sequence, options, told); }));
}

RegisteredSequence sequence_from(const std::vector<std::pair<Numbers, Numbers>>& frames,
                                 const std::map<std::string, Numbers>& landmarks,
                                 const std::shared_ptr<geometry::Surface>& model) {
  RegisteredSequence sequence;
  for (const auto& [cloud, registered] : frames)
    sequence.frames.push_back({points_from(cloud, "cloud_mm"), points_from(registered, "registered_mm")});
  for (const auto& [id, positions] : landmarks) sequence.landmarks.push_back(track_from(id, positions));
  if (model) sequence.model = *model;
  return sequence;
}

SequenceMethod method_of(const std::string& name) {
  for (const SequenceMethod method : sequence_methods)
    if (name_of(method) == name) return method;
  raise("method-unknown", "Sequences are not registered by \"{0}\".", {name},
        "The methods are \"given\", \"icp\", \"geo\" and \"gnra\".");
}

}  // namespace

void add_registration_quality(py::module_& module) {
  const std::vector<double> usual_tolerances_mm = SirgnOptions{}.tolerances_mm;
  module.def(
      "sirgn",
      [](const std::vector<std::pair<Numbers, Numbers>>& frames, const std::map<std::string, Numbers>& landmarks,
         const std::shared_ptr<geometry::Surface>& model, const std::vector<double>& tolerances_mm,
         const py::object& progress) {
        return judge(sequence_from(frames, landmarks, model), tolerances_mm, progress);
      },
      py::arg("frames"), py::arg("landmarks"), py::kw_only(), py::arg("model") = nullptr,
      py::arg("tolerances_mm") = usual_tolerances_mm, py::arg("progress") = py::none(),
      R"(How good a registration of a video is, triangle by triangle, by landmarks alone (SIRGn).

frames     a pair a frame: the cloud as seen (n x 3, in the frame's space) and where the registration put it (n x 3, in
           the model's), point for point, mm
landmarks  id -> (frames, 3): where each was seen, in the frame's space, mm; NaN where it was not
model      a Surface, or None

A dict: mesh (the correlation mesh, a Surface), correlation (-1..1), error_mm, doubt_mm, frames_seen: one a triangle;
mean_correlation; rejected_fraction, one a tolerance; rmse_mm, tre_mm, one a frame; notes.

Raises glisson.Error: sirgn-too-few-frames, sirgn-too-few-landmarks, sirgn-landmarks-off, sirgn-not-point-for-point,
sirgn-tracks, sirgn-empty-frame, sirgn-tolerance.)");
  module.def(
      "sirgn_of_sequence",
      [](const std::filesystem::path& file, const std::string& method, const std::vector<double>& tolerances_mm,
         const py::object& progress) {
        const SequenceMethod how = method_of(method);
        const RegisteredSequence sequence = long_call(progress, [&](const Progress& told) {
          return read_sequence(file).and_then(
              [&](const SequenceFiles& files) { return register_sequence(files, how, told.part(0, 0.7)); });
        });
        return judge(sequence, tolerances_mm, progress);
      },
      py::arg("file"), py::arg("method"), py::kw_only(), py::arg("tolerances_mm") = usual_tolerances_mm,
      py::arg("progress") = py::none(),
      "The same of a sequence on disk, as it was registered (\"given\") or by \"icp\", \"geo\" or \"gnra\".");
}

}  // namespace glisson::python
