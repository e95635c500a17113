#include "geometry/internal/vtk_values.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTriangleFilter.h>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace glisson::geometry {
namespace {

std::vector<Eigen::Vector3d> points_from(vtkPoints* points) {
  std::vector<Eigen::Vector3d> positions(static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t i = 0; i < positions.size(); ++i) points->GetPoint(static_cast<vtkIdType>(i), positions[i].data());
  return positions;
}

vtkSmartPointer<vtkPoints> points_to_vtk(const std::vector<Eigen::Vector3d>& positions) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) points->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
  return points;
}

// Arrays of numbers with one tuple an item; others (strings, wrong length) are left out.
Fields fields_from(vtkFieldData* arrays, std::size_t items) {
  Fields fields;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = arrays->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr) continue;
    if (array->GetNumberOfComponents() < 1 || array->GetNumberOfTuples() != static_cast<vtkIdType>(items)) continue;
    Field field{array->GetName(), array->GetNumberOfComponents(), {}};
    field.values.resize(items * static_cast<std::size_t>(field.components));
    for (std::size_t item = 0; item < items; ++item) {
      array->GetTuple(static_cast<vtkIdType>(item),
                      field.values.data() + item * static_cast<std::size_t>(field.components));
    }
    set_field(fields, std::move(field));
  }
  return fields;
}

void fields_to_vtk(const Fields& fields, vtkFieldData* arrays) {
  for (const Field& field : fields) {
    const vtkNew<vtkDoubleArray> array;
    array->SetName(field.name.c_str());
    array->SetNumberOfComponents(field.components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(field.items()));
    std::copy(field.values.begin(), field.values.end(), array->GetPointer(0));
    arrays->AddArray(array);
  }
}

// The points of cell i are connectivity[offsets[i]] up to connectivity[offsets[i + 1]].
struct CellList {
  const vtkTypeInt64* offsets;
  const vtkTypeInt64* connectivity;
  std::size_t cells;
};

// Nothing when the offsets go backwards or beyond the connectivity, or a point is named that does not exist.
std::optional<CellList> checked_cells(vtkCellArray* array, vtkIdType points) {
  if (array == nullptr) return std::nullopt;
  array->ConvertTo64BitStorage();
  const auto offsets = array->GetOffsetsArray64();
  const auto connectivity = array->GetConnectivityArray64();
  const CellList list{offsets->GetPointer(0), connectivity->GetPointer(0),
                      static_cast<std::size_t>(array->GetNumberOfCells())};
  if (list.cells == 0) return list;
  for (std::size_t i = 0; i < list.cells; ++i) {
    if (list.offsets[i] < 0 || list.offsets[i + 1] < list.offsets[i]) return std::nullopt;
  }
  if (list.offsets[list.cells] > connectivity->GetNumberOfValues()) return std::nullopt;
  for (vtkTypeInt64 i = 0; i < list.offsets[list.cells]; ++i) {
    if (list.connectivity[i] < 0 || list.connectivity[i] >= points) return std::nullopt;
  }
  return list;
}

template <std::size_t Corners>
vtkSmartPointer<vtkCellArray> cells_to_vtk(const std::vector<std::array<int, Corners>>& cells) {
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->AllocateExact(static_cast<vtkIdType>(cells.size()), static_cast<vtkIdType>(Corners * cells.size()));
  for (const auto& cell : cells) {
    array->InsertNextCell(static_cast<int>(Corners));
    for (const int corner : cell) array->InsertCellPoint(corner);
  }
  return array;
}

}  // namespace

Result<Surface> surface_from(vtkPolyData* polygons, const std::filesystem::path& file) {
  const vtkIdType points = polygons->GetNumberOfPoints();
  for (vtkCellArray* cells :
       {polygons->GetVerts(), polygons->GetLines(), polygons->GetPolys(), polygons->GetStrips()}) {
    if (!checked_cells(cells, points))
      return mesh_file_invalid(file, GLISSON_TEXT("a cell names a point that does not exist"));
  }
  const vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(polygons);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();

  Surface surface;
  surface.points_mm = points_from(polygons->GetPoints());
  const auto cells = checked_cells(triangulate->GetOutput()->GetPolys(), points);
  if (!cells) return mesh_file_invalid(file, GLISSON_TEXT("its polygons cannot be cut into triangles"));
  for (std::size_t i = 0; i < cells->cells; ++i) {
    const vtkTypeInt64* corners = cells->connectivity + cells->offsets[i];
    surface.triangles.push_back(
        {static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2])});
  }
  surface.point_fields = fields_from(polygons->GetPointData(), surface.points_mm.size());
  surface.cell_fields = fields_from(triangulate->GetOutput()->GetCellData(), surface.triangles.size());
  if (auto checked = check_surface(surface); !checked) return failure(std::move(checked.error()).in_file(file));
  return surface;
}

