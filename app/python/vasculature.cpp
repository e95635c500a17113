// Vessel trees, and whose tissue is whose.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "choices.h"
#include "clicks.h"
#include "long_call.h"
#include "rooms.h"
#include "segment_dict.h"
#include "vasculature/center_lines.h"
#include "vasculature/territories.h"
#include "vasculature/tree_file.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace vasculature;
using imaging::Mask;

py::dict dict_of(const TreeBranch& branch) {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> radii_mm;
  for (const CenterPoint& point : branch.points) {
    points_mm.push_back(point.position_mm);
    radii_mm.push_back(point.radius_mm);
  }
  return py::dict("name"_a = branch.name, "system"_a = system_name(branch.system), "parent"_a = branch.parent,
                  "generation"_a = branch.generation, "confidence"_a = branch.confidence,
                  "length_mm"_a = branch.length_mm, "radius_mm"_a = branch.radius_mm,
                  "points_mm"_a = handed_over(std::move(points_mm)), "radii_mm"_a = handed_over(std::move(radii_mm)));
}

// One number a voxel, [i, j, k], in the memory that it was made in.
template <typename T>
py::array on_grid(std::vector<T> values, const imaging::Grid& grid) {
  const auto [i, j, k] = grid.size;
  return handed_over(std::move(values)).attr("reshape")(i, j, k, "order"_a = "F");
}

void add_trees(py::module_& module) {
  py::class_<VesselTrees, std::shared_ptr<VesselTrees>>(module, "VesselTrees",
                                                        "Portal and hepatic veins, arteries and bile ducts, each as a "
                                                        "tree; vessel_trees() and Case.find_vessels() make one.")
      .def_readonly("portal_entry_mm", &VesselTrees::portal_entry_mm, "(3,): where the portal vein divides, LPS, mm.")
      .def_readonly("hepatic_entry_mm", &VesselTrees::hepatic_entry_mm,
                    "(3,): where the hepatic veins meet the vena cava, LPS, mm.")
      .def_property_readonly(
          "branches",
          [](const VesselTrees& self) {
            py::list branches;
            for (const TreeBranch& branch : self.branches) branches.append(dict_of(branch));
            return branches;
          },
          R"(Parents first, a dict each: name ("portal/right/posterior/VI/2"), system ("portal-vein", "hepatic-vein", "artery",
"biliary-tract"), parent (an earlier branch, or -1), generation, confidence of the system (0.5 to 1), length_mm,
radius_mm (median), points_mm (n, 3) and radii_mm (n,), outwards.)")
      .def_property_readonly(
          "border_doubts",
          [](const VesselTrees& self) {
            py::list doubts;
            for (const BorderDoubt& doubt : self.border_doubts) {
              doubts.append(py::make_tuple(vessel_name(doubt.vessel), doubt.doubt_ml));
            }
            return doubts;
          },
          "(vessel, ml) each, the largest first: how much is in doubt along the border where that vessel runs.")
      .def("__repr__", [](const VesselTrees& self) {
        return "<glisson.VesselTrees, " + std::to_string(self.branches.size()) + " branches>";
      });
  module.def(
      "vessel_trees",
      [](const Mask& vessels, const Mask& liver, const std::optional<Numbers>& portal_mm,
         const std::optional<Numbers>& hepatic_mm, const NamedPlaces& clicks, const NamedPlaces& borders,
         const std::shared_ptr<Mask>& arteries, const std::shared_ptr<Mask>& bile_ducts, const py::object& progress) {
        const Told told_by{clicks_from(portal_mm, hepatic_mm, clicks), borders_from(borders)};
        auto found = long_call(progress, [&](const Progress& told) -> Result<LiverAnatomy> {
          auto anatomy = center_lines(vessels, {}, told.part(0, 0.4)).and_then([&](const VesselGraph& graph) {
            return explain_vessels(graph, liver, told_by, told.part(0.4, 0.8));
          });
          for (const auto& [mask, system] :
               {std::pair(&arteries, System::artery), std::pair(&bile_ducts, System::biliary_tract)}) {
            if (!anatomy || !*mask) continue;
            const auto graph = center_lines(**mask, {}, told.part(0.8, 1));
            if (!graph) return failure(graph.error());
            add_known_vessels(*graph, system, liver, anatomy->trees);
          }
          if (anatomy) name_branches(anatomy->trees, anatomy->segments);
          return anatomy;
        });
        return std::make_shared<VesselTrees>(std::move(found.trees));
      },
      py::arg("vessels"), py::arg("liver"), py::kw_only(), py::arg("portal_mm") = py::none(),
      py::arg("hepatic_mm") = py::none(), py::arg("clicks") = NamedPlaces(), py::arg("borders") = NamedPlaces(),
      py::arg("arteries") = nullptr, py::arg("bile_ducts") = nullptr, py::arg("progress") = py::none(),
      R"(VesselTrees of a Mask that holds portal and hepatic veins together: centre lines, the two told apart by the liver's shape,
branches named. portal_mm, hepatic_mm: a place (LPS, mm) on each main stem, where the first guess is wrong.
clicks: (vessel, place) each, what the vessel there is: "portal-vein", "hepatic-vein", "middle-hepatic-vein",
"right-hepatic-vein", "umbilical-portion" or "left-hepatic-vein".
borders: ("V-VIII", place) each, through which the border of those two segments runs.
arteries, bile_ducts: a Mask of each, which get trees of their own and change nothing of the veins.

progress is told (fraction, stage); KeyboardInterrupt cancels.
Raises glisson.Error: choice-unknown, click-beside, border-outside, borders-contradict, vessels-empty, vessels-one-blob, vessels-grid, vessels-outside, liver-empty.)");
  module.def(
      "read_trees",
      [](const std::filesystem::path& file) {
        return std::make_shared<VesselTrees>(short_call([&] { return read_trees(file); }));
      },
      py::arg("file"), "VesselTrees of a file (glisson-vessel-trees/1).\n\nRaises glisson.Error: trees-unreadable.");
  module.def(
      "write_trees",
      [](const std::filesystem::path& file, const VesselTrees& trees) {
        short_call([&] { return write_trees(file, trees); });
      },
      py::arg("file"), py::arg("trees"), "Writes VesselTrees as JSON, all or nothing.");
}

