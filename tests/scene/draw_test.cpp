// Pictures, drawn off screen and held against tests/baselines.

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>

#include "anatomy/patient.h"
#include "scene/anatomy.h"
#include "scene/bodies.h"
#include "scene/composite.h"
#include "scene/scene.h"
#include "support/picture_check.h"

namespace glisson::scene {
namespace {

using test::ellipsoid;
using test::looks_like_baseline;

SurfaceItem structure(const std::string& name, geometry::Surface surface) {
  const Appearance look = appearance_of(name);
  return {name, std::make_shared<geometry::Surface>(std::move(surface)), look.colour, look.opacity, look.finish, {}};
}

// A clear organ with a tumour and a vein in it, a tool that pushes at it, and all that stands in the corners.
Scene organ() {
  Scene scene;
  scene.surfaces = {structure("liver", ellipsoid({0, 0, 0}, {100, 60, 70})),
                    structure("tumour-1", ellipsoid({-30, -10, 10}, {18, 18, 18})),
                    structure("hepatic-veins", ellipsoid({30, 0, -5}, {40, 8, 8}))};
  scene.landmarks = {{"Tumour 1", {-30, -10, 10}, 3, {1, 1, 1}}};
  scene.arrows = {{{-80, -60, -100}, {-50, -20, -58}, 4, {0.2, 0.85, 0.85}, "5.0 N"}};
  scene.annotations.title = "Retraction";
  scene.annotations.subtitle = "A made-up organ";
  scene.annotations.warning = "SIMULATED. Not a medical device.";
  scene.annotations.text_scale = 0.7;  // the pictures are small
  return scene;
}

// The same with a bulge of up to 20 mm towards the front, shown by colour.
Scene displaced_organ() {
  Scene scene = organ();
  geometry::Surface bulged = *scene.surfaces[0].surface;
  geometry::Field displacement{"displacement_mm", 3, {}};
  for (Eigen::Vector3d& point : bulged.points_mm) {
    const Eigen::Vector3d d(0, -20 * std::exp(-(point - Eigen::Vector3d(-60, -30, -30)).squaredNorm() / 3200), 0);
    point += d;
    displacement.values.insert(displacement.values.end(), d.data(), d.data() + 3);
  }
  bulged.point_fields.push_back(displacement);
  scene.surfaces[0].surface = std::make_shared<geometry::Surface>(bulged);
  scene.surfaces[0].colouring = Colouring{"displacement_mm", ColourMap::viridis, {0, 20}, "Displacement (mm)"};
  return scene;
}

Scene slice() {
  const auto volume = std::make_shared<imaging::Volume>(test::tilted_volume());
  const auto ball = std::make_shared<imaging::Mask>();
  ball->grid = volume->grid;
  for (const float value : volume->values) ball->values.push_back(value > 190 ? 1 : 0);
  SliceItem item;
  item.volume = volume;
  item.window_center = 150;
  item.window_width = 300;
  item.masks = {{ball, {0.3, 0.9, 0.4}, 1.8}};
  item.cuts = {{std::make_shared<geometry::Surface>(ellipsoid({0, 0, 0}, {60, 45, 40})), {0.95, 0.6, 0.5}, 1.8}};
  Scene scene;
  scene.slices = {item};
  scene.camera = look_at_slice({0, 0, 0}, {0, 0, 1}, 170);
  scene.crosshair = CrosshairItem{{20, -10, 0}, {Colour{0.9, 0.5, 0.5}, Colour{0.5, 0.9, 0.5}, Colour{0.5, 0.6, 1}}};
  scene.annotations.orientation = Annotations::Orientation::letters;
  return scene;
}

Picture drawn(const Scene& scene, int width = 480, int height = 320) {
  auto picture = draw(scene, width, height);
  EXPECT_TRUE(picture) << picture.error().message();
  return picture ? *std::move(picture) : Picture{16, 16, std::vector<std::uint8_t>(3 * 16 * 16)};
}

TEST(Draw, ShowsAClearOrganWithItsTumourAndVein) { EXPECT_TRUE(looks_like_baseline(drawn(organ()), "organ")); }

TEST(Draw, SuitsPaperOnALightBackground) {
  Scene scene = displaced_organ();
  scene.background = Background::light;
  EXPECT_TRUE(looks_like_baseline(drawn(scene), "organ-displaced-light"));
}

TEST(Draw, PlacesATiltedVolumeItsMaskAndASurfaceInTheSamePatient) {
  EXPECT_TRUE(looks_like_baseline(drawn(slice(), 360, 300), "slice-tilted"));
}

TEST(Draw, PutsThePatientsRightOnThePicturesLeft) {
  // One white ball 60 mm to the patient's right, seen from the front: all light is in the picture's left half.
  Scene scene;
  scene.surfaces = {
      {"ball", std::make_shared<geometry::Surface>(ellipsoid({-60, 0, 0}, {15, 15, 15})), {}, 1, Finish::solid, {}}};
  scene.background = Background::black;
  scene.annotations.orientation = Annotations::Orientation::hidden;
  scene.annotations.scale_bar = Annotations::ScaleBar::hidden;
  scene.camera = look_from(PatientView::anterior, {{-100, -50, -50}, {100, 50, 50}}, 1);
  const Picture picture = drawn(scene, 200, 200);
  long left = 0;
  long right = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) (x < 100 ? left : right) += picture.at(x, y)[1];
  }
  EXPECT_GT(left, 10000);
  EXPECT_EQ(right, 0);
}

