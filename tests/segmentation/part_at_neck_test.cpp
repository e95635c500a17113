// What hangs on a structure by a neck goes with one click, and nothing else does.

#include "segmentation/part_at_neck.h"

#include <gtest/gtest.h>
#include <algorithm>

#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "segmentation/brush.h"
#include "segmentation/edit.h"
#include "slanted_grid.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

std::size_t voxels_of(const Mask& mask) {
  return mask.values.size() - std::count(mask.values.begin(), mask.values.end(), 0);
}

Mask nothing_drawn() {
  const imaging::Grid grid = slanted_grid();
  return {grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
}

double overlap_of(const Mask& a, const Mask& b) {
  return 2.0 * static_cast<double>(voxels_of(intersected(a, b))) / static_cast<double>(voxels_of(a) + voxels_of(b));
}

std::string refusal(const Result<Mask>& answer) { return answer ? "" : answer.error().code; }

struct Dumbbell {
  Vector3d large_mm, small_mm;
  Mask large, whole;
};

// Two balls in the patient's space, joined by a bar of that radius.
Dumbbell dumbbell(double bar_mm) {
  Dumbbell made;
  const imaging::Grid grid = slanted_grid();
  made.large_mm = grid.position_mm(Vector3d(9, 9, 8));
  made.small_mm = grid.position_mm(Vector3d(25, 16, 8));
  made.large = nothing_drawn();
  draw(made.large, {made.large_mm, made.large_mm, 9, {}, {}}, Paint::add);
  made.whole = made.large;
  draw(made.whole, {made.small_mm, made.small_mm, 5, {}, {}}, Paint::add);
  if (bar_mm > 0) draw(made.whole, {made.large_mm, made.small_mm, bar_mm, {}, {}}, Paint::add);
  return made;
}

TEST(PartAtNeck, TheSmallBallGoesAndTheLargeOneStays) {
  const Dumbbell one = dumbbell(2);
  for (const Vector3d& off : {Vector3d(0, 0, 0), Vector3d(2.5, 0, 0), Vector3d(0, -2, 1)}) {
    const auto left = without_part_at(one.whole, one.small_mm + off);
    ASSERT_TRUE(left);
    // The large ball whole, and no more than a stump of the bar.
    EXPECT_EQ(voxels_of(intersected(*left, one.large)), voxels_of(one.large));
    EXPECT_LT(voxels_of(*left), voxels_of(one.large) + (voxels_of(one.whole) - voxels_of(one.large)) / 4);
  }
}

TEST(PartAtNeck, ASeparatePieceGoesWhole) {
  const Dumbbell one = dumbbell(0);
  EXPECT_EQ(without_part_at(one.whole, one.small_mm).value().values, one.large.values);
}

TEST(PartAtNeck, WithoutANeckNothingIsTaken) {
  const Dumbbell one = dumbbell(2);
  EXPECT_EQ(refusal(without_part_at(one.whole, one.large_mm)), "edit-no-neck");
  // A bar thicker than the ball.
  const Dumbbell thick = dumbbell(6);
  EXPECT_EQ(refusal(without_part_at(thick.whole, thick.small_mm)), "edit-no-neck");
  EXPECT_EQ(refusal(without_part_at(one.whole, slanted_grid().position_mm(Vector3d(0, 25, 0)))), "edit-no-piece-there");
  EXPECT_EQ(refusal(without_part_at(one.whole, {1e300, 0, 0})), "edit-no-piece-there");
  Mask full = nothing_drawn();
  std::fill(full.values.begin(), full.values.end(), std::uint8_t{1});
  EXPECT_EQ(refusal(without_part_at(full, one.large_mm)), "edit-no-neck");
}

// A leak as it happens: the liver of a patient with a neighbour that touches it. One click into the neighbour.
TEST(PartAtNeckReal, ANeighbourOfARealLiverGoesWithOneClick) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto labels = imaging::read_labels_file(test::shared_data() / "totalseg_abdomen_mr_ct" / "example_seg.nii.gz");
  ASSERT_TRUE(labels);
  const auto organ = [&](int label) {
    Mask mask{labels->grid, std::vector<std::uint8_t>(labels->values.size())};
    for (std::size_t v = 0; v < mask.values.size(); ++v) mask.values[v] = static_cast<int>(labels->values[v]) == label;
    return mask;
  };
  const Mask liver = organ(5);
  int touching = 0, taken_off = 0;
  for (int label = 1; label < 120; ++label) {
    const Mask neighbour = organ(label);
    if (label == 5 || volume_ml(neighbour) < 15) continue;
    if (voxels_of(intersected(with_margin(neighbour, 3.5), liver)) < 20) continue;
    const Mask leaked = united(liver, neighbour);
    // The middle of the neighbour is where one sees that it is not the liver.
    const auto deep = imaging::squared_depths_mm2(neighbour);
    const auto deepest = static_cast<std::size_t>(std::max_element(deep.begin(), deep.end()) - deep.begin());
    const auto& size = labels->grid.size;
    const Vector3d click = labels->grid.position_mm(Vector3d(static_cast<double>(deepest % size[0]),
                                                             static_cast<double>(deepest / size[0] % size[1]),
                                                             static_cast<double>(deepest / size[0] / size[1])));
    const auto left = without_part_at(leaked, click);
    ++touching;
    if (!left) {
      EXPECT_EQ(left.error().code, "edit-no-neck") << "label " << label;
      continue;
    }
    ++taken_off;
    EXPECT_GT(overlap_of(*left, liver), 0.97) << "label " << label;
    EXPECT_GT(overlap_of(*left, liver), overlap_of(leaked, liver)) << "label " << label;
  }
  // Gall bladder and vena cava lie in the liver's own hollows, and are no part that hangs on it.
  EXPECT_EQ(touching, 7);
  EXPECT_EQ(taken_off, 5);
}

}  // namespace
}  // namespace glisson::segmentation
