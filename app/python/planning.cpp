// Resection plans: what a cut takes, what stays, and what of that lives.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "base/json.h"
#include "documents.h"
#include "long_call.h"
#include "plan_cuts.h"
#include "planning/plan_file.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace planning;
using imaging::LabelMap;
using imaging::Mask;

LiverParts parts_from(const Mask& liver, const std::map<std::string, std::shared_ptr<Mask>>& tumours,
                      const std::shared_ptr<LabelMap>& segments, const std::shared_ptr<vasculature::VesselTrees>& trees,
                      const std::shared_ptr<LabelMap>& portal, const std::shared_ptr<LabelMap>& hepatic,
                      const std::shared_ptr<imaging::Volume>& youngs_kPa) {
  LiverParts parts;
  parts.liver = liver;
  for (const auto& [name, mask] : tumours) parts.tumours.push_back({name, *mask});
  if (segments) parts.segments = *segments;
  if (trees) parts.trees = *trees;
  if (portal) parts.portal = *portal;
  if (hepatic) parts.hepatic = *hepatic;
  if (youngs_kPa) parts.youngs_kPa = *youngs_kPa;
  return parts;
}

py::dict dict_of(Resectogram unrolled) {
  py::list vessels;
  for (const Resectogram::Vessel& vessel : unrolled.vessels) {
    vessels.append(py::dict("name"_a = vessel.name, "column"_a = vessel.column, "row"_a = vessel.row,
                            "radius_mm"_a = vessel.radius_mm));
  }
  const py::array margin_mm = handed_over(std::move(unrolled.margin_mm));
  return py::dict("step_mm"_a = unrolled.step_mm,
                  "margin_mm"_a = margin_mm.attr("reshape")(unrolled.rows, unrolled.columns), "vessels"_a = vessels);
}

}  // namespace

std::vector<planning::Cut> cuts_from(const py::object& cuts) {
  Json document = or_raise(parse_json(text_of(cuts)));
  if (document.is_object() && !document.contains("cuts")) document = Json::array({document});
  if (document.is_array()) document = Json{{"cuts", std::move(document)}};
  document["name"] = "plan";
  return or_raise(plan_from(document)).cuts;
}

void add_planning(py::module_& module) {
  py::class_<Planner>(module, "Planner",
                      R"(What a plan takes out of one liver and what it leaves; Case.planner() makes one of a patient.

liver           a Mask; tumours: name -> Mask
segments        LabelMap of Couinaud's segments, 1 to 8
trees           VesselTrees, with portal and hepatic: LabelMaps of the number of the branch + 1
youngs_kPa      Volume, positive where it is to be trusted

Each may be left out but the liver, and lie on a grid of its own.
Raises glisson.Error: liver-empty, plan-too-many-tumours.)")
      .def(
          py::init([](const Mask& liver, const std::map<std::string, std::shared_ptr<Mask>>& tumours,
                      const std::shared_ptr<LabelMap>& segments, const std::shared_ptr<vasculature::VesselTrees>& trees,
                      const std::shared_ptr<LabelMap>& portal, const std::shared_ptr<LabelMap>& hepatic,
                      const std::shared_ptr<imaging::Volume>& youngs_kPa, const py::object& progress) {
            return long_call(progress, [&](const Progress& told) {
              return Planner::open(parts_from(liver, tumours, segments, trees, portal, hepatic, youngs_kPa), told);
            });
          }),
          py::arg("liver"), py::kw_only(), py::arg("tumours") = std::map<std::string, std::shared_ptr<Mask>>(),
          py::arg("segments") = nullptr, py::arg("trees") = nullptr, py::arg("portal") = nullptr,
          py::arg("hepatic") = nullptr, py::arg("youngs_kPa") = nullptr, py::arg("progress") = py::none())
      .def(
          "answer",
          [](const Planner& self, const py::object& cuts) {
            const auto asked = cuts_from(cuts);
            const PlanAnswer answer = short_call([&] { return self.answer(asked); });
            return python_of(answer_json(answer, self.trees()));
          },
          py::arg("cuts"),
          R"(What is taken and what is left: a dict as the command line's `plan --json` has it (removed_ml, remnant_ml,
remnant_percent, perfused_ml, drained_ml, living_ml, margin_mm, tumours, segments, branches, ...).

cuts  a dict, or a list of them, whose union is taken out: {"plane": {"point_mm", "normal", "removed"}}, {"sheet":
      {"through_mm"}}, {"segments": [6, 7]}, {"territory": "portal/right"}, {"around": "tumour-1", "margin_mm": 10},
      {"ablation": {"center_mm", "direction", "radius_along_mm", "radius_across_mm"}}

Raises glisson.Error: plan-invalid, plan-empty, cut-invalid, cut-misses, segment-unknown, segments-missing,
branch-unknown, territory-empty, tumour-unknown, margin-invalid, ablation-invalid, nothing-left.)")
      .def(
          "parts",
          [](const Planner& self, const py::object& cuts) {
            const auto asked = cuts_from(cuts);
            return short_call([&] { return self.parts(asked); });
          },
          py::arg("cuts"), "A Mask's voxels on the part of the grid around the liver: 1 stays, 2 goes.")
      .def(
          "unrolled",
          [](const Planner& self, const py::object& cuts, double step_mm) {
            const auto asked = cuts_from(cuts);
            auto found = short_call([&] { return self.answer_unrolled(asked, step_mm); });
            py::list all;
            for (Resectogram& each : found.resectograms) all.append(dict_of(std::move(each)));
            return all;
          },
          py::arg("cuts"), py::kw_only(), py::arg("step_mm") = 1.0,
          "Each plane and sheet among the cuts, unrolled: a dict with step_mm, margin_mm (rows, columns; to the "
          "nearest "
          "tumour, NaN beside the liver) and vessels (name, column, row, radius_mm).")
      .def_property_readonly("tumours", &Planner::tumours, "Names of the tumours.")
      .def_property_readonly(
          "trees", [](const Planner& self) { return std::make_shared<vasculature::VesselTrees>(self.trees()); },
          "The VesselTrees that it counts by.");
}

}  // namespace glisson::python
