// Waves, vessels, territories and plans of a case.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/json.h"
#include "case_methods.h"
#include "casefile/plans.h"
#include "casefile/vascular.h"
#include "casefile/waves.h"
#include "choices.h"
#include "clicks.h"
#include "documents.h"
#include "image_grid.h"
#include "long_call.h"
#include "plan_cuts.h"
#include "planning/plan_file.h"
#include "segment_dict.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace casefile;
using namespace py::literals;

elastography::InversionOptions inversion_options(const std::string& method, const std::string& long_waves,
                                                 bool directional) {
  using elastography::InversionMethod;
  using elastography::LongWaves;
  elastography::InversionOptions options;
  options.method = chosen<InversionMethod>(
      "method", method, {{"direct", InversionMethod::direct}, {"lfe", InversionMethod::local_frequency}});
  options.long_waves =
      chosen<LongWaves>("long_waves", long_waves,
                        {{"high-pass", LongWaves::high_pass}, {"curl", LongWaves::curl}, {"keep", LongWaves::keep}});
  if (directional) options.directions = elastography::Directions::apart;
  return options;
}

}  // namespace

// Waves, vessels and territories.
void add_maps(py::class_<Case>& bound) {
  bound
      .def(
          "invert_waves",
          [](Case& self, const std::string& method, const std::string& long_waves, bool directional,
             const std::optional<double>& frequency_Hz, const std::optional<int>& directions,
             const py::object& progress) {
            const auto options = inversion_options(method, long_waves, directional);
            const elastography::AskedFor asked{frequency_Hz, directions};
            const auto map =
                long_call(progress, [&](const Progress& told) { return invert_waves(self, asked, options, told); });
            return py::dict("mean_kPa"_a = map.mean_kPa, "confident_fraction"_a = map.confident_fraction,
                            "frequencies_Hz"_a = map.frequencies_Hz, "notes"_a = messages(map.notes));
          },
          py::kw_only(), py::arg("method") = "direct", py::arg("long_waves") = "high-pass",
          py::arg("directional") = false, py::arg("frequency_Hz") = py::none(), py::arg("directions") = py::none(),
          py::arg("progress") = py::none(),
          R"(Computes the shear stiffness from the case's waves; the maps take their places in it.

method        "direct" or "lfe"; long_waves: "high-pass", "curl" or "keep"; directional: waves of each direction by
              themselves
frequency_Hz, directions   where the headers say nothing

A dict: mean_kPa, confident_fraction, frequencies_Hz, notes.
Raises glisson.Error: waves-none, choice-unknown.)")
      .def(
          "find_vessels",
          [](Case& self, const std::optional<std::string>& structure, const std::optional<Numbers>& portal_mm,
             const std::optional<Numbers>& hepatic_mm, const NamedPlaces& clicks, const NamedPlaces& borders,
             const py::object& progress) {
            const vasculature::Told told_by{clicks_from(portal_mm, hepatic_mm, clicks), borders_from(borders)};
            return std::make_shared<vasculature::VesselTrees>(long_call(
                progress, [&](const Progress& told) { return find_vessels(self, structure, told_by, told); }));
          },
          py::kw_only(), py::arg("structure") = py::none(), py::arg("portal_mm") = py::none(),
          py::arg("hepatic_mm") = py::none(), py::arg("clicks") = NamedPlaces(), py::arg("borders") = NamedPlaces(),
          py::arg("progress") = py::none(),
          (std::string(
               "The VesselTrees of the case, saved in it: of the structures portal-vein and hepatic-vein, or of "
               "one that holds both; with trees of the arteries and bile ducts that it has outlined. portal_mm, "
               "hepatic_mm: a place (LPS, mm) on each main stem, where the "
               "first guess is wrong. clicks: (vessel, place) each, borders: (border, place) each, as for "
               "vessel_trees().") +
           stage_note + "\nRaises glisson.Error: vessels-missing, labels-grids-differ.")
              .c_str())
      .def(
          "find_territories",
          [](Case& self, const std::string& by, const NamedPlaces& borders, const py::object& progress) {
            const auto from = chosen<SegmentsBy>("by", by, {{"tree", SegmentsBy::trees}, {"prior", SegmentsBy::shape}});
            const vasculature::BorderPlaces by_hand = borders_from(borders);
            auto found =
                long_call(progress, [&](const Progress& told) { return find_territories(self, from, by_hand, told); });
            py::dict dict = segment_dict(std::move(found.couinaud));
            for (const auto system : vasculature::vein_systems) {
              auto& territory = found.territory.at(static_cast<std::size_t>(system));
              dict[vasculature::system_name(system)] =
                  territory ? py::cast(std::make_shared<imaging::LabelMap>(*std::move(territory))) : py::none();
            }
            return dict;
          },
          py::kw_only(), py::arg("by") = "tree", py::arg("borders") = NamedPlaces(), py::arg("progress") = py::none(),
          (std::string("Which tissue belongs to which branch, and Couinaud's segments, saved in the case: what "
                       "couinaud_segments answers, with \"portal-vein\" and \"hepatic-vein\" (LabelMaps of the number "
                       "of the branch + 1, or None). by: \"tree\", or \"prior\" for the liver's shape alone. borders: "
                       "(border, place) each, for \"prior\"; trees have theirs from find_vessels.") +
           stage_note + "\nRaises glisson.Error: vessels-missing, choice-unknown.")
              .c_str());
}

// Resection plans.
void add_plans(py::class_<Case>& bound) {
  bound
      .def(
          "planner",
          [](const Case& self, const py::object& progress) {
            return long_call(progress, [&](const Progress& told) {
              return open_planner(self, told).map([](OpenedPlanner opened) { return std::move(opened.planner); });
            });
          },
          py::kw_only(), py::arg("progress") = py::none(),
          "A Planner for this patient: with its trees and territories where it has them.")
      .def_property_readonly(
          "plans",
          [](const Case& self) {
            py::list plans;
            for (const KeptPlan& kept : short_call([&] { return kept_plans(self); })) {
              const Json answer = or_raise(kept_answer(self, kept.id));
              plans.append(py::dict("id"_a = kept.id, "name"_a = kept.plan.name,
                                    "cuts"_a = python_of(planning::plan_json(kept.plan).at("cuts")),
                                    "answer"_a = python_of(answer), "remarks"_a = messages(kept.remarks)));
            }
            return plans;
          },
          "The resection plans that it keeps: a list of dicts with id, name, cuts, answer (as it was then), remarks.")
      .def(
          "keep_plan",
          [](Case& self, const std::string& name, const py::object& cuts, const py::object& progress) {
            const planning::Plan plan{name, cuts_from(cuts)};
            return long_call(progress, [&](const Progress& told) -> Result<std::string> {
              const auto opened = open_planner(self, told);
              if (!opened) return failure(opened.error());
              const auto answer = opened->planner.answer(plan.cuts);
              if (!answer) return failure(answer.error());
              return keep_plan(self, plan, *answer, opened->planner.trees());
            });
          },
          py::arg("name"), py::arg("cuts"), py::kw_only(), py::arg("progress") = py::none(),
          "Answers a plan (cuts as Planner.answer takes them) and keeps it in the case: the id of its entry.")
      .def(
          "drop_plan", [](Case& self, const std::string& name) { short_call([&] { return drop_plan(self, name); }); },
          py::arg("name"), "Takes a plan out of the case.\n\nRaises glisson.Error: plan-unknown.");
}

}  // namespace glisson::python
