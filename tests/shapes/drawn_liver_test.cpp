// Livers drawn from a model: the same by the same seed, as different as the model says, and meshed.

#include <gmock/gmock.h>

#include "ellipsoids.h"
#include "shapes/drawn_liver.h"

namespace glisson::shapes {
namespace {

const ShapeModel& drawn_model() {
  static const ShapeModel made = honest_model(test::ellipsoids(40)).value();
  return made;
}

}  // namespace

TEST(DrawnLivers, TheSameSeedAndNumberGiveTheSameLiver) {
  const DrawnLiver first = draw_liver(drawn_model(), 5, 2).value(), again = draw_liver(drawn_model(), 5, 2).value();
  EXPECT_EQ(first.coefficients, again.coefficients);
  EXPECT_EQ(first.surface.points_mm, again.surface.points_mm);
  EXPECT_NE(first.coefficients, draw_liver(drawn_model(), 5, 3).value().coefficients);
  EXPECT_NE(first.coefficients, draw_liver(drawn_model(), 6, 2).value().coefficients);
}

TEST(DrawnLivers, DifferAsTheModelSays) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(drawn_model().rank()), squares = sum;
  constexpr int count = 400;
  for (int i = 0; i < count; ++i) {
    const DrawnLiver liver = draw_liver(drawn_model(), 1, static_cast<std::uint64_t>(i)).value();
    EXPECT_LE(liver.coefficients.cwiseAbs().maxCoeff(), 3);
    sum += liver.coefficients;
    squares += liver.coefficients.cwiseAbs2();
  }
  EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 0.2);
  EXPECT_GT((squares / count).minCoeff(), 0.75);
  EXPECT_LT((squares / count).maxCoeff(), 1.25);
}

TEST(DrawnLivers, AreMeshedAsAnyLiver) {
  const DrawnLiver liver = draw_liver(drawn_model(), 1, 1).value();
  const auto mesh = mesh_of(liver, 3000, 4);
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_TRUE(is_watertight(mesh->surface));
  const double drawn_ml = geometry::volume_mm3(liver.surface) / 1000;
  EXPECT_NEAR(geometry::volume_mm3(mesh->surface) / 1000, drawn_ml, 0.03 * drawn_ml);
}

}  // namespace glisson::shapes
