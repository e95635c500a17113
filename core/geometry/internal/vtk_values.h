#pragma once
// Meshes between VTK's data and ours: points, cells and fields. Positions in mm. For the .cpp files of this room alone,
// since it shows VTK.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <filesystem>
#include <string>

#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::geometry {

// Polygons and strips cut into triangles; triangles and quadrangles of a grid; tetrahedra of a grid, each of positive
// volume, without points that no cell names. Fields of numbers come along. `file` stands in what is said when they fail
// with mesh-file-invalid or mesh-cell-type.
Result<Surface> surface_from(vtkPolyData* polygons, const std::filesystem::path& file);
Result<Surface> triangles_from(vtkUnstructuredGrid* grid, const std::filesystem::path& file);
Result<TetMesh> tetrahedra_from(vtkUnstructuredGrid* grid, const std::filesystem::path& file);

vtkSmartPointer<vtkPolyData> polygons_from(const Surface& surface);
vtkSmartPointer<vtkUnstructuredGrid> grid_from(const TetMesh& mesh);

[[nodiscard]] Failure mesh_file_invalid(const std::filesystem::path& file, const std::string& reason);

}  // namespace glisson::geometry
