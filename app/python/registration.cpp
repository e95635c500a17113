// Surfaces brought onto each other, and matched by distances along them.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "long_call.h"
#include "registration/geo.h"
#include "registration/register.h"
#include "registration/rigid.h"
#include "registration/trwls.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace registration;
using geometry::Surface;

std::string name_of(StopReason reason) {
  switch (reason) {
    case StopReason::bound_met: return "bound-met";
    case StopReason::energy_stopped_falling: return "energy-stopped-falling";
    case StopReason::all_passes_done: return "all-passes-done";
    case StopReason::cancelled: return "cancelled";
    case StopReason::not_run: break;
  }
  return "not-run";
}

py::dict dict_of(const MatchingSolution& solution) {
  py::dict dict;
  dict["labels"] = handed_over(solution.labels);
  dict["energy"] = solution.energy;
  dict["lower_bound"] = solution.lower_bound;
  dict["passes"] = solution.passes.size();
  dict["stopped"] = name_of(solution.stopped);
  dict["solve_ms"] = solution.solve_ms;
  return dict;
}

py::dict solve(const Eigen::MatrixXd& source_mm, const Eigen::MatrixXd& target_mm, double sigma_mm, double tau_mm,
               int passes, const py::object& progress) {
  if (passes < 1)
    raise("matching-passes", "At least one pass is needed; {0} were asked for.", {std::to_string(passes)});
  MatchingProblem problem;
  problem.source_mm = source_mm;
  problem.target_mm = target_mm;
  problem.sigma_mm = sigma_mm;
  problem.tau_mm = tau_mm;
  TrwlsOptions options;
  options.passes = passes;
  return dict_of(long_call(progress, [&](const Progress& told) { return trwls(problem, options, told); }));
}

SurfaceMatch match(const Surface& source, const Surface& target, int points, const std::string& solver,
                   const std::string& prior, const py::object& progress) {
  GeoOptions options;
  options.points = points;
  if (solver != "trwls" && solver != "trws") {
    raise("solver-unknown", "There is no solver \"{0}\".", {solver}, "There are \"trwls\" and \"trws\".");
  }
  if (solver == "trws") options.solver = Solver::trws;
  if (prior != "auto" && prior != "none" && prior != "positions") {
    raise("prior-unknown", "There is no prior \"{0}\".", {prior}, "There are \"auto\", \"none\" and \"positions\".");
  }
  if (prior != "auto") options.prior = prior == "none" ? Prior::none : Prior::positions;
  return long_call(progress, [&](const Progress& told) { return match_surfaces(source, target, options, told); });
}

py::dict registered(const Surface& source, const Surface& target, const std::string& method,
                    const py::object& progress) {
  if (method != "icp" && method != "geo") {
    raise("method-unknown", "Surfaces are not registered by \"{0}\".", {method},
          "The methods are \"icp\" and \"geo\".");
  }
  RegisterOptions options;
  if (method == "geo") options.method = Method::geo;
  Registered found =
      long_call(progress, [&](const Progress& told) { return register_surfaces(source, target, options, told); });
  py::dict dict;
  dict["surface"] = std::make_shared<Surface>(std::move(found.surface));
  dict["rms_mm"] = found.rms_mm;
  dict["iterations"] = found.iterations;
  dict["orientation_kept"] = found.orientation_kept;
  return dict;
}

py::dict rigidly(const Surface& source, const Surface& target, const py::object& progress) {
  const RigidIcpResult found =
      long_call(progress, [&](const Progress& told) { return rigid_icp(source, target, {}, told); });
  py::dict dict;
  dict["transform"] = Eigen::Matrix4d(found.transform.matrix());
  dict["rms_mm"] = found.rms_mm;
  dict["iterations"] = found.iterations;
  dict["converged"] = found.stopped == IcpStop::converged;
  return dict;
}

}  // namespace

