#include "scene/colour.h"

#include <gmock/gmock.h>

namespace glisson::scene {
namespace {

double lightness(const Colour& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

TEST(ColourMap, GetsLighterAllTheWaySoThatItReadsInGreyAndToAnyEye) {
  for (const auto map :
       {ColourMap::viridis, ColourMap::cividis, ColourMap::magma, ColourMap::plasma, ColourMap::grey}) {
    for (int k = 0; k < 100; ++k) {
      // The maps are even in CIE lightness; Rec. 709 luma, used here, may stand still for one step.
      EXPECT_GE(lightness(colour_at(map, (k + 1) / 100.0)), lightness(colour_at(map, k / 100.0)) - 5e-3) << k;
    }
  }
}

TEST(ColourMap, ClampsOutsideAndTakesNotANumberForItsLowEnd) {
  EXPECT_EQ(colour_at(ColourMap::viridis, -3).red, colour_at(ColourMap::viridis, 0).red);
  EXPECT_EQ(colour_at(ColourMap::viridis, 7).green, colour_at(ColourMap::viridis, 1).green);
  EXPECT_EQ(colour_at(ColourMap::viridis, std::nan("")).blue, colour_at(ColourMap::viridis, 0).blue);
}

TEST(RoundMarks, AreRoundAndInside) {
  EXPECT_THAT(round_marks(0, 30, 5), testing::ElementsAre(0, 5, 10, 15, 20, 25, 30));
  EXPECT_THAT(round_marks(0.05, 0.31, 3), testing::Pointwise(testing::DoubleNear(1e-12), {0.1, 0.2, 0.3}));
  EXPECT_THAT(round_marks(-1000, 1000, 4), testing::ElementsAre(-1000, -500, 0, 500, 1000));
  EXPECT_THAT(round_marks(2, 2, 4), testing::ElementsAre(2));
}

}  // namespace
}  // namespace glisson::scene
