#include "segmentation/mask_difference.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "segmentation/edit.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

Mask start_mask() {
  Mask mask;
  mask.grid.size = {14, 12, 10};
  mask.grid.spacing_mm = {1, 1.5, 2};
  mask.values.assign(mask.grid.voxels(), 0);
  return paint(std::move(mask), {{6, 8, 9}, 4});
}

// One of the edits, chosen and placed at random.
Mask random_edit(const Mask& mask) {
  const auto coordinate = [](int end) { return static_cast<double>(*rc::gen::inRange(-10, 10 * end)) / 10; };
  const Vector3d at_mm(coordinate(14), coordinate(18), coordinate(20));
  const double radius_mm = static_cast<double>(*rc::gen::inRange(1, 80)) / 10;
  switch (*rc::gen::inRange(0, 8)) {
    case 0: return paint(mask, {at_mm, radius_mm});
    case 1: return erase(mask, {at_mm, radius_mm});
    case 2: return cut(mask, Plane{at_mm, Vector3d(radius_mm, 1, -1)});
    case 3: return fill_holes(mask);
    case 4: return keep_largest(mask);
    case 5: return smooth(mask, radius_mm / 4);
    case 6: return with_margin(mask, radius_mm / 4);
    default: return with_margin(mask, -radius_mm / 4);
  }
}

// Not == within RC_ASSERT, which would print every voxel.
bool same(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) { return a == b; }

RC_GTEST_PROP(MaskDifference, LeadsThereAndBackAlsoThroughItsBytes, ()) {
  const Mask before = start_mask();
  const Mask after = random_edit(before);
  const MaskDifference found = difference(before, after);
  std::size_t turned = 0;
  for (std::size_t voxel = 0; voxel < before.values.size(); ++voxel) {
    turned += before.values[voxel] != after.values[voxel] ? 1U : 0U;
  }
  RC_ASSERT(found.turned_voxels() == turned);
  RC_ASSERT(found.empty() == (turned == 0));

  const auto read = difference_from_bytes(to_bytes(found), before.values.size());
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->kept_and_turned == found.kept_and_turned);
  Mask mask = before;
  turn(mask, *read);
  RC_ASSERT(same(mask.values, after.values));
  turn(mask, *read);
  RC_ASSERT(same(mask.values, before.values));
}

RC_GTEST_PROP(MaskDifference, AnyBytesAreReadOrRefused, (const std::string& bytes)) {
  Mask mask = start_mask();
  if (const auto read = difference_from_bytes(bytes, mask.values.size())) turn(mask, *read);  // asserts beyond the mask
}

TEST(MaskDifference, AStrokeOfTheBrushCostsAFewHundredBytes) {
  Mask before;
  before.grid.size = {256, 208, 70};
  before.grid.spacing_mm = {1.5, 1.5, 3};
  before.values.assign(before.grid.voxels(), 0);
  const Mask after = paint(before, {{190, 150, 100}, 10});
  const std::string bytes = to_bytes(difference(before, after));
  EXPECT_GT(bytes.size(), 50u);
  EXPECT_LT(bytes.size(), 600u);
}

}  // namespace
}  // namespace glisson::segmentation
