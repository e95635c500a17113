#include "scene/slice_actor.h"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdgesPlaneCutter.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#include <Eigen/Geometry>

namespace glisson::scene {
namespace {

// The grid's place in the patient: voxel index to mm. Images go to VTK in index space, so that rotated and anisotropic
// grids are placed by this matrix alone.
vtkNew<vtkMatrix4x4> placement(const imaging::Grid& grid) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix->SetElement(row, column, grid.direction(row, column) * grid.spacing_mm[column]);
    }
    matrix->SetElement(row, 3, grid.origin_mm[row]);
  }
  return matrix;
}

vtkNew<vtkImageData> image_in_index_space(const imaging::Grid& grid, vtkDataArray* values) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size[0], grid.size[1], grid.size[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

void set_segments(vtkPolyData& outcome, const std::vector<Eigen::Vector3d>& ends_mm) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Eigen::Vector3d& end : ends_mm) points->InsertNextPoint(end.data());
  for (vtkIdType k = 0; k + 1 < static_cast<vtkIdType>(ends_mm.size()); k += 2) lines->InsertNextCell({k, k + 1});
  outcome.SetPoints(points);
  outcome.SetLines(lines);
}

std::vector<Eigen::Vector3d> outline(const imaging::Mask& mask, const Plane& plane) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetArray(const_cast<std::uint8_t*>(mask.values.data()), static_cast<vtkIdType>(mask.values.size()), 1);
  // The plane in index space: a normal goes through the transposed matrix.
  const Eigen::Matrix3d to_mm = mask.grid.direction * mask.grid.spacing_mm.asDiagonal();
  const Eigen::Vector3d origin = mask.grid.index_of(plane.center_mm);
  const Eigen::Vector3d normal = (to_mm.transpose() * plane.normal).normalized();
  vtkNew<vtkPlane> cut_plane;
  cut_plane->SetOrigin(origin.x(), origin.y(), origin.z());
  cut_plane->SetNormal(normal.x(), normal.y(), normal.z());
  vtkNew<vtkFlyingEdgesPlaneCutter> cutter;
  cutter->SetInputData(image_in_index_space(mask.grid, values));
  cutter->SetPlane(cut_plane);
  cutter->ComputeNormalsOff();
  cutter->InterpolateAttributesOn();
  vtkNew<vtkContourFilter> boundary;
  boundary->SetInputConnection(cutter->GetOutputPort());
  boundary->SetValue(0, 0.5);
  boundary->Update();

  std::vector<Eigen::Vector3d> ends_mm;
  vtkPolyData& lines = *boundary->GetOutput();
  vtkNew<vtkIdList> cell;
  for (lines.GetLines()->InitTraversal(); lines.GetLines()->GetNextCell(cell) != 0;) {
    for (vtkIdType k = 0; k + 1 < cell->GetNumberOfIds(); ++k) {
      for (const vtkIdType end : {cell->GetId(k), cell->GetId(k + 1)}) {
        ends_mm.push_back(mask.grid.position_mm(Eigen::Vector3d(lines.GetPoint(end))));
      }
    }
  }
  return ends_mm;
}

}  // namespace

std::vector<Eigen::Vector3d> cut(const geometry::Surface& surface, const Plane& plane) {
  std::vector<double> height_mm(surface.points_mm.size());
  for (std::size_t p = 0; p < height_mm.size(); ++p) {
    height_mm[p] = plane.normal.dot(surface.points_mm[p] - plane.center_mm);
  }
  std::vector<Eigen::Vector3d> ends_mm;
  for (const auto& triangle : surface.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const auto a = static_cast<std::size_t>(triangle[static_cast<std::size_t>(corner)]);
      const auto b = static_cast<std::size_t>(triangle[static_cast<std::size_t>((corner + 1) % 3)]);
      // A point on the plane counts as above: each triangle then has no or two crossing edges.
      if ((height_mm[a] < 0) == (height_mm[b] < 0)) continue;
      const double share = height_mm[a] / (height_mm[a] - height_mm[b]);
      ends_mm.push_back(surface.points_mm[a] + share * (surface.points_mm[b] - surface.points_mm[a]));
    }
  }
  return ends_mm;
}