TEST(Draw, AddsLightWhateverTheOrderSoThatRedAndBlueMakePurple) {
  // Two balls side by side that overlap in the middle, seen from the front.
  const auto ball = [](double x_mm, const Colour& colour) {
    return SurfaceItem{"ball",        std::make_shared<geometry::Surface>(ellipsoid({x_mm, 0, 0}, {40, 40, 40})),
                       colour,        0.6,
                       Finish::light, {}};
  };
  Scene scene;
  scene.background = Background::black;
  scene.annotations.orientation = Annotations::Orientation::hidden;
  scene.annotations.scale_bar = Annotations::ScaleBar::hidden;
  scene.camera = look_from(PatientView::anterior, {{-80, -50, -50}, {80, 50, 50}}, 1);
  scene.camera->projection = Projection::parallel;
  scene.surfaces = {ball(-25, {1, 0, 0}), ball(25, {0, 0, 1})};
  const Picture one = drawn(scene, 200, 200);
  std::swap(scene.surfaces[0], scene.surfaces[1]);
  EXPECT_EQ(one.rgb, drawn(scene, 200, 200).rgb);
  const auto* middle = one.at(100, 100);
  EXPECT_GT(middle[0], 30);
  EXPECT_GT(middle[2], 30);
  EXPECT_LT(middle[1], 10);
  EXPECT_LT(one.at(60, 100)[2], 10);   // red alone
  EXPECT_LT(one.at(140, 100)[0], 10);  // blue alone
}

TEST(Draw, GivesTheSameBitsEveryTime) { EXPECT_EQ(drawn(organ(), 240, 160).rgb, drawn(organ(), 240, 160).rgb); }

TEST(Draw, NeedsNoDisplay) {
  unsetenv("DISPLAY");
  EXPECT_GT(drawn(organ(), 64, 48).rgb.size(), 0U);
}

TEST(DrawDeathTest, SaysWhatIsMissingWhereThereIsNothingToDrawWith) {
  // In a process of its own: which EGL there is gets decided once a program.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto exit_code_without_egl = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
    unsetenv("DISPLAY");
    const auto picture = draw(organ(), 64, 48);
    return !picture && picture.error().code == "drawing-unavailable" ? 7 : 8;
  };
  EXPECT_EXIT(std::exit(exit_code_without_egl()), testing::ExitedWithCode(7), "");
}

TEST(DrawRedBlue, IsPurpleWhereTheResultsAgreeAndRedOrBlueWhereTheyDoNot) {
  const Comparison comparison{organ(), displaced_organ(), "Red: atlas stiffness", "Blue: MR elastography",
                              "Purple: both agree"};
  const auto picture = draw_red_blue(comparison, 480, 320);
  ASSERT_TRUE(picture) << picture.error().message();
  EXPECT_TRUE(looks_like_baseline(*picture, "organ-red-blue"));
}

TEST(Draw, ShowsAGeneratedPatientsLiver) {
  anatomy::PatientOptions options;
  options.lesions = {{anatomy::LesionKind::tumour, 30, 6, {}}};
  const auto patient = anatomy::make_patient(options);
  ASSERT_TRUE(patient) << patient.error().message();
  Scene scene;
  for (anatomy::NamedSurface& named : anatomy::surfaces_of(*patient)) {
    if (named.name == "liver" || named.name.ends_with("vein") || named.name.starts_with("tumour")) {
      scene.surfaces.push_back(structure(named.name, std::move(named.surface)));
    }
  }
  std::reverse(scene.surfaces.begin(), scene.surfaces.end());  // what is seen through comes last
  EXPECT_TRUE(looks_like_baseline(drawn(scene), "patient-liver"));
}

}  // namespace
}  // namespace glisson::scene
