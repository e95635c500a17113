#include "scene/internal/backdrop_actor.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>
#include <algorithm>
#include <cstring>

namespace glisson::scene {
namespace {

// A card draws what the scan has; a processor keeps up with an eighth of the voxels.
constexpr int largest_side_by_card = 256;
constexpr int largest_side_by_processor = 128;
// Of the densest: a hand's breadth of bone lets little through, a rib about half.
constexpr double densest_opacity_per_cm = 0.5;

vtkNew<vtkImageData> image_of(const CoarseBackdrop& coarse) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(coarse.values.size()));
  std::memcpy(values->GetPointer(0), coarse.values.data(), coarse.values.size());
  vtkNew<vtkImageData> image;
  image->SetDimensions(coarse.grid.size[0], coarse.grid.size[1], coarse.grid.size[2]);
  image->SetSpacing(coarse.grid.spacing_mm[0], coarse.grid.spacing_mm[1], coarse.grid.spacing_mm[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

// Turns and shifts alone: the spacing is the image's own.
vtkNew<vtkMatrix4x4> grid_placement(const imaging::Grid& grid) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, grid.direction(row, column));
    matrix->SetElement(row, 3, grid.origin_mm[row]);
  }
  return matrix;
}

}  // namespace

BackdropActor::BackdropActor(vtkRenderWindow& window, vtkRenderer& renderer, const Backdrop& backdrop, Drawn drawn)
    : window_(window), renderer_(renderer) {
  const bool by_card = drawn == Drawn::by_card;
  const CoarseBackdrop coarse = coarsened(backdrop, by_card ? largest_side_by_card : largest_side_by_processor);
  if (by_card) {
    mapper_ = vtkSmartPointer<vtkSmartVolumeMapper>::New();  // which takes a processor where the card refuses
  } else {
    const auto rays = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    rays->AutoAdjustSampleDistancesOff();
    rays->IntermixIntersectingGeometryOff();  // nothing else stands in its layer
    mapper_ = rays;
  }
  mapper_->SetInputData(image_of(coarse));
  mapper_->AddClippingPlane(front_);
  set_detail(Detail::full);

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(255, densest_opacity_per_cm);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0, 0.42, 0.33, 0.30);
  colour->AddRGBPoint(255, 0.93, 0.90, 0.84);
  volume_->GetProperty()->SetScalarOpacity(opacity);
  constexpr double cm_mm = 10;
  volume_->GetProperty()->SetScalarOpacityUnitDistance(cm_mm);
  volume_->GetProperty()->SetColor(colour);
  volume_->GetProperty()->SetInterpolationTypeToLinear();
  volume_->GetProperty()->ShadeOff();
  volume_->SetMapper(mapper_);
  volume_->SetUserMatrix(grid_placement(coarse.grid));
  volume_->PickableOff();
  behind_->AddVolume(volume_);
  window_.SetNumberOfLayers(2);
  window_.AddRenderer(behind_);
  renderer_.SetLayer(1);
}

BackdropActor::~BackdropActor() {
  behind_->RemoveVolume(volume_);
  window_.RemoveRenderer(behind_);
  renderer_.SetLayer(0);
  window_.SetNumberOfLayers(1);
}

void BackdropActor::stand_behind(const Eigen::Vector3d& middle_mm, const Eigen::Vector3d& sight) {
  front_->SetOrigin(middle_mm.x(), middle_mm.y(), middle_mm.z());
  front_->SetNormal(sight.x(), sight.y(), sight.z());
  behind_->SetBackground(renderer_.GetBackground());
  behind_->SetBackground2(renderer_.GetBackground2());
  behind_->SetGradientBackground(renderer_.GetGradientBackground());
  behind_->GetActiveCamera()->DeepCopy(renderer_.GetActiveCamera());
  behind_->ResetCameraClippingRange();
}

// Soft light needs no ray through each pixel.
void BackdropActor::set_detail(Detail detail) {
  auto* rays = vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper_);
  if (rays == nullptr) return;
  const bool full = detail == Detail::full;
  rays->SetImageSampleDistance(full ? 2 : 4);
  rays->SetSampleDistance(full ? 3 : 6);  // mm along a ray
}

}  // namespace glisson::scene
