#include "geometry/mend.h"

#include <gmock/gmock.h>

#include "geometry/geodesic.h"
#include "support/shapes.h"

namespace glisson::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Numbered points, so that fields can be followed.
Surface ball() {
  Surface ball = test::sphere_surface(10, 2);
  Field number{"number", 1, {}};
  for (std::size_t p = 0; p < ball.points_mm.size(); ++p) number.values.push_back(double(p));
  set_field(ball.point_fields, std::move(number));
  return ball;
}

TEST(MendedSurface, LeavesASoundOneAsItIs) {
  const Surface sound = ball();
  const Mended mended = geometry::mended(sound).value();
  EXPECT_TRUE(mended.remarks.empty());
  EXPECT_EQ(mended.surface.triangles, sound.triangles);
  EXPECT_EQ(mended.surface.points_mm, sound.points_mm);
}

// Geodesics refuse it before and walk over it after; every fault is told.
TEST(MendedSurface, HasItsDoubledAndTurnedTrianglesPutRight) {
  const Surface sound = ball();
  Surface broken = sound;
  for (const std::size_t t : {0U, 7U, 100U}) std::swap(broken.triangles[t][0], broken.triangles[t][1]);
  broken.triangles.push_back(broken.triangles[11]);
  broken.triangles.push_back({5, 5, 6});
  ASSERT_EQ(HeatGeodesics::prepare(broken).error().code, "surface-not-manifold");
  const Mended mended = geometry::mended(broken).value();
  EXPECT_THAT(messages(mended.remarks), ElementsAre(HasSubstr("Doubled or empty triangles left out: 2"),
                                                    HasSubstr("turned to fit their neighbours: 3")));
  EXPECT_TRUE(is_watertight(mended.surface));
  EXPECT_NEAR(volume_mm3(mended.surface), volume_mm3(sound), 1e-9);
  EXPECT_TRUE(HeatGeodesics::prepare(mended.surface).has_value());
}

TEST(MendedSurface, IsTurnedAsMostOfItsTrianglesWhicheverComesFirst) {
  Surface broken = ball();
  std::swap(broken.triangles[0][0], broken.triangles[0][1]);
  EXPECT_GT(volume_mm3(geometry::mended(broken)->surface), 0);
}

TEST(MendedSurface, IsJoinedWherePointsLieAtOnePlace) {
  const Surface sound = ball();
  Surface torn = sound;  // every triangle with points of its own, as STL has them
  torn.points_mm.clear();
  torn.point_fields.clear();
  for (auto& triangle : torn.triangles) {
    for (int& corner : triangle) {
      torn.points_mm.push_back(sound.points_mm[static_cast<std::size_t>(corner)]);
      corner = static_cast<int>(torn.points_mm.size()) - 1;
    }
  }
  const Mended mended = geometry::mended(torn).value();
  EXPECT_EQ(mended.surface.points_mm.size(), sound.points_mm.size());
  EXPECT_TRUE(is_watertight(mended.surface));
  EXPECT_THAT(messages(mended.remarks), ElementsAre(HasSubstr("Points at the place of another")));
}

// A fin on an edge, and two balls that touch in a point: no manifold, until they are parted.
TEST(MendedSurface, IsPartedWhereItOnlyTouches) {
  Surface finned = ball();
  const auto [a, b, c] = finned.triangles[20];
  const auto tip = static_cast<int>(finned.points_mm.size());
  finned.points_mm.push_back(1.3 * finned.points_mm[static_cast<std::size_t>(a)]);
  finned.point_fields.front().values.push_back(tip);
  finned.triangles.push_back({a, b, tip});
  const Mended mended = geometry::mended(finned, Pieces::several).value();
  EXPECT_TRUE(HeatGeodesics::prepare(connected_pieces(mended.surface).front()).has_value());
  for (std::size_t p = 0; p < mended.point_from.size(); ++p) {
    EXPECT_EQ(mended.surface.point_fields.front().values[p], mended.point_from[p]) << "fields follow their points";
  }
}

TEST(MendedSurface, LosesCrumbsButIsRefusedInHalves) {
  const auto with = [](double radius_mm) {
    Surface two = ball();
    two.point_fields.clear();
    const Surface other = test::sphere_surface(radius_mm, 1, {40, 0, 0});
    const auto first = static_cast<int>(two.points_mm.size());
    two.points_mm.insert(two.points_mm.end(), other.points_mm.begin(), other.points_mm.end());
    for (const auto& [a, b, c] : other.triangles) two.triangles.push_back({a + first, b + first, c + first});
    return two;
  };
  const Mended mended = geometry::mended(with(0.5)).value();
  EXPECT_EQ(mended.surface.points_mm.size(), ball().points_mm.size());
  EXPECT_THAT(messages(mended.remarks), ElementsAre(HasSubstr("Pieces left out, together below 1 % of the area: 1")));
  EXPECT_EQ(geometry::mended(with(10)).error().code, "surface-in-pieces");
  EXPECT_FALSE(geometry::mended(with(10)).error().hint.empty());
  EXPECT_EQ(geometry::mended(with(10), Pieces::several)->surface.triangles.size(), with(10).triangles.size());
}

TEST(MendedSurface, OfNoAreaIsRefused) {
  Surface line;
  line.points_mm = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_EQ(geometry::mended(line).error().code, "surface-flat");
}

TEST(MendedSurface, IsCarriedBackToThePointsThatWereGiven) {
  Surface broken = ball();
  broken.triangles.push_back(broken.triangles[3]);
  broken.points_mm.emplace_back(10.5, 0, 0);  // loose
  broken.point_fields.front().values.push_back(0);
  const Mended mended = geometry::mended(broken).value();
  std::vector<Eigen::Vector3d> moved_mm = mended.surface.points_mm;
  for (Eigen::Vector3d& point : moved_mm) point += Eigen::Vector3d(1, 2, 3);
  const Surface carried = carried_back(broken, mended, moved_mm);
  EXPECT_EQ(carried.triangles, broken.triangles);
  for (std::size_t p = 0; p < broken.points_mm.size(); ++p) {
    EXPECT_LT((carried.points_mm[p] - broken.points_mm[p] - Eigen::Vector3d(1, 2, 3)).norm(), 1e-12) << p;
  }
}

}  // namespace
}  // namespace glisson::geometry
