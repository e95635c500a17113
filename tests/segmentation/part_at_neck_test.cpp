// What hangs on a structure by a neck goes with one click, and nothing else does.

#include "segmentation/part_at_neck.h"

#include <gtest/gtest.h>
#include <algorithm>

#include "deepest.h"
#include "imaging/volume_file.h"
#include "segmentation/brush.h"
#include "segmentation/edit.h"
#include "segmentation/structures.h"
#include "slanted_grid.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

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
  made.large = empty_mask();
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
    EXPECT_EQ(voxel_count(intersected(*left, one.large)), voxel_count(one.large));
    EXPECT_LT(voxel_count(*left), voxel_count(one.large) + (voxel_count(one.whole) - voxel_count(one.large)) / 4);
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
  Mask full = empty_mask();
  std::fill(full.values.begin(), full.values.end(), std::uint8_t{1});
  EXPECT_EQ(refusal(without_part_at(full, one.large_mm)), "edit-no-neck");
}

// A leak as it happens: the liver of a patient with a neighbour that touches it. One click into the neighbour.
TEST(PartAtNeckReal, ANeighbourOfARealLiverGoesWithOneClick) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto labels = imaging::read_labels_file(test::shared_data() / "totalseg_abdomen_mr_ct" / "example_seg.nii.gz");
  ASSERT_TRUE(labels);
  const Mask liver = mask_of_label(*labels, 5);
  int touching = 0, taken_off = 0;
  for (int label = 1; label < 120; ++label) {
    const Mask neighbour = mask_of_label(*labels, label);
    if (label == 5 || volume_ml(neighbour) < 15) continue;
    if (voxel_count(intersected(with_margin(neighbour, 3.5), liver)) < 20) continue;
    const Mask leaked = united(liver, neighbour);
    // The middle of the neighbour is where one sees that it is not the liver.
    const auto left = without_part_at(leaked, deepest_mm(neighbour));
    ++touching;
    if (!left) {
      EXPECT_EQ(left.error().code, "edit-no-neck") << "label " << label;
      continue;
    }
    ++taken_off;
    EXPECT_GT(dice(*left, liver).value(), 0.97) << "label " << label;
    EXPECT_GT(dice(*left, liver).value(), dice(leaked, liver).value()) << "label " << label;
  }
  // Gall bladder and vena cava lie in the liver's own hollows, and are no part that hangs on it.
  EXPECT_EQ(touching, 7);
  EXPECT_EQ(taken_off, 5);
}

}  // namespace
}  // namespace glisson::segmentation
