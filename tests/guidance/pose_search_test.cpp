// A first pose from a cloud alone: what a cloud of a ball's front contradicts, real shapes of a liver placed without
// guess and features, and shapes that fit in two places refused.

#include "guidance/pose_search.h"

#include <gmock/gmock.h>

#include "base/json.h"
#include "guidance/guidance_file.h"
#include "guidance/internal/seen_depths.h"
#include "support/data.h"
#include "support/egg.h"

namespace glisson::guidance {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The side of an organ that a camera in the origin sees: points of each triangle that faces it, none hidden (convex).
SeenFrame seen_by_camera(const geometry::Surface& organ, const Isometry3d& pose) {
  SeenFrame frame;
  frame.id = "f0";
  for (const auto& triangle : organ.triangles) {
    const auto corner = [&](int k) { return Vector3d(pose * organ.points_mm[static_cast<std::size_t>(triangle[k])]); };
    if ((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(corner(0)) > 0) continue;
    constexpr int n = 4;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        const double v = (i + 0.3) / n, w = (j + 0.3) / n;
        frame.points_mm.push_back((1 - v - w) * corner(0) + v * corner(1) + w * corner(2));
      }
    }
  }
  return frame;
}

Isometry3d ahead(double z_mm) { return Isometry3d(Eigen::Translation3d(5, -3, z_mm)); }

TEST(SeenDepths, AnOrganWhereItWasSeenContradictsNothing) {
  const geometry::Surface egg_surface = geometry::boundary_surface(egg());
  const SeenDepths depths(seen_by_camera(egg_surface, ahead(150)).points_mm);
  ASSERT_TRUE(depths.is_picture());
  EXPECT_EQ(depths.contradiction(egg_surface, ahead(150)).before, 0.0);
  EXPECT_LT(depths.contradiction(egg_surface, ahead(150)).unseen, 0.01);
}

TEST(SeenDepths, AnOrganBeforeWhatWasSeenContradictsAllOfIt) {
  const geometry::Surface egg_surface = geometry::boundary_surface(egg());
  const SeenDepths depths(seen_by_camera(egg_surface, ahead(150)).points_mm);
  EXPECT_GT(depths.contradiction(egg_surface, ahead(120)).before, 0.95);
}

TEST(SeenDepths, AnOrganBesideWhatWasSeenWouldBeSeenThere) {
  const geometry::Surface egg_surface = geometry::boundary_surface(egg());
  SeenFrame frame = seen_by_camera(egg_surface, ahead(150));
  std::vector<Vector3d> holed;  // nothing was seen in the middle third
  for (const Vector3d& p : frame.points_mm) {
    if (std::abs(p.x() / p.z() - 5.0 / 150) > 0.09) holed.push_back(p);
  }
  const SeenDepths depths(holed);
  ASSERT_TRUE(depths.is_picture());
  EXPECT_GT(depths.contradiction(egg_surface, ahead(150)).unseen, 0.2);
}

TEST(SeenDepths, FewPointsAndPointsBehindTheCameraAreNoPicture) {
  SeenFrame frame = seen_by_camera(geometry::boundary_surface(egg()), ahead(150));
  std::vector<Vector3d> behind = frame.points_mm;
  behind.front().z() = -10;
  EXPECT_FALSE(SeenDepths(behind).is_picture());
  frame.points_mm.resize(100);
  EXPECT_FALSE(SeenDepths(frame.points_mm).is_picture());
  EXPECT_FALSE(SeenDepths({}).is_picture());
  EXPECT_FALSE(SeenDepths(std::vector<Vector3d>(1000, Vector3d(1, 2, 100))).is_picture());
}

// Half a turn about its longest side takes the egg to itself, nearly: in two places it looks alike.
TEST(PoseSearch, AShapeThatFitsInTwoPlacesIsRefused) {
  const geometry::Surface egg_surface = geometry::boundary_surface(egg());
  const auto found = find_pose(egg_surface, seen_by_camera(egg_surface, ahead(150)));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "pose-not-found");
  EXPECT_THAT(found.error().message(), testing::HasSubstr("more than one place"));
}

TEST(PoseSearch, ACloudOfAnotherShapeLiesNowhereNear) {
  const geometry::Surface egg_surface = geometry::boundary_surface(egg());
  SeenFrame frame;
  frame.id = "f0";
  for (int i = 0; i < 40; ++i) {  // a plane twice as wide as the egg is long
    for (int j = 0; j < 40; ++j) frame.points_mm.emplace_back(4 * i - 80, 4 * j - 80, 150);
  }
  const auto found = find_pose(egg_surface, frame);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message(), testing::HasSubstr("Under no pose"));
}

// Livers that CalculiX deformed, without their guesses and features. These examples were used to choose the rules; the
// studies' guided sequence was not.
TEST(PoseSearch, LiversAreFoundByTheCloudsShapeAlone) {
  GLISSON_NEEDS_DATA("guidance_examples");
  for (const char* example : {"example-b", "example-c", "example-d"}) {
    const auto folder = test::shared_data() / "guidance_examples" / example;
    const auto guidance = read_guidance(folder / "guidance.json");
    ASSERT_TRUE(guidance) << guidance.error().message();
    const Json truth = read_json_file(folder / "truth.json").value();
    for (std::size_t f = 0; f < guidance->frames.size(); ++f) {
      SeenFrame frame = guidance->frames[f];
      frame.curves.clear();
      const auto found = find_pose(geometry::boundary_surface(guidance->mesh), frame);
      ASSERT_TRUE(found) << example << ' ' << found.error().message();
      double sum_mm = 0;
      for (std::size_t t = 0; t < guidance->targets.size(); ++t) {
        const auto& p = truth["frames"][f]["targets"][t]["position_mm"];
        sum_mm += (*found * guidance->targets[t].at_rest_mm -
                   Vector3d(p[0].get<double>(), p[1].get<double>(), p[2].get<double>()))
                      .norm();
      }
      const double best_rigid_mm = truth["frames"][f]["best_rigid_tre_mm"]["mean"].get<double>();
      EXPECT_LT(sum_mm / static_cast<double>(guidance->targets.size()), 2.5 * best_rigid_mm + 1.0)
          << example << ' ' << frame.id;
    }
  }
}

}  // namespace
}  // namespace glisson::guidance
