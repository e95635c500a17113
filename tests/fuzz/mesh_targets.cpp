// Surfaces and tetrahedra in every format that is read. Seeds come from our own writers, and, of what we read and do
// not write (text PLY and STL, OFF, legacy VTK), from a few lines of text.

#include <functional>
#include <sstream>

#include "base/files.h"
#include "fuzz/target.h"
#include "geometry/mesh_file.h"
#include "support/shapes.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;
using geometry::Surface;
using geometry::TetMesh;

Surface painted_ball() {
  Surface ball = test::sphere_surface(10, 1);
  geometry::set_field(ball.point_fields, {"fixed", 1, std::vector<double>(ball.points_mm.size(), 1.0)});
  geometry::set_field(ball.cell_fields, {"error_mm", 1, std::vector<double>(ball.triangles.size(), 0.5)});
  return ball;
}

TetMesh stiff_box() {
  TetMesh box = test::box_of_tetrahedra({2, 1, 1}, {20, 10, 10});
  geometry::set_field(box.point_fields, {"displacement_mm", 3, std::vector<double>(3 * box.points_mm.size(), 0.25)});
  geometry::set_field(box.cell_fields, {"youngs_modulus_kPa", 1, std::vector<double>(box.cells.size(), 5.0)});
  return box;
}

template <typename Shape>
std::string points_of(const Shape& shape) {
  std::ostringstream text;
  for (const Eigen::Vector3d& point : shape.points_mm) text << point.transpose() << '\n';
  return text.str();
}
template <std::size_t N>
std::string cells_of(const std::vector<std::array<int, N>>& cells) {
  std::ostringstream text;
  for (const auto& cell : cells) {
    text << N;
    for (const int corner : cell) text << ' ' << corner;
    text << '\n';
  }
  return text.str();
}
std::string text_of(std::size_t number) { return std::to_string(number); }

