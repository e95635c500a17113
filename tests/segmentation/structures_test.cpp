#include "segmentation/structures.h"

#include <gtest/gtest.h>

#include "segmentation/edit.h"

namespace glisson::segmentation {
namespace {

using imaging::Mask;

Mask empty_small_mask() {
  Mask mask;
  mask.grid.size = {30, 30, 30};
  mask.grid.spacing_mm = {1, 1, 2};
  mask.values.assign(mask.grid.voxels(), 0);
  return mask;
}

Mask ball(double x, double y, double z, double radius_mm) { return paint(empty_small_mask(), {{x, y, z}, radius_mm}); }

TEST(Structures, AreKnownByNameWithOrWithoutNumber) {
  EXPECT_EQ(known_structure("liver").place, Place::liver);
  EXPECT_EQ(known_structure("tumour-12").place, Place::inside);
  EXPECT_EQ(known_structure("tumour-12").color_rgb, known_structure("tumour").color_rgb);
  EXPECT_EQ(known_structure("portal-vein").place, Place::inside);
  EXPECT_EQ(known_structure("gallbladder").place, Place::beside);
  for (const char* name : {"", "-", "-3", "tumour-", "tumour-x", "whatever"}) {
    EXPECT_EQ(known_structure(name).place, Place::unknown) << name;
  }
  EXPECT_DOUBLE_EQ(make_structure("liver", empty_small_mask()).color_rgb[0], 221 / 255.0);
}

TEST(Structures, InsideWinsOverTheLiverAndSmallOverLarge) {
  const std::vector<Structure> structures{
      make_structure("portal-vein", ball(14, 14, 30, 6)), make_structure("liver", ball(14, 14, 30, 12)),
      make_structure("tumour-1", ball(16, 14, 30, 3)), make_structure("gallbladder", ball(14, 14, 44, 4))};
  const auto composed = compose_labels(structures, Extent::liver);
  ASSERT_TRUE(composed) << composed.error().message();
  EXPECT_EQ(composed->names, (std::vector<std::string>{"liver", "portal-vein", "tumour-1"}));
  for (std::size_t voxel = 0; voxel < composed->labels.values.size(); ++voxel) {
    const int expected = structures[1].mask.values[voxel] == 0   ? 0
                         : structures[2].mask.values[voxel] != 0 ? 3
                         : structures[0].mask.values[voxel] != 0 ? 2
                                                                 : 1;
    ASSERT_EQ(composed->labels.values[voxel], expected);
  }
  EXPECT_EQ(mask_of_label(composed->labels, 3).values, structures[2].mask.values);

  const auto all = compose_labels(structures, Extent::all);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->names.back(), "gallbladder");
  EXPECT_EQ(voxel_count(mask_of_label(all->labels, 4)), voxel_count(structures[3].mask));
}

TEST(Structures, RefusesWhatCannotBeComposed) {
  EXPECT_EQ(compose_labels({}, Extent::all).error().code, "labels-no-structures");
  EXPECT_EQ(compose_labels({make_structure("tumour", ball(5, 5, 5, 3))}, Extent::liver).error().code,
            "labels-no-liver");
  EXPECT_EQ(compose_labels({make_structure("liver", empty_small_mask())}, Extent::liver).error().code,
            "labels-liver-empty");
  Mask elsewhere = empty_small_mask();
  elsewhere.grid.origin_mm.x() = 1;
  EXPECT_EQ(
      compose_labels({make_structure("liver", empty_small_mask()), make_structure("tumour", elsewhere)}, Extent::all)
          .error()
          .code,
      "labels-grids-differ");
}

TEST(Structures, OverlapOfMasks) {
  const Mask a = ball(10, 10, 20, 5), b = ball(20, 20, 40, 5);
  EXPECT_EQ(dice(a, a).value(), 1.0);
  EXPECT_EQ(dice(a, b).value(), 0.0);
  EXPECT_EQ(dice(empty_small_mask(), empty_small_mask()).value(), 1.0);
  EXPECT_EQ(dice(a, united(a, b)).value(), 2.0 / 3.0);  // b is as large as a
}

TEST(Structures, PiecesAreToldTheLargestFirst) {
  const Mask mask = united(ball(8, 8, 20, 3), ball(20, 20, 58, 6));
  const std::vector<Piece> found = pieces(mask);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GT(found[0].voxels, found[1].voxels);
  EXPECT_TRUE(found[0].touches_border);  // the last slice is at 58 mm
  EXPECT_FALSE(found[1].touches_border);
  EXPECT_NEAR((found[1].centroid_mm - Eigen::Vector3d(8, 8, 20)).norm(), 0, 1e-9);
  EXPECT_DOUBLE_EQ(found[1].volume_ml, static_cast<double>(found[1].voxels) * 0.002);
  EXPECT_DOUBLE_EQ(found[0].volume_ml + found[1].volume_ml, volume_ml(mask));
  EXPECT_TRUE(pieces(empty_small_mask()).empty());
}

}  // namespace
}  // namespace glisson::segmentation
