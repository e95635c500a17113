#include "meshing/mask_surface.h"

#include <vtkCellArray.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>
#include <algorithm>

namespace glisson::meshing {
namespace {

// The part of the grid that holds the mask, as first and last index along each axis.
struct Extent {
  std::array<int, 3> first{0, 0, 0};
  std::array<int, 3> last{-1, -1, -1};
};

Extent extent_of(const imaging::Mask& mask) {
  Extent extent{mask.grid.size, {-1, -1, -1}};
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (!mask.at(i, j, k)) continue;
        const std::array<int, 3> index{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          extent.first[axis] = std::min(extent.first[axis], index[axis]);
          extent.last[axis] = std::max(extent.last[axis], index[axis]);
        }
      }
    }
  }
  return extent;
}

// The mask's part of the image with one empty voxel around it, so that the surface closes at the border. Spacing 1,
// origin at the index: the points come out as voxel indices.
vtkNew<vtkImageData> padded_image(const imaging::Mask& mask, const Extent& extent) {
  vtkNew<vtkImageData> image;
  image->SetExtent(extent.first[0] - 1, extent.last[0] + 1, extent.first[1] - 1, extent.last[1] + 1,
                   extent.first[2] - 1, extent.last[2] + 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int k = extent.first[2] - 1; k <= extent.last[2] + 1; ++k) {
    for (int j = extent.first[1] - 1; j <= extent.last[1] + 1; ++j) {
      for (int i = extent.first[0] - 1; i <= extent.last[0] + 1; ++i) {
        *voxel++ = mask.grid.contains(i, j, k) && mask.at(i, j, k) ? 1 : 0;
      }
    }
  }
  return image;
}

}  // namespace

Result<geometry::Surface> mask_surface(const imaging::Mask& mask, const MaskSurfaceOptions& options) {
  const Extent extent = extent_of(mask);
  if (extent.last[0] < 0) return failure("mask-empty", GLISSON_TEXT("A structure without voxels has no surface."));

  const auto image = padded_image(mask, extent);
  vtkNew<vtkDiscreteFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 1);
  contour->ComputeScalarsOff();
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(contour->GetOutputPort());
  smooth->SetNumberOfIterations(options.smoothing_iterations);
  smooth->SetPassBand(options.pass_band);
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  smooth->Update();

  vtkPolyData* poly = smooth->GetOutput();
  geometry::Surface surface;
  surface.points_mm.reserve(static_cast<std::size_t>(poly->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < poly->GetNumberOfPoints(); ++p) {
    surface.points_mm.push_back(mask.grid.position_mm(Eigen::Vector3d(poly->GetPoint(p))));
  }
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (poly->GetPolys()->InitTraversal(); poly->GetPolys()->GetNextCell(count, points);) {
    surface.triangles.push_back(
        {static_cast<int>(points[0]), static_cast<int>(points[1]), static_cast<int>(points[2])});
  }
  // Which way round the triangles run depends on the grid's handedness; a closed surface tells by its volume.
  if (geometry::volume_mm3(surface) < 0) {
    for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  }
  return surface;
}

}  // namespace glisson::meshing
