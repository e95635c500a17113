#include "scene/scene.h"

#include <gmock/gmock.h>
#include <limits>

#include "scene/anatomy.h"
#include "scene/bodies.h"

namespace glisson::scene {
namespace {

using test::ellipsoid;

Scene scene_of(geometry::Surface surface) {
  Scene scene;
  scene.surfaces.push_back(
      {"liver", std::make_shared<geometry::Surface>(std::move(surface)), {}, 1, Finish::solid, {}});
  return scene;
}

std::string complaint(const Scene& scene) {
  const auto fine = check_scene(scene);
  return fine ? "" : fine.error().message();
}

TEST(CheckScene, NamesTheItemThatCannotBeDrawn) {
  Scene missing = scene_of(ellipsoid({0, 0, 0}, {10, 10, 10}));
  missing.surfaces[0].surface = nullptr;
  EXPECT_THAT(complaint(missing), testing::HasSubstr("\"liver\" is missing"));

  auto broken = ellipsoid({0, 0, 0}, {10, 10, 10});
  broken.triangles[3] = {0, 1, 100000};
  EXPECT_THAT(complaint(scene_of(broken)), testing::HasSubstr("\"liver\" is broken"));

  Scene nowhere = scene_of(ellipsoid({0, 0, 0}, {10, 10, 10}));
  nowhere.landmarks.push_back({"tumour-1", {0, std::numeric_limits<double>::quiet_NaN(), 0}, 3, {}});
  EXPECT_THAT(complaint(nowhere), testing::HasSubstr("tumour-1"));

  Scene flat;
  flat.slices.emplace_back();
  EXPECT_THAT(complaint(flat), testing::HasSubstr("slice 1 has no volume"));
}

TEST(CheckScene, RefusesAQuantityThatIsNotThereOrHasTheWrongCount) {
  Scene scene = scene_of(ellipsoid({0, 0, 0}, {10, 10, 10}));
  scene.surfaces[0].colouring = Colouring{"displacement_mm", ColourMap::viridis, {0, 1}, ""};
  EXPECT_THAT(complaint(scene), testing::HasSubstr("no quantity \"displacement_mm\""));
  auto few = *scene.surfaces[0].surface;
  few.point_fields.push_back({"displacement_mm", 1, {1, 2, 3}});
  scene.surfaces[0].surface = std::make_shared<geometry::Surface>(few);
  EXPECT_THAT(complaint(scene), testing::HasSubstr("3 values of \"displacement_mm\""));
}

TEST(Fit, ShowsEveryPointOfTheSurfaces) {
  const Scene scene = scene_of(ellipsoid({50, -20, 10}, {90, 40, 60}));
  for (const auto view : {PatientView::anterior, PatientView::surgeon, PatientView::inferior}) {
    const Camera camera = fit(scene, view, 1.5);
    for (const Eigen::Vector3d& point : scene.surfaces[0].surface->points_mm) {
      EXPECT_LT(std::abs((point - camera.focus_mm).dot(camera.up)), 0.5 * camera.visible_height_mm);
    }
  }
}

TEST(Draw, RefusesSizesThatNoPictureHas) {
  EXPECT_EQ(draw({}, 0, 100).error().code, "picture-size");
  EXPECT_EQ(draw({}, 100, 100000).error().code, "picture-size");
}

TEST(Anatomy, GivesEveryNumberedTumourTheSameLookAndUnknownStructuresACalmOne) {
  EXPECT_EQ(appearance_of("tumour-1").colour.red, appearance_of("tumour-12").colour.red);
  EXPECT_EQ(appearance_of("liver").finish, Finish::glass);
  EXPECT_EQ(appearance_of("something else").opacity, 1);
}

}  // namespace
}  // namespace glisson::scene