SliceActor::SliceActor(vtkRenderer& renderer, const SliceItem& item)
    : renderer_(renderer), item_(item), plane_{item.center_mm, item.normal.normalized()} {
  add_volume();
  for (const CutLine& wanted : item_.cuts) {
    Line& line = add_line(wanted.colour, wanted.width_px);
    line.original = line.now = wanted.surface.get();
  }
  for (const MaskLine& wanted : item_.masks) add_line(wanted.colour, wanted.width_px).mask = wanted.mask;
  move_to(item_.center_mm);
}

SliceActor::~SliceActor() {
  renderer_.RemoveViewProp(slice_);
  for (const auto& line : lines_) renderer_.RemoveActor(line->actor);
}

void SliceActor::move_to(const Eigen::Vector3d& center_mm) {
  plane_.center_mm = center_mm;
  item_.center_mm = center_mm;
  vtk_plane_->SetOrigin(center_mm.x(), center_mm.y(), center_mm.z());
  vtk_plane_->SetNormal(plane_.normal.x(), plane_.normal.y(), plane_.normal.z());
  draw_lines();
}

void SliceActor::set_window(double center, double width) {
  item_.window_center = center;
  item_.window_width = width;
  property_->SetColorLevel(center);
  property_->SetColorWindow(width);
}

void SliceActor::recut(const geometry::Surface* original, const geometry::Surface& now) {
  for (const auto& line : lines_) {
    if (line->original != original) continue;
    line->now = &now;
    draw_line(*line);
  }
}

void SliceActor::lift_lines(const Eigen::Vector3d& towards_viewer_mm) {
  for (const auto& line : lines_) {
    line->actor->SetPosition(towards_viewer_mm.x(), towards_viewer_mm.y(), towards_viewer_mm.z());
  }
}

void SliceActor::set_line_scale(double pixel_scale) {
  for (const auto& line : lines_) {
    line->actor->GetProperty()->SetLineWidth(static_cast<float>(line->width_px * pixel_scale));
  }
}

void SliceActor::add_volume() {
  vtkNew<vtkFloatArray> values;
  // VTK reads only; the volume is not copied, and item_ keeps it alive.
  values->SetArray(const_cast<float*>(item_.volume->values.data()), static_cast<vtkIdType>(item_.volume->values.size()),
                   1);
  mapper_->SetInputData(image_in_index_space(item_.volume->grid, values));
  mapper_->SetSlicePlane(vtk_plane_);
  mapper_->SliceFacesCameraOff();
  mapper_->SliceAtFocalPointOff();
  constexpr int steps = 256;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(steps);
  for (int k = 0; k < steps; ++k) {
    const Colour colour = colour_at(item_.map, k / double(steps - 1));
    table->SetTableValue(k, colour.red, colour.green, colour.blue, 1);
  }
  property_->SetLookupTable(table);
  property_->SetInterpolationTypeToLinear();
  property_->SetOpacity(item_.opacity);
  property_->SetAmbient(1);
  property_->SetDiffuse(0);
  set_window(item_.window_center, item_.window_width);
  slice_->SetMapper(mapper_);
  slice_->SetProperty(property_);
  slice_->SetUserMatrix(placement(item_.volume->grid));
  renderer_.AddViewProp(slice_);
}

SliceActor::Line& SliceActor::add_line(const Colour& colour, double width_px) {
  Line& line = *lines_.emplace_back(std::make_unique<Line>());
  line.width_px = width_px;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(line.segments);
  mapper->ScalarVisibilityOff();
  line.actor->SetMapper(mapper);
  vtkProperty& property = *line.actor->GetProperty();
  property.LightingOff();
  property.SetColor(colour.red, colour.green, colour.blue);
  property.SetLineWidth(static_cast<float>(width_px));
  renderer_.AddActor(line.actor);
  return line;
}

void SliceActor::draw_lines() {
  for (const auto& line : lines_) draw_line(*line);
}

void SliceActor::draw_line(Line& line) const {
  set_segments(*line.segments, line.mask ? outline(*line.mask, plane_) : cut(*line.now, plane_));
}

}  // namespace glisson::scene
