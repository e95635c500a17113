// The scan as a backdrop: what is made of its values, and what stands in the picture, against tests/baselines.

#include "scene/backdrop.h"

#include <gtest/gtest.h>
#include <ctime>
#include <iostream>

#include "scene/anatomy.h"
#include "scene/bodies.h"
#include "scene/painter.h"
#include "scene/view.h"
#include "support/picture_check.h"

namespace glisson::scene {
namespace {

// Air, and a body of 40 HU with a spine of 500 HU behind (y to the back) and a breast bone of 500 HU before.
imaging::Volume torso() {
  imaging::Volume volume;
  volume.grid.size = {150, 110, 100};
  volume.grid.spacing_mm = {2, 2, 2};
  volume.grid.origin_mm = {-150, -110, -100};
  volume.values.resize(volume.grid.voxels());
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 110; ++j) {
      for (int i = 0; i < 150; ++i) {
        const Eigen::Vector3d at = volume.grid.position_mm(i, j, k);
        const bool body = std::hypot(at.x() / 140, at.y() / 100) < 1;
        const bool disc = std::fmod(at.z() + 100, 36) < 8;
        const bool spine = std::hypot(at.x(), at.y() - 75) < 18 && !disc;
        const bool breast_bone = std::hypot(at.x() - 60, at.y() + 60) < 12;
        volume.at(i, j, k) = spine || breast_bone ? 500.0F : body ? 40.0F : -1000.0F;
      }
    }
  }
  return volume;
}

Scene plain_organ() {
  const Appearance look = appearance_of("liver");
  Scene scene;
  scene.surfaces = {{"liver",
                     std::make_shared<geometry::Surface>(test::ellipsoid({-60, 0, 0}, {70, 50, 50})),
                     look.colour,
                     look.opacity,
                     look.finish,
                     {}}};
  scene.camera = look_from(PatientView::anterior, {{-150, -60, -100}, {150, 60, 100}}, 1.5);
  return scene;
}

Picture picture_of(const DrawnFrame& frame) {
  Picture picture{frame.width, frame.height, {}};
  for (std::size_t k = 0; k + 3 < frame.bgrx.size(); k += 4) {
    for (const std::size_t channel : {k + 2, k + 1, k}) picture.rgb.push_back(frame.bgrx[channel]);
  }
  return picture;
}

double brightness(const Picture& picture, int left, int top, int size) {
  double sum = 0;
  for (int y = top; y < top + size; ++y) {
    for (int x = left; x < left + size; ++x) sum += picture.at(x, y)[1];
  }
  return sum / (size * size);
}

TEST(Backdrop, MeansOverBlocksStandWhereTheirVoxelsDo) {
  auto volume = std::make_shared<imaging::Volume>(test::tilted_volume());
  const Backdrop backdrop{volume, 0, 255};
  const CoarseBackdrop coarse = coarsened(backdrop, 20);
  EXPECT_EQ(coarse.grid.size, (std::array<int, 3>{16, 18, 20}));  // blocks of 4 x 3 x 2
  double sum = 0;
  for (int k = 4; k < 6; ++k) {
    for (int j = 6; j < 9; ++j) {
      for (int i = 20; i < 24; ++i) sum += volume->at(i, j, k);
    }
  }
  EXPECT_EQ(coarse.values[5 + 16 * (2 + 18 * 2)], static_cast<int>(sum / 24));
  const Eigen::Vector3d middle = volume->grid.position_mm(Eigen::Vector3d(21.5, 7, 4.5));
  EXPECT_LT((coarse.grid.position_mm(5, 2, 2) - middle).norm(), 1e-9);
  EXPECT_EQ(coarsened(backdrop, 64).values.size(), volume->values.size());
}

TEST(Backdrop, SoftTissueIsClearAndAnImageWithoutAScaleShowsItsBrightest) {
  auto volume = std::make_shared<imaging::Volume>(torso());
  std::size_t clear = 0;
  for (const std::uint8_t value : coarsened(ct_backdrop(volume), 128).values) clear += value == 0 ? 1 : 0;
  EXPECT_GT(clear, 9 * volume->values.size() / 10 / 8);
  for (float& value : volume->values) value = value < -500 ? 0 : 3 * value;  // as an MR of it might be
  const Backdrop by_brightness = backdrop_by_brightness(volume);
  EXPECT_GE(by_brightness.low, 120);
  EXPECT_GT(by_brightness.high, by_brightness.low);
  std::fill(volume->values.begin(), volume->values.end(), 7.0F);
  EXPECT_GT(backdrop_by_brightness(volume).high, 7);  // nothing to see, and nothing divided by 0
}

TEST(Backdrop, ShowsWhatIsBehindTheOrganAndNothingBeforeIt) {
  View view;
  ASSERT_TRUE(view.show(plain_organ()));
  Painter painter;
  const auto draw = [&] {
    const auto frame = painter.paint(view.take_changes(480, 320));
    EXPECT_TRUE(frame) << frame.error().message();
    return picture_of(*frame);
  };
  const Picture without = draw();
  const auto volume = std::make_shared<imaging::Volume>(torso());
  view.set_backdrop(ct_backdrop(volume));
  const Picture with = draw();
  EXPECT_TRUE(test::looks_like_baseline(with, "backdrop"));
  // The spine stands in the middle, clear of the organ; the breast bone would stand to the right of it.
  const auto at = [&](const Eigen::Vector3d& place_mm) { return view.pixel_of(place_mm).cast<int>().eval(); };
  const Eigen::Vector2i spine = at({8, 75, 60}), bone = at({60, -60, 0});
  EXPECT_GT(brightness(with, spine.x() - 2, spine.y() - 2, 4),
            brightness(without, spine.x() - 2, spine.y() - 2, 4) + 25);
  EXPECT_NEAR(brightness(with, bone.x() - 3, bone.y() - 3, 6), brightness(without, bone.x() - 3, bone.y() - 3, 6), 2);
  // Where both are seen, the clear organ lies over the bone.
  const Eigen::Vector2i over = at({-14, 50, 0});
  EXPECT_LT(brightness(with, over.x() - 2, over.y() - 2, 4), brightness(with, spine.x() - 2, spine.y() - 2, 4) - 20);

  // In the processor's time, of all threads: what a hand that turns it waits for, on an idle machine or not.
  constexpr int frames = 10;
  const auto turn = [&] {
    const std::clock_t begin = std::clock();
    for (int k = 0; k < frames; ++k) {
      view.set_camera(turned(view.camera(), 3, 0));
      EXPECT_TRUE(painter.paint(view.take_changes(480, 320)));
    }
    return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / frames;
  };
  const double fine_ms = turn();
  view.set_detail(Detail::coarse);
  const double coarse_ms = turn();
  view.set_backdrop(std::nullopt);
  const double without_ms = turn();
  std::cout << "CPU time of a frame of 480 x 320 with the backdrop: " << fine_ms << " ms, coarse " << coarse_ms
            << " ms, without " << without_ms << " ms, by " << painter.drawn_by() << "\n";
  view.set_detail(Detail::full);
  view.set_camera(*plain_organ().camera);
  EXPECT_EQ(draw().rgb, without.rgb);
}

}  // namespace
}  // namespace glisson::scene