std::string text_ply(const Surface& ball) {
  return "ply\nformat ascii 1.0\ncomment a ball\nelement vertex " + text_of(ball.points_mm.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + text_of(ball.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + points_of(ball) + cells_of(ball.triangles);
}
std::string off(const Surface& ball) {
  return "OFF\n" + text_of(ball.points_mm.size()) + " " + text_of(ball.triangles.size()) + " 0\n" + points_of(ball) +
         cells_of(ball.triangles);
}
std::string text_stl(const Surface& ball) {
  std::ostringstream text;
  text << "solid ball\n";
  for (const auto& triangle : ball.triangles) {
    text << "facet normal 0 0 1\nouter loop\n";
    for (const int corner : triangle) {
      text << "vertex " << ball.points_mm[static_cast<std::size_t>(corner)].transpose() << '\n';
    }
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid ball\n";
}
std::string legacy_surface(const Surface& ball) {
  return "# vtk DataFile Version 3.0\nball\nASCII\nDATASET POLYDATA\nPOINTS " + text_of(ball.points_mm.size()) +
         " double\n" + points_of(ball) + "POLYGONS " + text_of(ball.triangles.size()) + " " +
         text_of(4 * ball.triangles.size()) + "\n" + cells_of(ball.triangles);
}
std::string legacy_tetrahedra(const TetMesh& box) {
  std::string text = "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                     text_of(box.points_mm.size()) + " double\n" + points_of(box) + "CELLS " +
                     text_of(box.cells.size()) + " " + text_of(5 * box.cells.size()) + "\n" + cells_of(box.cells) +
                     "CELL_TYPES " + text_of(box.cells.size()) + "\n";
  for (std::size_t i = 0; i < box.cells.size(); ++i) text += "10\n";
  text += "CELL_DATA " + text_of(box.cells.size()) + "\nSCALARS youngs_modulus_kPa double 1\nLOOKUP_TABLE default\n";
  for (std::size_t i = 0; i < box.cells.size(); ++i) text += "5.5\n";
  return text;
}
// VTK XML as text, which our writers do not write, but many others do.
std::string text_vtp(const Surface& ball) {
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n<PolyData>\n"
       << "<Piece NumberOfPoints=\"" << ball.points_mm.size() << "\" NumberOfPolys=\"" << ball.triangles.size()
       << "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
       << points_of(ball) << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" "
       << "format=\"ascii\">\n";
  for (const auto& [a, b, c] : ball.triangles) text << a << ' ' << b << ' ' << c << '\n';
  text << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 1; i <= ball.triangles.size(); ++i) text << 3 * i << '\n';
  return text.str() + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string written(const fs::path& file, const std::function<Result<void>(const fs::path&)>& write) {
  promise(write(file).has_value(), "seeds can be written");
  return read_text_file(file).value();
}

void read_as_surface(const fs::path& file) {
  const auto surface = geometry::read_surface(file);
  if (!surface) {
    promise(surface.error().file == file, "an error that names its file");
    return;
  }
  promise(geometry::check_surface(*surface).has_value(), "a surface that later stages can use");
  for (const auto& field : surface->point_fields) {
    promise(field.items() == surface->points_mm.size(), "a value of each field a point");
  }
  for (const auto& field : surface->cell_fields) {
    promise(field.items() == surface->triangles.size(), "a value of each field a triangle");
  }
}

void read_as_tetrahedra(const fs::path& file) {
  const auto mesh = geometry::read_tetrahedra(file);
  if (!mesh) {
    promise(mesh.error().file == file, "an error that names its file");
    return;
  }
  promise(!mesh->cells.empty(), "tetrahedra");
  for (const auto& cell : mesh->cells) {
    for (const int corner : cell) {
      promise(corner >= 0 && std::size_t(corner) < mesh->points_mm.size(), "cells of points that exist");
    }
  }
  for (const Eigen::Vector3d& point : mesh->points_mm) promise(point.allFinite(), "points in a place");
  for (const auto& field : mesh->cell_fields) {
    promise(field.items() == mesh->cells.size(), "a value of each field a cell");
  }
}

using Seeds = std::vector<std::string>;

Target surface_target(const std::string& name, const std::string& extension, bool we_write_it,
                      const std::function<Seeds(const Surface&)>& texts) {
  return {name,
          [=](const fs::path& folder) {
            Seeds seeds = texts ? texts(painted_ball()) : Seeds();
            if (we_write_it) {
              seeds.push_back(written(folder / ("ball" + extension), [](const fs::path& file) {
                return geometry::write_surface(file, painted_ball());
              }));
            }
            return seeds;
          },
          [=](const std::string& bytes, const fs::path& folder) {
            read_as_surface(file_of(bytes, folder, "surface" + extension));
          }};
}

}  // namespace

std::vector<Target> targets() {
  return {surface_target("ply", ".ply", true, [](const Surface& ball) { return Seeds{text_ply(ball)}; }),
          surface_target("obj", ".obj", true, {}),
          surface_target("off", ".off", false, [](const Surface& ball) { return Seeds{off(ball)}; }),
          surface_target("stl", ".stl", true, [](const Surface& ball) { return Seeds{text_stl(ball)}; }),
          surface_target("vtp", ".vtp", true, [](const Surface& ball) { return Seeds{text_vtp(ball)}; }),
          surface_target("vtk-surface", ".vtk", false, [](const Surface& ball) { return Seeds{legacy_surface(ball)}; }),
          {"vtu",
           [](const fs::path& folder) {
             return Seeds{written(folder / "box.vtu",
                                  [](const fs::path& file) { return geometry::write_tetrahedra(file, stiff_box()); })};
           },
           [](const std::string& bytes, const fs::path& folder) {
             read_as_tetrahedra(file_of(bytes, folder, "mesh.vtu"));
           }},
          {"vtk-tetrahedra", [](const fs::path&) { return Seeds{legacy_tetrahedra(stiff_box())}; },
           [](const std::string& bytes, const fs::path& folder) {
             read_as_tetrahedra(file_of(bytes, folder, "mesh.vtk"));
           }}};
}

}  // namespace glisson::fuzz
