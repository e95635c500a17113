// A liver is doubted where it cannot be a person's, and not where it is one.

#include "segmentation/plausibility.h"

#include <gtest/gtest.h>

#include "imaging/read_series.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "segmentation/grow.h"
#include "segmentation/resample.h"
#include "segmentation/structures.h"
#include "support/data.h"

namespace glisson::segmentation {
namespace {

using imaging::Mask;
using imaging::Volume;

Mask totalsegmentators_liver(const char* labels) {
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  return mask_of_label(imaging::read_labels_file(folder / labels).value(), 5);
}

Volume image_of(const char* file) {
  return imaging::read_volume_file(test::shared_data() / "totalseg_abdomen_mr_ct" / file).value();
}

TEST(Plausibility, APersonsLiverRaisesNoDoubt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  for (const auto& [image, labels] :
       {std::pair("example_mr_sm.nii.gz", "example_seg_mr.nii.gz"), {"example_ct_sm.nii.gz", "example_seg.nii.gz"}}) {
    const Volume read = image_of(image);
    const auto doubt = doubt_of_liver(resample(totalsegmentators_liver(labels), read.grid), read);
    EXPECT_FALSE(doubt) << image << ": " << doubt->message();
  }
}

// Twenty slices of a CT, and three of another: the cut says nothing of who it is.
TEST(Plausibility, APartOfAPersonsLiverRaisesNoDoubt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto folder = test::shared_data() / "totalseg_abdomen_mr_ct";
  const Volume image = imaging::read_series(imaging::scan(folder / "example_ct_dicom").value().series.front()).value();
  const auto doubt = doubt_of_liver(resample(totalsegmentators_liver("example_seg_dicom.nii.gz"), image.grid), image);
  EXPECT_FALSE(doubt) << doubt->message();
}

TEST(Plausibility, AMousesAbdomenIsNoPersonsLiver) {
  GLISSON_NEEDS_DATA("mouse_abdomen_mr_dicom");
  const auto study = imaging::scan(test::shared_data() / "mouse_abdomen_mr_dicom").value();
  const Volume image = imaging::read_series(study.series.front()).value();
  const auto grown = grow_from_seeds(image, {{-32, 7.4, -0.9}});
  ASSERT_TRUE(grown) << grown.error().message();
  const auto doubt = doubt_of_liver(grown->mask, image);
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->message().find("animal"), std::string::npos) << doubt->message();
}

TEST(Plausibility, AllOfTheBodyIsNoLiver) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const Volume image = image_of("example_mr_sm.nii.gz");
  Mask all{image.grid, std::vector<std::uint8_t>(image.grid.voxels(), 0)};
  for (std::size_t v = 0; v < all.values.size(); ++v) all.values[v] = image.values[v] > 20 ? 1 : 0;
  const auto doubt = doubt_of_liver(all, image);
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->message().find("of the body"), std::string::npos) << doubt->message();
}

TEST(Plausibility, SaysThatASmallOutlineIsSmall) {
  Volume image;
  image.grid.size = {100, 100, 20};
  image.grid.spacing_mm = {3, 3, 5};
  image.values.assign(image.grid.voxels(), 100.0F);
  Mask ball{image.grid, std::vector<std::uint8_t>(image.grid.voxels(), 0)};
  for (int k = 8; k < 12; ++k) {
    for (int j = 40; j < 50; ++j) {
      for (int i = 40; i < 50; ++i) ball.at(i, j, k) = 1;
    }
  }
  const auto doubt = doubt_of_liver(ball, image);  // 400 voxels of 45 mm3
  ASSERT_TRUE(doubt);
  EXPECT_EQ(doubt->arguments.front(), "18");
  for (int j = 40; j < 50; ++j) ball.at(40, j, 19) = 1;  // the image cuts it off: nobody knows how large it is
  EXPECT_FALSE(doubt_of_liver(ball, image));
}

TEST(Plausibility, NothingIsSaidOfNothing) {
  Volume image;
  image.grid.size = {4, 4, 4};
  image.values.assign(64, 1.0F);
  EXPECT_FALSE(doubt_of_liver({image.grid, std::vector<std::uint8_t>(64, 0)}, image));
}

}  // namespace
}  // namespace glisson::segmentation