void add_registration(py::module_& module) {
  module.def(
      "align_points",
      [](const Numbers& from_mm, const Numbers& to_mm) {
        const auto from = points_from(from_mm, "from_mm"), to = points_from(to_mm, "to_mm");
        return Eigen::Matrix4d(short_call([&] { return align_points(from, to); }).matrix());
      },
      py::arg("from_mm"), py::arg("to_mm"),
      "The rotation and translation (4 x 4) that bring points (n x 3, mm) nearest to others, pair by pair "
      "(Kabsch).\n\nRaises glisson.Error: alignment-too-few-points, alignment-sizes.");
  module.def("rigid_icp", &rigidly, py::arg("source"), py::arg("target"), py::kw_only(),
             py::arg("progress") = py::none(),
             "Rigid alignment by closest points, from where the Surfaces lie. A dict: transform (4 x 4, source to "
             "target), rms_mm, iterations, converged.");
  module.def("register_surfaces", &registered, py::arg("source"), py::arg("target"), py::kw_only(),
             py::arg("method") = "icp", py::arg("progress") = py::none(),
             R"(One Surface moved onto another, rigidly first, then as it bends.

method  "icp": from where they lie; "geo": by distances along them, so that they may lie anywhere
A dict: surface (the source moved, its points in their order), rms_mm, iterations, orientation_kept (for "geo": below
0.6 it should not be trusted).

Raises glisson.Error: registration-no-pairs, registration-mirrored, registration-singular, method-unknown.)");
  py::class_<SurfaceMatch>(module, "SurfaceMatch", "Point source_points[i] of the source belongs to target_points[i].")
      .def_property_readonly(
          "source_points", [](const SurfaceMatch& self) { return handed_over(self.source_points); },
          "int32, (matches,).")
      .def_property_readonly(
          "target_points", [](const SurfaceMatch& self) { return handed_over(self.target_points); },
          "int32, (matches,).")
      .def_property_readonly(
          "target_samples", [](const SurfaceMatch& self) { return handed_over(self.target_samples.points); },
          "int32, (samples,): the target's points among which it chose.")
      .def_property_readonly(
          "target_distances_mm", [](const SurfaceMatch& self) { return self.target_samples.to_surface_mm; },
          "float64, (samples, points of the target): along the surface; a copy.")
      .def_readonly("orientation_kept", &SurfaceMatch::orientation_kept,
                    "Share of neighbours that turn the same way: 1 for a good match, 0 for a mirrored one.")
      .def_property_readonly(
          "solution", [](const SurfaceMatch& self) { return dict_of(self.solution); }, "As trwls() answers.")
      .def(
          "densify",
          [](const SurfaceMatch& self) {
            return handed_over([&] {
              const py::gil_scoped_release released;
              return densify(self);
            }());
          },
          "int32, (points of the source,): a target point for each of them.");
  module.def("match_surfaces", &match, py::arg("source"), py::arg("target"), py::kw_only(), py::arg("points") = 128,
             py::arg("solver") = "trwls", py::arg("prior") = "auto", py::arg("progress") = py::none(),
             R"(GEO: two Surfaces matched by geodesic distances, however they bend and wherever they lie.

points  of each surface; solver "trwls", or "trws" (the slow one in double precision)
prior   "none": any pose; "positions": roughly aligned; "auto": positions for a part of a whole

Raises glisson.Error: too-few-points, matching-too-few-points, matching-too-many-points, mrf-too-large, solver-unknown,
prior-unknown.)");
  module.def("trwls", &solve, py::arg("source_mm"), py::arg("target_mm"), py::kw_only(), py::arg("sigma_mm"),
             py::arg("tau_mm"), py::arg("passes") = 20, py::arg("progress") = py::none(),
             R"(Matches nodes to labels by their distances, (nodes, nodes) and (labels, labels), mm: TRWL-S.

A pair of nodes at x that gets labels at y costs exp(-min(x, y) / sigma) min(|x - y|, tau).
A dict: labels (int32, (nodes,)), energy, lower_bound, passes, stopped, solve_ms.

Raises glisson.Error: matching-distances, matching-too-few-points, matching-too-many-points, matching-constants,
matching-passes.)");
}

}  // namespace glisson::python
