// A lesion at the liver's edge becomes part of it; what is elsewhere does not.

#include "segmentation/lesions.h"

#include <gmock/gmock.h>

namespace glisson::segmentation {
namespace {

const imaging::Grid grid{{60, 40, 40}, {1, 1, 1}, {0, 0, 0}, Eigen::Matrix3d::Identity()};

imaging::Mask ball(const Eigen::Vector3d& center, double radius) {
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 60; ++i) {
        mask.at(i, j, k) = (grid.position_mm(i, j, k) - center).norm() <= radius ? 1 : 0;
      }
    }
  }
  return mask;
}

TEST(Lesions, AtTheEdgeJoinsWithTheCleftClosed) {
  // The growing stopped 2 mm before a tumour that bulges out of the organ.
  const imaging::Mask liver = ball({18, 20, 20}, 14);
  const Structure tumour = make_structure("tumour-1", ball({42, 20, 20}, 8));
  const WithLesions joined = with_lesions(liver, {tumour});
  EXPECT_THAT(joined.added, testing::ElementsAre("tumour-1"));
  EXPECT_TRUE(joined.liver.at(42, 20, 20));
  EXPECT_TRUE(joined.liver.at(33, 20, 20)) << "the cleft on the line between the centres";
  EXPECT_EQ(pieces(joined.liver).size(), 1u);
  // Far from the lesion nothing changed.
  for (int i = 0; i < 15; ++i) EXPECT_EQ(joined.liver.at(i, 20, 20), liver.at(i, 20, 20));
}

TEST(Lesions, InsideOrFarAwayOrNoLesionChangesNothing) {
  const imaging::Mask liver = ball({20, 20, 20}, 15);
  const WithLesions same = with_lesions(
      liver, {make_structure("tumour-1", ball({20, 20, 20}, 5)), make_structure("cyst", ball({52, 20, 20}, 4)),
              make_structure("portal-vein", ball({36, 20, 20}, 4))});
  EXPECT_THAT(same.added, testing::IsEmpty());
  EXPECT_EQ(same.liver.values, liver.values);
}

}  // namespace
}  // namespace glisson::segmentation
