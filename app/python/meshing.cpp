// Labels to tetrahedra, masks to smooth surfaces.

#include <pybind11/stl.h>

#include "long_call.h"
#include "meshing/mask_surface.h"
#include "meshing/mesh_labels.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace meshing;
using imaging::LabelMap;
using imaging::Mask;

// A mesh whose parts Python may keep alone.
struct SharedLiverMesh {
  std::shared_ptr<geometry::TetMesh> body;
  std::shared_ptr<geometry::Surface> surface;
  LiverMesh rest;
};

SharedLiverMesh mesh(const LabelMap& labels, int target_cells, double inner_share,
                     const std::map<int, std::string>& names, const py::object& progress) {
  MeshOptions options;
  options.target_cells = target_cells;
  options.inner_share = inner_share;
  for (const auto& [label, name] : names) options.names.push_back({static_cast<std::uint16_t>(label), name});
  LiverMesh made = long_call(progress, [&](const Progress& told) { return mesh_labels(labels, options, told); });
  auto body = std::make_shared<geometry::TetMesh>(std::move(made.body));
  auto surface = std::make_shared<geometry::Surface>(std::move(made.surface));
  return {std::move(body), std::move(surface), std::move(made)};
}

LabelMap labels_of(const Mask& mask) { return {mask.grid, {mask.values.begin(), mask.values.end()}}; }

py::list regions_of(const SharedLiverMesh& mesh) {
  py::list regions;
  for (const RegionVolume& region : mesh.rest.regions) {
    regions.append(py::dict("label"_a = region.label, "label_volume_ml"_a = region.label_volume_ml,
                            "mesh_volume_ml"_a = region.mesh_volume_ml));
  }
  return regions;
}

}  // namespace

void add_meshing(py::module_& module) {
  py::class_<SharedLiverMesh>(module, "LiverMesh", "What mesh_labels made.")
      .def_readonly("body", &SharedLiverMesh::body, "The TetMesh; cell field \"region\": the label of each cell.")
      .def_readonly("surface", &SharedLiverMesh::surface, "Its boundary, a Surface: watertight, manifold.")
      .def_property_readonly(
          "hausdorff_mm", [](const SharedLiverMesh& self) { return self.rest.hausdorff_mm; },
          "The largest distance between the surface and the boundary of the labelled voxels, mm.")
      .def_property_readonly(
          "mean_distance_mm", [](const SharedLiverMesh& self) { return self.rest.mean_distance_mm; }, "mm.")
      .def_property_readonly("regions", &regions_of, "A dict a label: label, label_volume_ml, mesh_volume_ml.")
      .def_property_readonly(
          "notes", [](const SharedLiverMesh& self) { return messages(self.rest.notes); },
          "What was cut, left out, filled, or got no cells of its own: one sentence each.");
  constexpr const char* documentation =
      R"(Tetrahedra that conform to the structures of a label map; of a mask, of one structure.

All labels other than 0 together are the body, the largest of them the liver, the others structures inside.
target_cells  about how many tetrahedra, reached within 15 % or a note says why not
inner_share   of them, what inner structures may cost
names         label -> name, for the notes
progress      is told (fraction, stage); KeyboardInterrupt cancels

Raises glisson.Error: mesh-options, labels-empty, labels-grid, mesh-refinement, mesh-region-lost, mesh-not-manifold.)";
  module.def("mesh_labels", &mesh, py::arg("labels"), py::kw_only(), py::arg("target_cells") = 20000,
             py::arg("inner_share") = 0.5, py::arg("names") = std::map<int, std::string>(),
             py::arg("progress") = py::none(), documentation);
  module.def(
      "mesh_labels",
      [](const Mask& mask, int target_cells, double inner_share, const std::map<int, std::string>& names,
         const py::object& progress) { return mesh(labels_of(mask), target_cells, inner_share, names, progress); },
      py::arg("labels"), py::kw_only(), py::arg("target_cells") = 20000, py::arg("inner_share") = 0.5,
      py::arg("names") = std::map<int, std::string>(), py::arg("progress") = py::none());
  module.def(
      "mask_surface",
      [](const Mask& mask, int smoothing_iterations, double pass_band) {
        return std::make_shared<geometry::Surface>(short_call([&] {
          return mask_surface(mask, {smoothing_iterations, pass_band});
        }));
      },
      py::arg("mask"), py::kw_only(), py::arg("smoothing_iterations") = organ_smoothing.smoothing_iterations,
      py::arg("pass_band") = organ_smoothing.pass_band,
      "A smooth closed surface around a mask's voxels, by default as for organs; vessels of two voxels keep their "
      "shape with smoothing_iterations=20, pass_band=0.1.\n\nRaises glisson.Error: mask-empty.");
}

}  // namespace glisson::python
