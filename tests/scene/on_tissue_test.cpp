// The colours of Register's heat mesh stand out on what a laparoscope sees, in order, and to any eye.

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "colour_difference.h"
#include "scene/heat_overlay.h"
#include "scene/internal/on_tissue.h"
#include "support/data.h"
#include "vision/frame.h"

namespace glisson::scene {
namespace {

using test::ciede2000;
using test::cielab;

constexpr int colours = 17;
using Palette = std::array<Colour, colours>;

template <typename Colouring>
Palette palette_of(const Colouring& colouring) {
  Palette palette;
  for (int k = 0; k < colours; ++k) palette[static_cast<std::size_t>(k)] = colouring(k / (colours - 1.0));
  return palette;
}
const Palette on_tissue = palette_of([](double fraction) { return colour_on_tissue(fraction); });
const Palette viridis = palette_of([](double fraction) { return colour_at(ColourMap::viridis, fraction); });

// What of a picture is tissue: all but the dark border. Every so many pixels.
std::vector<Colour> tissue_of(const vision::Frame& frame, int step) {
  std::vector<Colour> found;
  for (int y = step / 2; y < frame.height; y += step) {
    for (int x = step / 2; x < frame.width; x += step) {
      const std::uint8_t* rgb = frame.at(x, y);
      const Colour colour{rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
      if (cielab(colour).x() > 15) found.push_back(colour);
    }
  }
  return found;
}

Colour over(const Colour& top, const Colour& under, double opacity) {
  const auto mixed = [&](double a, double b) { return opacity * a + (1 - opacity) * b; };
  return {mixed(top.red, under.red), mixed(top.green, under.green), mixed(top.blue, under.blue)};
}

// Of the colour that stands out least: how much nineteen twentieths of the tissue differ, at least, from the same with
// the mesh over it.
double minimum_difference(const Palette& palette, const std::vector<Colour>& tissue) {
  double minimum = 1000;
  for (const Colour& colour : palette) {
    std::vector<double> differences;
    for (const Colour& under : tissue) {
      differences.push_back(ciede2000(cielab(over(colour, under, HeatScale().opacity)), cielab(under)));
    }
    std::sort(differences.begin(), differences.end());
    minimum = std::min(minimum, differences[differences.size() / 20]);
  }
  return minimum;
}

TEST(ColourDifference, IsThatOfThePublishedPairs) {
  // From table 1 of Sharma, Wu, Dalal 2005: blue, grey, opposite hues, near each other.
  EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(ciede2000({50, 0, 0}, {50, -1, 2}), 2.3669, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {58, 24, 15}), 19.4535, 1e-4);
  EXPECT_NEAR(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
}

TEST(OnTissue, StandsOutInALaparoscopesPicture) {
  GLISSON_NEEDS_DATA("p2ilf_frame");
  const auto frame = vision::read_frame(test::shared_data() / "p2ilf_frame" / "patient1_12" / "frame.jpg");
  ASSERT_TRUE(frame);
  const std::vector<Colour> tissue = tissue_of(*frame, 40);
  ASSERT_GT(tissue.size(), 1000U);
  const double found = minimum_difference(on_tissue, tissue);
  RecordProperty("ciede2000", std::to_string(found));
  EXPECT_GT(found, 24);
  EXPECT_LT(minimum_difference(viridis, tissue), 20);
}

TEST(OnTissue, StandsOutOnASiliconeHeartToo) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const auto frame = vision::read_frame(test::shared_data() / "hamlyn_heart_stereo" / "f7_dynamic_deint_L_0100.png");
  ASSERT_TRUE(frame);
  const std::vector<Colour> tissue = tissue_of(*frame, 8);
  const double found = minimum_difference(on_tissue, tissue);
  RecordProperty("ciede2000", std::to_string(found));
  EXPECT_GT(found, 18);
  EXPECT_GT(found, minimum_difference(viridis, tissue) + 2);
}

TEST(OnTissue, GetsLighterInEvenStepsThatAnyEyeSees) {
  for (std::size_t k = 0; k + 1 < on_tissue.size(); ++k) {
    const Colour &low = on_tissue[k], &high = on_tissue[k + 1];
    EXPECT_GT(cielab(high).x(), cielab(low).x() + 1.5) << k;
    const double step = ciede2000(cielab(low), cielab(high));
    EXPECT_GT(step, 4) << k;
    EXPECT_LT(step, 8) << k;
    using test::Lacks;
    for (const Lacks cones : {Lacks::long_waves, Lacks::middle_waves, Lacks::short_waves}) {
      const Eigen::Vector3d a = cielab(test::seen_without(low, cones)), b = cielab(test::seen_without(high, cones));
      EXPECT_GT(b.x(), a.x() + 0.5) << k;  // in the same order
      EXPECT_GT(ciede2000(a, b), 1) << k;  // and seen apart
    }
  }
}

// Rejected triangles are grey: none of the colours is.
TEST(OnTissue, IsNowhereNearGrey) {
  for (const Colour& colour : on_tissue) {
    const Eigen::Vector3d lab = cielab(colour);
    EXPECT_GT(std::hypot(lab.y(), lab.z()), 25);
  }
}

}  // namespace
}  // namespace glisson::scene