Result<Surface> triangles_from(vtkUnstructuredGrid* grid, const std::filesystem::path& file) {
  const auto cells = checked_cells(grid->GetCells(), grid->GetNumberOfPoints());
  if (!cells) return mesh_file_invalid(file, GLISSON_TEXT("a cell names a point that does not exist"));
  Surface surface;
  for (std::size_t i = 0; i < cells->cells; ++i) {
    const int type = grid->GetCellType(static_cast<vtkIdType>(i));
    const vtkTypeInt64 count = cells->offsets[i + 1] - cells->offsets[i];
    const vtkTypeInt64* given = cells->connectivity + cells->offsets[i];
    const auto add = [&](int a, int b, int c) {
      surface.triangles.push_back({static_cast<int>(given[a]), static_cast<int>(given[b]), static_cast<int>(given[c])});
    };
    const bool triangle = (type == VTK_TRIANGLE && count == 3) || (type == VTK_QUADRATIC_TRIANGLE && count == 6);
    if (triangle || (type == VTK_QUAD && count == 4)) {
      add(0, 1, 2);
      if (!triangle) add(0, 2, 3);
    } else if (type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_LINE && type != VTK_POLY_LINE &&
               type != VTK_QUADRATIC_EDGE) {
      const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
      return failure(
          Error{"mesh-cell-type",
                GLISSON_TEXT("Cell {1} of {0} is a {2} of {3} points; only triangles and quadrangles are used."),
                {file.filename().string(), std::to_string(i), name != nullptr ? name : "nameless cell",
                 std::to_string(count)},
                GLISSON_TEXT("Cut it into triangles first, for example with ParaView's Triangulate."),
                file});
    }
  }
  surface.points_mm = points_from(grid->GetPoints());
  surface.point_fields = fields_from(grid->GetPointData(), surface.points_mm.size());
  if (auto checked = check_surface(surface); !checked) return failure(std::move(checked.error()).in_file(file));
  return surface;
}

vtkSmartPointer<vtkPolyData> polygons_from(const Surface& surface) {
  auto polygons = vtkSmartPointer<vtkPolyData>::New();
  polygons->SetPoints(points_to_vtk(surface.points_mm));
  polygons->SetPolys(cells_to_vtk(surface.triangles));
  fields_to_vtk(surface.point_fields, polygons->GetPointData());
  fields_to_vtk(surface.cell_fields, polygons->GetCellData());
  return polygons;
}

Result<TetMesh> tetrahedra_from(vtkUnstructuredGrid* grid, const std::filesystem::path& file) {
  const auto cells = checked_cells(grid->GetCells(), grid->GetNumberOfPoints());
  if (!cells) return mesh_file_invalid(file, GLISSON_TEXT("a cell names a point that does not exist"));

  TetMesh mesh;
  for (std::size_t i = 0; i < cells->cells; ++i) {
    const int type = grid->GetCellType(static_cast<vtkIdType>(i));
    const vtkTypeInt64 corners_given = cells->offsets[i + 1] - cells->offsets[i];
    const bool tetrahedron =
        (type == VTK_TETRA && corners_given == 4) || (type == VTK_QUADRATIC_TETRA && corners_given == 10);
    if (!tetrahedron) {
      const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
      return failure(Error{"mesh-cell-type",
                           GLISSON_TEXT("Cell {1} of {0} is a {2} of {3} points; only tetrahedra are used."),
                           {file.filename().string(), std::to_string(i), name != nullptr ? name : "nameless cell",
                            std::to_string(corners_given)},
                           GLISSON_TEXT("Cut it into tetrahedra first, for example with ParaView's Tetrahedralize."),
                           file});
    }
    const vtkTypeInt64* corners = cells->connectivity + cells->offsets[i];
    mesh.cells.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]),
                          static_cast<int>(corners[3])});
  }
  if (mesh.cells.empty()) return mesh_file_invalid(file, GLISSON_TEXT("it holds no tetrahedra"));
  mesh.points_mm = points_from(grid->GetPoints());
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    if (!mesh.points_mm[i].allFinite())
      return mesh_file_invalid(file, "point " + std::to_string(i) + " has no finite position");
  }
  mesh.point_fields = fields_from(grid->GetPointData(), mesh.points_mm.size());
  mesh.cell_fields = fields_from(grid->GetCellData(), mesh.cells.size());

  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    if (cell_volume_mm3(mesh, i) < 0) std::swap(mesh.cells[i][2], mesh.cells[i][3]);
  }
  std::vector<int> all(mesh.cells.size());
  std::iota(all.begin(), all.end(), 0);
  return part_of(mesh, all);
}

vtkSmartPointer<vtkUnstructuredGrid> grid_from(const TetMesh& mesh) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_to_vtk(mesh.points_mm));
  grid->SetCells(VTK_TETRA, cells_to_vtk(mesh.cells));
  fields_to_vtk(mesh.point_fields, grid->GetPointData());
  fields_to_vtk(mesh.cell_fields, grid->GetCellData());
  return grid;
}

Failure mesh_file_invalid(const std::filesystem::path& file, const std::string& reason) {
  return failure(Error{"mesh-file-invalid",
                       GLISSON_TEXT("{0} cannot be read as a mesh: {1}."),
                       {file.filename().string(), reason},
                       GLISSON_TEXT("Open it in ParaView to see whether it is damaged."),
                       file});
}

}  // namespace glisson::geometry
