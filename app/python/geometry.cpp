// Surfaces and tetrahedra as numpy arrays, their files and their measures.

#include "geometry/mesh_file.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace geometry;

// Meshes never change once they are made, so that the views of their memory stay true.
using SharedMesh = std::shared_ptr<TetMesh>;
using SharedSurface = std::shared_ptr<Surface>;

void merge(Fields& fields, Fields more) {
  for (Field& field : more) set_field(fields, std::move(field));
}

template <typename Shape>
void add_fields(py::class_<Shape, std::shared_ptr<Shape>>& bound) {
  bound
      .def_property_readonly(
          "points_mm", [](const py::object& self) { return view(self.cast<const Shape&>().points_mm, self); },
          "float64, shape (points, 3): patient coordinates LPS, mm. Without a copy, read only.")
      .def_property_readonly(
          "point_fields", [](const py::object& self) { return views(self.cast<const Shape&>().point_fields, self); },
          "Quantities on the points by name: float64, (points,) or (points, components). Without a copy, read only.")
      .def_property_readonly(
          "cell_fields", [](const py::object& self) { return views(self.cast<const Shape&>().cell_fields, self); },
          "The same, one item a cell.");
}

SharedMesh make_mesh(const Numbers& points_mm, const ArrayLike& cells, const py::dict& point_fields,
                     const py::dict& cell_fields) {
  TetMesh mesh;
  mesh.points_mm = points_from(points_mm, "points_mm");
  mesh.cells = cells_from<4>(cells, "cells");
  mesh.point_fields = fields_from(point_fields, mesh.points_mm.size(), "point_fields");
  mesh.cell_fields = fields_from(cell_fields, mesh.cells.size(), "cell_fields");
  short_call([&] { return check_cells(mesh); });
  return std::make_shared<TetMesh>(std::move(mesh));
}

void add_tetrahedra(py::module_& module) {
  py::class_<TetMesh, SharedMesh> mesh(
      module, "TetMesh",
      R"(A body of tetrahedra in patient coordinates (LPS, mm), with quantities on its points and cells.

Made of points_mm (points, 3) and cells (cells, 4), whole numbers from 0; each cell has a positive volume:
(p1 - p0) x (p2 - p0) . (p3 - p0) > 0. It never changes once it is made: its arrays are read only, share its memory,
and live on when it is gone.

Raises glisson.Error: array-shape, array-not-whole, and what makes a body useless (an index out of range, a flat or
turned cell, a point that is not finite).)");
  mesh.def(py::init(&make_mesh), py::arg("points_mm"), py::arg("cells"), py::kw_only(),
           py::arg("point_fields") = py::dict(), py::arg("cell_fields") = py::dict());
  add_fields(mesh);
  mesh.def_property_readonly(
          "cells", [](const py::object& self) { return view(self.cast<const TetMesh&>().cells, self); },
          "int32, shape (cells, 4): points of each tetrahedron. Without a copy, read only.")
      .def(
          "with_fields",
          [](const TetMesh& self, const py::dict& point_fields, const py::dict& cell_fields) {
            auto made = std::make_shared<TetMesh>(self);
            merge(made->point_fields, fields_from(point_fields, self.points_mm.size(), "point_fields"));
            merge(made->cell_fields, fields_from(cell_fields, self.cells.size(), "cell_fields"));
            return made;
          },
          py::kw_only(), py::arg("point_fields") = py::dict(), py::arg("cell_fields") = py::dict(),
          "A copy with these fields, in place of those of the same name.")
      .def_property_readonly(
          "volume_mm3", [](const TetMesh& self) { return volume_mm3(self); }, "mm3.")
      .def(
          "quality",
          [](const TetMesh& self) {
            const TetQuality q = quality(self);
            return py::dict("min_dihedral_deg"_a = q.min_dihedral_deg, "max_dihedral_deg"_a = q.max_dihedral_deg,
                            "mean_aspect"_a = q.mean_aspect, "max_aspect"_a = q.max_aspect);
          },
          "Dihedral angles (degrees) and aspect (longest edge over shortest height, 1 for the regular tetrahedron).")
      .def("__repr__", [](const TetMesh& self) {
        return "<glisson.TetMesh, " + std::to_string(self.points_mm.size()) + " points, " +
               std::to_string(self.cells.size()) + " cells>";
      });
  module.def(
      "boundary_surface", [](const TetMesh& body) { return std::make_shared<Surface>(boundary_surface(body)); },
      py::arg("mesh"),
      "The outer surface of a TetMesh, counter-clockwise from outside. Its point field \"mesh_point\" says which point "
      "of the mesh each one is, its cell field \"mesh_cell\" which tetrahedron lies behind each triangle.");
  module.def(
      "cell_centroids_mm",
      [](const TetMesh& body) {
        std::vector<Eigen::Vector3d> centroids;
        for (std::size_t c = 0; c < body.cells.size(); ++c) centroids.push_back(cell_centroid_mm(body, c));
        return handed_over(std::move(centroids));
      },
      py::arg("mesh"), "float64, shape (cells, 3): LPS, mm.");
}

