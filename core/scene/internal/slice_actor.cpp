#include "scene/internal/slice_actor.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <algorithm>
#include <cmath>
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

// The lines along which values on a triangle mesh change sign: two points each. A value of zero counts as positive, so
// that a triangle has either no or two crossing edges.
std::vector<Eigen::Vector3d> sign_changes(const std::vector<Eigen::Vector3d>& points_mm,
                                          const std::vector<std::array<int, 3>>& triangles,
                                          const std::vector<double>& values) {
  std::vector<Eigen::Vector3d> ends_mm;
  for (const auto& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto a = static_cast<std::size_t>(triangle[corner]);
      const auto b = static_cast<std::size_t>(triangle[(corner + 1) % 3]);
      if ((values[a] < 0) == (values[b] < 0)) continue;
      const double share = values[a] / (values[a] - values[b]);
      ends_mm.push_back(points_mm[a] + share * (points_mm[b] - points_mm[a]));
    }
  }
  return ends_mm;
}

// How much of the eight voxels around a position belongs to the mask, weighted by nearness: 0..1.
double share_at(const imaging::Mask& mask, const Eigen::Vector3d& position_mm) {
  const Eigen::Vector3d index = mask.grid.index_of(position_mm);
  const Eigen::Vector3d low = index.array().floor();
  const Eigen::Vector3d part = index - low;
  double share = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const Eigen::Vector3i voxel = low.cast<int>() + step;
    if (!mask.grid.contains(voxel.x(), voxel.y(), voxel.z())) continue;
    if (mask.at(voxel.x(), voxel.y(), voxel.z()) == 0) continue;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? part[axis] : 1 - part[axis];
    share += weight;
  }
  return share;
}

// The mask sampled on a lattice in the plane, about a voxel apart, and outlined where half of it is inside.
std::vector<Eigen::Vector3d> outline(const imaging::Mask& mask, const Plane& plane) {
  const imaging::Grid& grid = mask.grid;
  const Eigen::Vector3d middle_mm =
      grid.position_mm(Eigen::Vector3d(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1) * 0.5);
  const Eigen::Vector3d center_mm = middle_mm - plane.normal.dot(middle_mm - plane.center_mm) * plane.normal;
  const Eigen::Vector3d extent_mm =
      grid.spacing_mm.cwiseProduct(Eigen::Vector3d(grid.size[0], grid.size[1], grid.size[2]));
  constexpr int maximum_steps = 512;
  const double reach_mm = 0.5 * extent_mm.norm();
  const double step_mm = std::max(grid.spacing_mm.minCoeff(), 2 * reach_mm / maximum_steps);
  const int count = static_cast<int>(std::ceil(2 * reach_mm / step_mm)) + 1;
  const Eigen::Vector3d across = plane.normal.unitOrthogonal();
  const Eigen::Vector3d along = plane.normal.cross(across);

  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> values;
  std::vector<std::array<int, 3>> triangles;
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const Eigen::Vector3d point_mm =
          center_mm + (column * step_mm - reach_mm) * across + (row * step_mm - reach_mm) * along;
      const int here = row * count + column;
      points_mm.push_back(point_mm);
      values.push_back(share_at(mask, point_mm) - 0.5);
      if (row + 1 == count || column + 1 == count) continue;
      triangles.push_back({here, here + 1, here + count});
      triangles.push_back({here + 1, here + count + 1, here + count});
    }
  }
  return sign_changes(points_mm, triangles, values);
}

}  // namespace

std::vector<Eigen::Vector3d> cut(const geometry::Surface& surface, const Plane& plane) {
  std::vector<double> height_mm(surface.points_mm.size());
  for (std::size_t p = 0; p < height_mm.size(); ++p) {
    height_mm[p] = plane.normal.dot(surface.points_mm[p] - plane.center_mm);
  }
  // A sheet that lies in the plane has no line in it, whatever side rounding puts its points on.
  constexpr double in_the_plane_mm = 0.01;
  const auto [lowest, highest] = std::minmax_element(height_mm.begin(), height_mm.end());
  if (lowest == height_mm.end() || (*highest<in_the_plane_mm&& * lowest> - in_the_plane_mm)) return {};
  return sign_changes(surface.points_mm, surface.triangles, height_mm);
}

SliceActor::SliceActor(vtkRenderer& renderer, const SliceItem& item)
    : renderer_(renderer), item_(item), plane_{item.center_mm, item.normal.normalized()} {
  add_volume();
  for (const CutLine& wanted : item_.cuts) {
    Line& line = add_line(wanted.colour, wanted.width_px);
    line.original = line.now = wanted.surface.get();
  }
  for (const MaskLine& wanted : item_.masks) add_line(wanted.colour, wanted.width_px).mask = wanted.mask;
  place(item_.center_mm, item_.normal);
}

SliceActor::~SliceActor() {
  renderer_.RemoveViewProp(slice_);
  for (const auto& line : lines_) renderer_.RemoveActor(line->actor);
}

void SliceActor::place(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal) {
  plane_ = {center_mm, normal.normalized()};
  item_.center_mm = center_mm;
  item_.normal = plane_.normal;
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
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    // Each line above the one before.
    const Eigen::Vector3d lift_mm = (1 + 0.1 * static_cast<double>(k)) * towards_viewer_mm;
    lines_[k]->actor->SetPosition(lift_mm.x(), lift_mm.y(), lift_mm.z());
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
