#include "scene/picture.h"

#include <gtest/gtest.h>
#include <fstream>

#include "base/files.h"
#include "scene/composite.h"

namespace glisson::scene {
namespace {

Picture gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int k = 0; k < 3 * width * height; ++k) picture.rgb.push_back(static_cast<std::uint8_t>(k * 7));
  return picture;
}

TEST(Picture, ComesBackFromPngAsItWas) {
  const TemporaryFolder folder;
  const Picture picture = gradient(37, 23);
  ASSERT_TRUE(write_png(picture, folder.path() / "p.png"));
  const auto back = read_png(folder.path() / "p.png");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->width, 37);
  EXPECT_EQ(back->rgb, picture.rgb);
}

TEST(Picture, RefusesWhatIsNoWholePngWithOneSentence) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "p.png";
  EXPECT_EQ(read_png(file).error().code, "picture-unreadable");  // not there
  std::ofstream(file) << "this is text";
  EXPECT_EQ(read_png(file).error().code, "picture-unreadable");
  ASSERT_TRUE(write_png(gradient(64, 64), file));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_EQ(read_png(file).error().code, "picture-unreadable");
}

TEST(RedBlue, IsPurpleWhereBothAgreeAndPureWhereOnlyOneIs) {
  const Picture in_red{3, 1, {255, 255, 255, 255, 255, 255, 0, 0, 0}};
  const Picture in_blue{3, 1, {255, 255, 255, 0, 0, 0, 255, 255, 255}};
  const Picture joined = red_blue(in_red, in_blue);
  EXPECT_EQ(joined.rgb, (std::vector<std::uint8_t>{255, 0, 255, 255, 0, 0, 0, 0, 255}));
}

}  // namespace
}  // namespace glisson::scene
