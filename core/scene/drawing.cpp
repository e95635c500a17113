#include "scene/drawing.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>

namespace glisson::scene {
namespace {

struct Line {
  vtkNew<vtkPolyData> pieces;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  double width_px = 1;
};

void set_pieces(vtkPolyData& into, const std::vector<Eigen::Vector3d>& ends_mm) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Eigen::Vector3d& end : ends_mm) points->InsertNextPoint(end.data());
  for (vtkIdType k = 0; k + 1 < static_cast<vtkIdType>(ends_mm.size()); k += 2) lines->InsertNextCell({k, k + 1});
  into.SetPoints(points);
  into.SetLines(lines);
}

}  // namespace

struct Drawing::Impl {
  explicit Impl(vtkRenderer& into) : renderer(into) {}

  vtkRenderer& renderer;
  std::vector<std::unique_ptr<Line>> lines;
  vtkNew<vtkImageData> image;
  vtkNew<vtkImageSliceMapper> mapper;
  vtkNew<vtkImageSlice> slice;
  imaging::Grid layer;
  bool has_cells = false;
  double pixel_scale = 1;
};

Drawing::Drawing(vtkRenderer& renderer) : impl_(std::make_unique<Impl>(renderer)) {
  impl_->mapper->SetInputData(impl_->image);
  impl_->slice->SetMapper(impl_->mapper);
  impl_->slice->GetProperty()->SetInterpolationTypeToNearest();
  impl_->slice->GetProperty()->SetAmbient(1);
  impl_->slice->GetProperty()->SetDiffuse(0);
  impl_->slice->ForceTranslucentOn();  // its colours are clear, which VTK does not look for
}

Drawing::~Drawing() {
  set_lines({});
  set_cells(std::nullopt);
}

void Drawing::set_lines(const std::vector<DrawnLines>& lines) {
  Impl& parts = *impl_;
  while (parts.lines.size() > lines.size()) {
    parts.renderer.RemoveActor(parts.lines.back()->actor);
    parts.lines.pop_back();
  }
  while (parts.lines.size() < lines.size()) {
    Line& line = *parts.lines.emplace_back(std::make_unique<Line>());
    line.mapper->SetInputData(line.pieces);
    line.mapper->ScalarVisibilityOff();
    line.actor->SetMapper(line.mapper);
    line.actor->GetProperty()->LightingOff();
    line.actor->PickableOff();
    parts.renderer.AddActor(line.actor);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Line& line = *parts.lines[k];
    set_pieces(*line.pieces, lines[k].ends_mm);
    line.width_px = lines[k].width_px;
    const Colour& colour = lines[k].colour;
    line.actor->GetProperty()->SetColor(colour.red, colour.green, colour.blue);
    line.actor->GetProperty()->SetLineWidth(static_cast<float>(line.width_px * parts.pixel_scale));
  }
}

void Drawing::set_cells(const std::optional<DrawnCells>& cells) {
  Impl& parts = *impl_;
  const bool wanted = cells && !cells->colours.empty();
  if (parts.has_cells != wanted) {
    if (wanted) {
      parts.renderer.AddViewProp(parts.slice);
    } else {
      parts.renderer.RemoveViewProp(parts.slice);
    }
    parts.has_cells = wanted;
  }
  if (!wanted) return;
  parts.layer = cells->layer;
  const auto& size = cells->layer.size;
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(4);
  values->SetNumberOfTuples(static_cast<vtkIdType>(cells->colours.size()));
  std::copy_n(cells->colours.front().data(), 4 * cells->colours.size(), values->GetPointer(0));
  parts.image->SetDimensions(size[0], size[1], size[2]);
  parts.image->GetPointData()->SetScalars(values);
  const auto thin = std::min_element(size.begin(), size.end()) - size.begin();
  parts.mapper->SetOrientation(static_cast<int>(thin));
}

void Drawing::lift(const Eigen::Vector3d& towards_viewer_mm) {
  Impl& parts = *impl_;
  for (std::size_t k = 0; k < parts.lines.size(); ++k) {
    const Eigen::Vector3d lift_mm = (2 + 0.1 * static_cast<double>(k)) * towards_viewer_mm;
    parts.lines[k]->actor->SetPosition(lift_mm.x(), lift_mm.y(), lift_mm.z());
  }
  if (!parts.has_cells) return;
  const Eigen::Vector3d origin_mm = parts.layer.origin_mm + 0.5 * towards_viewer_mm;
  vtkNew<vtkMatrix4x4> placement;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      placement->SetElement(row, column, parts.layer.direction(row, column) * parts.layer.spacing_mm[column]);
    }
    placement->SetElement(row, 3, origin_mm[row]);
  }
  parts.slice->SetUserMatrix(placement);
}

void Drawing::set_line_scale(double pixel_scale) {
  impl_->pixel_scale = pixel_scale;
  for (const auto& line : impl_->lines) {
    line->actor->GetProperty()->SetLineWidth(static_cast<float>(line->width_px * pixel_scale));
  }
}

// Marching squares on cells of four voxel centres; a voxel beyond the border counts as outside. Where two voxels that
// touch at a corner are inside, they are kept apart.
std::vector<Eigen::Vector3d> outline_in_layer(const imaging::Mask& mask, int axis, int layer) {
  const imaging::Grid& grid = mask.grid;
  const auto n = static_cast<std::size_t>(axis);
  if (layer < 0 || layer >= grid.size[n]) return {};
  const std::size_t across = axis == 0 ? 1 : 0, along = axis == 2 ? 1 : 2;
  std::array<int, 3> voxel{};
  voxel[n] = layer;
  const auto inside = [&](int a, int b) {
    if (a < 0 || b < 0 || a >= grid.size[across] || b >= grid.size[along]) return false;
    voxel[across] = a;
    voxel[along] = b;
    return mask.at(voxel[0], voxel[1], voxel[2]) != 0;
  };
  std::vector<Eigen::Vector3d> ends_mm;
  const auto add = [&](double a, double b) {
    Eigen::Vector3d index;
    index[axis] = layer;
    index[static_cast<Eigen::Index>(across)] = a;
    index[static_cast<Eigen::Index>(along)] = b;
    ends_mm.push_back(grid.position_mm(index));
  };
  for (int b = -1; b < grid.size[along]; ++b) {
    bool low_left = false, high_left = false;
    for (int a = -1; a < grid.size[across]; ++a) {
      const bool low_right = inside(a + 1, b), high_right = inside(a + 1, b + 1);
      // Each corner that differs from both its neighbours in the cell is cut off by one piece; else the line crosses.
      const int count = int(low_left) + int(low_right) + int(high_left) + int(high_right);
      const double left = a, right = a + 1, low = b, high = b + 1, middle_a = a + 0.5, middle_b = b + 0.5;
      if (count == 2 && low_left == low_right) {
        add(left, middle_b), add(right, middle_b);
      } else if (count == 2 && low_left == high_left) {
        add(middle_a, low), add(middle_a, high);
      } else if (count != 0 && count != 4) {
        const bool odd = count != 3;  // what the corners that stand alone hold
        if (low_left == odd) add(middle_a, low), add(left, middle_b);
        if (low_right == odd) add(middle_a, low), add(right, middle_b);
        if (high_left == odd) add(middle_a, high), add(left, middle_b);
        if (high_right == odd) add(middle_a, high), add(right, middle_b);
      }
      low_left = low_right;
      high_left = high_right;
    }
  }
  return ends_mm;
}

}  // namespace glisson::scene