void add_territories(py::module_& module) {
  module.def(
      "territories",
      [](const VesselTrees& trees, const std::string& system, const Mask& liver) {
        const auto of = chosen<System>("system", system,
                                       {{"portal-vein", System::portal_vein}, {"hepatic-vein", System::hepatic_vein}});
        Territories found = short_call([&] { return territories_of(trees, of, liver); });
        auto beyond_ml = volumes_beyond_ml(trees, found);
        return py::dict("branch"_a = on_grid(std::move(found.branch), found.grid),
                        "distance_mm"_a = on_grid(std::move(found.distance_mm), found.grid),
                        "volume_ml"_a = handed_over(std::move(found.volume_ml)),
                        "volume_beyond_ml"_a = handed_over(std::move(beyond_ml)));
      },
      py::arg("trees"), py::arg("system"), py::arg("liver"),
      R"(Which tissue belongs to which branch of "portal-vein" or "hepatic-vein": nearest wall, along ways in the liver.

A dict: branch (int32, [i, j, k] on the liver's grid: of trees.branches, -1 where none), distance_mm (float32, from its
wall), volume_ml (of each branch by itself), volume_beyond_ml (with all that grows from it).
Raises glisson.Error: territories-no-branch, liver-empty, choice-unknown.)");
  module.def(
      "couinaud_segments",
      [](const Mask& liver, const std::shared_ptr<VesselTrees>& trees, const NamedPlaces& borders,
         const py::object& progress) {
        const BorderPlaces by_hand = borders_from(borders);
        return segment_dict(long_call(
            progress, [&](const Progress& told) { return couinaud_segments(liver, trees.get(), by_hand, told); }));
      },
      py::arg("liver"), py::arg("trees") = nullptr, py::kw_only(), py::arg("borders") = NamedPlaces(),
      py::arg("progress") = py::none(),
      R"(Couinaud's eight segments of a liver, from its VesselTrees or, without, from its shape alone.
borders: ("V-VIII", place in LPS, mm) each, through which the border of those two segments runs, besides those that the
trees were told.

A dict: segment (LabelMap: 1 to 8, 0 outside), doubt (uint8, [i, j, k]: percent), volume_ml and confidence (9 numbers: of
all, then of segments 1 to 8), from ("tree" or "prior").
Raises glisson.Error: liver-empty, vessels-outside, border-outside, borders-contradict, choice-unknown, and what a liver's shape refuses.)");
}

}  // namespace

py::dict segment_dict(CouinaudSegments found) {
  py::dict dict("segment"_a = py::none(), "doubt"_a = on_grid(std::move(found.doubt), found.segment.grid),
                "volume_ml"_a = found.volume_ml, "confidence"_a = found.confidence);
  dict["from"] = found.from == SegmentsFrom::trees ? "tree" : "prior";
  dict["segment"] = std::make_shared<imaging::LabelMap>(std::move(found.segment));
  return dict;
}

void add_vasculature(py::module_& module) {
  add_trees(module);
  add_territories(module);
}

}  // namespace glisson::python
