// What is masked on a real picture, and what is when a tool, smoke or a border is painted into it.

#include "vision/masks.h"

#include <gtest/gtest.h>
#include <cmath>

#include "support/data.h"

namespace glisson::vision {
namespace {

Frame heart() {
  return read_frame(glisson::test::shared_data() / "hamlyn_heart_stereo" / "f7_dynamic_deint_L_0100.png").value();
}

// A rectangle's pixels, each changed by `paint`.
template <typename Paint>
void paint(Frame& frame, int x0, int y0, int x1, int y1, const Paint& paint_pixel) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) paint_pixel(frame.at(x, y), x, y);
}

double masked_share(const Frame& frame, int x0, int y0, int x1, int y1) {
  const UsablePixels pixels = usable_pixels(frame);
  double masked = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      masked += pixels.usable[static_cast<std::size_t>(x) +
                              static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width)] == 0;
    }
  return masked / ((x1 - x0) * (y1 - y0));
}

TEST(Masks, KeepTheTissueOfARealPicture) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const UsablePixels pixels = usable_pixels(heart());
  EXPECT_LT(pixels.shares.tools, 0.03);  // a pale seam reaches the upper edge
  EXPECT_LT(pixels.shares.smoke, 0.01);
  EXPECT_GT(pixels.shares.highlights, 0.002);
  EXPECT_LT(pixels.shares.highlights, 0.08);
  EXPECT_LT(masked_share(heart(), 100, 100, 180, 220), 0.2);  // with its many highlights
}

TEST(Masks, TakeAGreyToolThatComesFromTheEdge) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  Frame frame = heart();
  const auto steel = [](std::uint8_t* pixel, int x, int) {
    const auto shade = static_cast<std::uint8_t>(120 + 60 * std::sin(0.3 * x));
    pixel[0] = pixel[1] = pixel[2] = shade;
  };
  paint(frame, 120, 150, 150, 288, steel);
  EXPECT_GT(masked_share(frame, 120, 150, 150, 288), 0.95);
  EXPECT_LT(masked_share(frame, 170, 120, 200, 180), masked_share(heart(), 170, 120, 200, 180) + 0.05);
  EXPECT_GT(usable_pixels(frame).shares.tools, 0.02);  // its stripes shine: some count as highlights
}

TEST(Masks, TakeThickSmoke) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  Frame frame = heart();
  const auto haze = [](std::uint8_t* pixel, int, int) {
    for (int channel = 0; channel < 3; ++channel) {
      pixel[channel] = static_cast<std::uint8_t>(0.15 * pixel[channel] + 0.85 * 200);
    }
  };
  paint(frame, 80, 60, 200, 160, haze);
  EXPECT_GT(masked_share(frame, 100, 80, 180, 140), 0.8);
  EXPECT_LT(masked_share(frame, 220, 120, 300, 200), 0.3);
}

TEST(Masks, FindNoToolsWhereNothingHasAColour) {
  Frame frame{80, 60, std::vector<std::uint8_t>(3 * 80 * 60)};
  paint(frame, 0, 0, 80, 60, [](std::uint8_t* pixel, int x, int y) {
    pixel[0] = pixel[1] = pixel[2] = static_cast<std::uint8_t>(60 + (37 * x + 91 * y) % 150);
  });
  EXPECT_EQ(usable_pixels(frame).shares.tools, 0);
}

}  // namespace
}  // namespace glisson::vision
