// What a model lacks that measurements show, and what the better one predicts.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "base/json.h"
#include "closedloop/explain.h"
#include "closedloop/explanation_file.h"
#include "closedloop/predict.h"
#include "documents.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace closedloop;
using std::filesystem::path;

py::dict explanation(const path& experiment, const py::object& progress) {
  const Explained found = long_call(progress, [&](const Progress& told) { return explain(experiment, told); });
  return py::dict("report"_a = python_of(report_json(found.explanation, found.model->observations())),
                  "model"_a = python_of_text(model_text(found.explanation, *found.model, found.experiment)));
}

py::dict dict_of(const ErrorFigures& error) {
  return py::dict("rms"_a = error.rms, "mean"_a = error.mean, "p95"_a = error.p95, "max"_a = error.max,
                  "noise"_a = error.noise, "reduced_chi2"_a = error.reduced_chi2);
}

py::dict prediction(const path& experiment, const std::optional<path>& better, const py::object& progress) {
  const Prediction found = long_call(progress, [&](const Progress& told) { return predict(experiment, better, told); });
  py::list trials;
  for (const PredictedTrial& trial : found.trials) {
    trials.append(py::dict("id"_a = trial.id, "predicted"_a = trial.predicted,
                           "error"_a = trial.error ? py::object(dict_of(*trial.error)) : py::object(py::none())));
  }
  return py::dict("unit"_a = found.unit, "trials"_a = trials,
                  "error"_a = found.error ? py::object(dict_of(*found.error)) : py::object(py::none()),
                  "predicted"_a = found.predicted);
}

}  // namespace

void add_closedloop(py::module_& module) {
  module.def("explain", &explanation, py::arg("experiment"), py::kw_only(), py::arg("progress") = py::none(),
             R"(What the declared model of an experiment (a JSON file) lacks.

A dict: report (verdict, errors before and after, effects with their parameters and evidence, as report.json has it)
and model (the better model, as model.json has it; written to a file, predict() takes it up).

progress is told (fraction, stage); KeyboardInterrupt cancels.
Raises glisson.Error: what is wrong with the experiment, or "cancelled".)");
  module.def(
      "predict", &prediction, py::arg("experiment"), py::arg("better") = py::none(), py::kw_only(),
      py::arg("progress") = py::none(),
      R"(The trials of an experiment (a JSON file) as its declared model predicts them, or a better one (model.json).

A dict: unit; trials, a dict each: id, predicted (float64), error (None where nobody measured); error of all that was
measured: rms, mean, p95, max, noise, reduced_chi2; predicted, a number a row of all of them.

Raises glisson.Error: what is wrong with the experiment, model-invalid.)");
}

}  // namespace glisson::python
