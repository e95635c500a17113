// ITK's filters over our images. They are templates that compile slowly: all of them are here.

#include "imaging/filters.h"

#include <itkBinaryFillholeImageFilter.h>
#include <itkConnectedComponentImageFilter.h>
#include <itkMultiThreaderBase.h>
#include <itkRecursiveGaussianImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>
#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "base/result.h"

namespace glisson::imaging {
namespace {

template <typename Value>
using ItkImage = itk::Image<Value, 3>;

// ITK's image over the same values, which are neither copied nor owned. Positions in space play no part here.
template <typename Value>
typename ItkImage<Value>::Pointer view(const Grid& grid, const std::vector<Value>& values) {
  GLISSON_ASSERT(values.size() == grid.voxels() && !values.empty());
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(static_cast<itk::ThreadIdType>(thread_count()));
  auto image = ItkImage<Value>::New();
  typename ItkImage<Value>::SizeType size;
  typename ItkImage<Value>::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(grid.size[axis]);
    spacing[axis] = grid.spacing_mm[axis];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  // The inputs of filters are only read.
  image->GetPixelContainer()->SetImportPointer(const_cast<Value*>(values.data()), values.size(), false);
  return image;
}

template <typename Value>
std::vector<Value> values_of(const ItkImage<Value>& image) {
  const Value* first = image.GetBufferPointer();
  return {first, first + image.GetBufferedRegion().GetNumberOfPixels()};
}

}  // namespace

std::vector<float> gaussian_blur(std::vector<float> values, const Grid& grid, double sd_mm) {
  constexpr int fewest_voxels = 4;  // of the recursion
  constexpr double smallest_sd_voxels = 1.0 / 3;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (grid.size[axis] < fewest_voxels || sd_mm < smallest_sd_voxels * grid.spacing_mm[axis]) continue;
    auto filter = itk::RecursiveGaussianImageFilter<ItkImage<float>>::New();
    filter->SetInput(view(grid, values));
    filter->SetDirection(axis);
    filter->SetSigma(sd_mm);
    filter->Update();
    values = values_of(*filter->GetOutput());
  }
  return values;
}

std::vector<float> squared_distances_mm2(const Mask& mask) {
  if (std::all_of(mask.values.begin(), mask.values.end(), [](std::uint8_t value) { return value == 0; })) {
    return std::vector<float>(mask.values.size(), std::numeric_limits<float>::infinity());
  }
  auto filter = itk::SignedMaurerDistanceMapImageFilter<ItkImage<std::uint8_t>, ItkImage<float>>::New();
  filter->SetInput(view(mask.grid, mask.values));
  filter->SquaredDistanceOn();
  filter->UseImageSpacingOn();
  filter->Update();
  std::vector<float> squared_mm2 = values_of(*filter->GetOutput());
  for (std::size_t voxel = 0; voxel < squared_mm2.size(); ++voxel) {
    if (mask.values[voxel] != 0) squared_mm2[voxel] = 0;  // there it is the depth
  }
  return squared_mm2;
}

std::vector<float> squared_depths_mm2(const Mask& mask) {
  Mask outside = mask;
  for (std::uint8_t& value : outside.values) value = value == 0 ? 1 : 0;
  return squared_distances_mm2(outside);
}

ConnectedVoxels connected_voxels(const Mask& mask, Neighbours neighbours) {
  auto filter = itk::ConnectedComponentImageFilter<ItkImage<std::uint8_t>, ItkImage<std::uint32_t>>::New();
  filter->SetInput(view(mask.grid, mask.values));
  filter->SetFullyConnected(neighbours == Neighbours::all);
  filter->Update();
  ConnectedVoxels connected{values_of(*filter->GetOutput()), std::vector<std::size_t>(filter->GetObjectCount() + 1, 0)};
  for (const std::uint32_t piece : connected.piece) ++connected.sizes[piece];
  return connected;
}

std::uint32_t ConnectedVoxels::largest() const {
  if (sizes.size() < 2) return 0;
  return static_cast<std::uint32_t>(std::max_element(sizes.begin() + 1, sizes.end()) - sizes.begin());
}

Mask fill_holes(const Mask& mask) {
  auto filter = itk::BinaryFillholeImageFilter<ItkImage<std::uint8_t>>::New();
  filter->SetInput(view(mask.grid, mask.values));
  filter->SetForegroundValue(1);
  filter->Update();
  return {mask.grid, values_of(*filter->GetOutput())};
}

}  // namespace glisson::imaging
