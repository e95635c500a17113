// Where an outline lies on tissue that looks alike, whoever drew it.

#include "segmentation/unsure_border.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>
#include <random>

#include "deepest.h"
#include "imaging/read_series.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/grow.h"
#include "segmentation/structures.h"
#include "slanted_grid.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;

// A ball of 100 in 0, and a neighbour beyond 0.6 radii on its right.
imaging::Volume ball_with_a_neighbour(const Vector3d& middle_mm, double radius_mm, double neighbour) {
  imaging::Volume image{{}, "a.u."};
  image.grid.size = {60, 50, 40};
  image.grid.spacing_mm = {2, 2, 2.5};
  image.values.resize(image.grid.voxels());
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 5);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i) {
        const Vector3d at_mm = image.grid.position_mm(i, j, k);
        const bool inside = (at_mm - middle_mm).norm() < radius_mm;
        const bool beside = at_mm.x() > middle_mm.x() + 0.6 * radius_mm;
        image.values[image.grid.offset(i, j, k)] = (inside   ? 100.0F
                                                    : beside ? static_cast<float>(neighbour)
                                                             : 0.0F) +
                                                   noise(random);
      }
  return image;
}

imaging::Mask ball(const imaging::Grid& grid, const Vector3d& middle_mm, double radius_mm) {
  return paint(empty_mask(grid), {middle_mm, radius_mm});
}

TEST(UnsureBorder, IsWhereTheNeighbourLooksAlike) {
  const Vector3d middle_mm(50, 50, 50);
  const double radius_mm = 32;
  const auto alike = ball_with_a_neighbour(middle_mm, radius_mm, 96);
  const auto outline = ball(alike.grid, middle_mm, radius_mm);
  for (const UnsureBorder& unsure : {unsure_border(outline, alike), unsure_border(outline, alike, 100, 5)}) {
    // The cap beyond 0.6 radii is a fifth of a sphere's surface.
    EXPECT_NEAR(unsure.share, 0.2, 0.06);
    ASSERT_FALSE(unsure.places_mm.empty());
    for (const Vector3d& place_mm : unsure.places_mm) {
      EXPECT_GT(place_mm.x(), middle_mm.x() + 0.5 * radius_mm);
      EXPECT_NEAR((place_mm - middle_mm).norm(), radius_mm, 6);
    }
  }
  const auto told_apart = ball_with_a_neighbour(middle_mm, radius_mm, 40);
  EXPECT_LT(unsure_border(outline, told_apart).share, 0.02);
  EXPECT_TRUE(unsure_border(outline, told_apart).places_mm.empty());
}

TEST(UnsureBorder, OfNothingThereIsNone) {
  const auto image = ball_with_a_neighbour({50, 50, 50}, 20, 0);
  const imaging::Mask nothing = empty_mask(image.grid);
  EXPECT_EQ(unsure_border(nothing, image).share, 0);
  auto unseen = image;
  std::fill(unseen.values.begin(), unseen.values.end(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(unsure_border(ball(image.grid, {50, 50, 50}, 20), unseen).share, 0);
}

// What a growth says of its own outline is said of the same outline from elsewhere.
TEST(UnsureBorderReal, IsSaidAlikeOfAnOutlineFromElsewhere) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  const auto study = imaging::scan(folder / "example_ct_dicom");
  const auto labels = imaging::read_labels_file(folder / "example_seg_dicom.nii.gz");
  ASSERT_TRUE(study && labels);
  const auto image = imaging::read_series(study->series.front());
  ASSERT_TRUE(image);
  const auto grown = grow_from_seeds(*image, {deepest_mm(mask_of_label(*labels, 5))});
  ASSERT_TRUE(grown);
  const UnsureBorder elsewhere = unsure_border(grown->mask, *image);
  EXPECT_NEAR(elsewhere.share, grown->unsure_border, 0.05);
  ASSERT_FALSE(elsewhere.places_mm.empty());
  EXPECT_LT((elsewhere.places_mm.front() - grown->unsure_places_mm.front()).norm(), 20);
}

}  // namespace
}  // namespace glisson::segmentation