SharedSurface make_surface(const Numbers& points_mm, const ArrayLike& triangles, const py::dict& point_fields,
                           const py::dict& cell_fields) {
  Surface surface;
  surface.points_mm = points_from(points_mm, "points_mm");
  surface.triangles = cells_from<3>(triangles, "triangles");
  surface.point_fields = fields_from(point_fields, surface.points_mm.size(), "point_fields");
  surface.cell_fields = fields_from(cell_fields, surface.triangles.size(), "cell_fields");
  short_call([&] { return check_surface(surface); });
  return std::make_shared<Surface>(std::move(surface));
}

void add_surface(py::module_& module) {
  py::class_<Surface, SharedSurface> surface(
      module, "Surface",
      R"(A triangle surface in patient coordinates (LPS, mm), with quantities on its points and triangles.

Made of points_mm (points, 3) and triangles (triangles, 3), whole numbers from 0, counter-clockwise seen from outside.
It never changes once it is made: its arrays are read only, share its memory, and live on when it is gone.

Raises glisson.Error: array-shape, array-not-whole, and what check_surface of the core refuses.)");
  surface.def(py::init(&make_surface), py::arg("points_mm"), py::arg("triangles"), py::kw_only(),
              py::arg("point_fields") = py::dict(), py::arg("cell_fields") = py::dict());
  add_fields(surface);
  surface
      .def_property_readonly(
          "triangles", [](const py::object& self) { return view(self.cast<const Surface&>().triangles, self); },
          "int32, shape (triangles, 3). Without a copy, read only.")
      .def_property_readonly(
          "area_mm2", [](const Surface& self) { return area_mm2(self); }, "mm2.")
      .def_property_readonly(
          "volume_mm3", [](const Surface& self) { return volume_mm3(self); },
          "Enclosed, mm3; meaningful only when watertight, negative for a surface turned inside out.")
      .def_property_readonly(
          "is_watertight", [](const Surface& self) { return is_watertight(self); },
          "Every edge is shared by exactly two triangles that run along it in opposite directions.")
      .def("__repr__", [](const Surface& self) {
        return "<glisson.Surface, " + std::to_string(self.points_mm.size()) + " points, " +
               std::to_string(self.triangles.size()) + " triangles>";
      });
}

void add_files(py::module_& module) {
  using std::filesystem::path;
  constexpr const char* failures =
      "\n\nRaises glisson.Error: file-not-readable, mesh-format-unknown, mesh-file-invalid, mesh-cell-type, "
      "mesh-too-large.";
  module.def(
      "read_surface",
      [](const path& file) { return std::make_shared<Surface>(short_call([&] { return read_surface(file); })); },
      py::arg("file"),
      (std::string("A .vtp, .vtk, .stl, .obj, .off or .ply file as a Surface; numeric arrays become fields.") +
       failures)
          .c_str());
  module.def(
      "write_surface",
      [](const path& file, const Surface& surface) { short_call([&] { return write_surface(file, surface); }); },
      py::arg("file"), py::arg("surface"), "Writes .vtp (with all fields), .stl, .obj or .ply, all or nothing.");
  module.def(
      "read_tetrahedra",
      [](const path& file) { return std::make_shared<TetMesh>(short_call([&] { return read_tetrahedra(file); })); },
      py::arg("file"), (std::string("A .vtu or .vtk file as a TetMesh.") + failures).c_str());
  module.def(
      "write_tetrahedra",
      [](const path& file, const TetMesh& mesh) { short_call([&] { return write_tetrahedra(file, mesh); }); },
      py::arg("file"), py::arg("mesh"), "Writes .vtu with all fields, all or nothing.");
}

}  // namespace

void add_geometry(py::module_& module) {
  add_surface(module);
  add_tetrahedra(module);
  add_files(module);
}

}  // namespace glisson::python
