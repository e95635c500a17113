// Large deformation: bodies that turn, and equilibria whose answers are known.

#include "mechanics/statics/equilibrium.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

constexpr MaterialLaw large_laws[] = {MaterialLaw::corotational, MaterialLaw::neo_hookean};

StaticOptions options_with(double poisson_ratio, ElementOrder order) {
  StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  options.order = order;
  return options;
}

Body body_of(geometry::TetMesh mesh, double youngs_kPa, double poisson_ratio, ElementOrder order) {
  auto youngs = test::uniform(mesh, youngs_kPa);
  return prepare_body(std::move(mesh), std::move(youngs), {test::fixed("wall")}, options_with(poisson_ratio, order),
                      Holding::required)
      .value();
}

geometry::TetMesh beam(int nx, int ny, int nz, const Vector3d& size_mm) {
  auto mesh = test::box(nx, ny, nz, size_mm);
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  return mesh;
}

// A uniform dead traction over the end face, as nodal forces.
VectorXd force_on_end(const Body& body, double length_mm, const Vector3d& force_mN) {
  VectorXd nodal_mN = VectorXd::Zero(3 * body.layout.nodes());
  double area_mm2 = 0;
  const auto at_end = [&](const BoundaryFace& face) { return std::abs(face.centroid_mm.x() - length_mm) < 1e-9; };
  for (const BoundaryFace& face : body.boundary) area_mm2 += at_end(face) ? face.area_mm2 : 0;
  for (const BoundaryFace& face : body.boundary) {
    if (at_end(face)) add_traction(face, force_mN / area_mm2, nodal_mN);
  }
  return nodal_mN;
}

TEST(LargeDeformation, ABodyTurnedAndMovedResistsNothing) {
  const Body body = body_of(beam(3, 2, 2, {6, 4, 4}), 6, 0.45, ElementOrder::quadratic);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  VectorXd u(3 * body.layout.nodes());
  for (int n = 0; n < body.layout.nodes(); ++n) {
    u.segment<3>(3 * n) = turn * body.layout.positions_mm[n] + Vector3d(5, 6, 7) - body.layout.positions_mm[n];
  }
  for (const MaterialLaw law : large_laws) {
    EXPECT_LT(internal_force_mN(body, materials_of(body, law), u).norm(), 1e-10);
  }
  // Small strain takes the turn for strain: this is why the others are there.
  EXPECT_GT(internal_force_mN(body, materials_of(body, MaterialLaw::linear), u).norm(), 1.0);
}

TEST(Equilibrium, ASlenderBeamBendsAsTheElasticaDoes) {
  // A dead force P at the tip; P L^2 / (E I) = 1, 2, 5 bends the tip down by 0.30172, 0.49346, 0.71379 L and draws it
  // in by 0.05643, 0.16064, 0.38763 L (Mattiasson 1981, Int. J. Numer. Meth. Engng 17:145-153). The elastica neither
  // stretches nor shears; this beam of L / h = 20 at nu = 0 does, by about (h / L)^2 = 0.25 %, and its bending strains
  // of up to 6 % make Neo-Hookean differ a little more: 1 % of L in all.
  const double length = 100, h = 5, youngs = 1000, inertia = h * h * h * h / 12;
  const Body body = body_of(beam(20, 1, 1, {length, h, h}), youngs, 0.0, ElementOrder::quadratic);
  struct Known {
    double load, down, in;
  };
  for (const auto& [load, down, in] : {Known{1, 0.30172, 0.05643}, Known{5, 0.71379, 0.38763}}) {
    const VectorXd force = force_on_end(body, length, {0, 0, -load * youngs * inertia / (length * length)});
    for (const MaterialLaw law : large_laws) {
      const auto result = find_equilibrium(body, materials_of(body, law), force).value();
      ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
      Vector3d tip(0, 0, 0);  // the mean of the end's four corners
      for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
        if (body.mesh.points_mm[p].x() == length) tip += 0.25 * result.displacement_mm[p];
      }
      EXPECT_NEAR(tip.z(), -down * length, 0.01 * length) << load;
      EXPECT_NEAR(tip.x(), -in * length, 0.01 * length) << load;
      EXPECT_EQ(result.inverted_cells, 0);
    }
  }
}

TEST(Equilibrium, AStretchedBarReachesTheClosedForm) {
  // A cube whose faces at x = 0, y = 0, z = 0 slide, pulled at x = 1 cm by a dead traction t; nu = 0 in the
  // corotational law: the sides stay, t = 2 mu (s - 1) = E (s - 1).
  auto mesh = test::box(2, 2, 2, {10, 10, 10});
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "y0", [](const Vector3d& p) { return p.y() == 0; });
  test::name_points(mesh, "z0", [](const Vector3d& p) { return p.z() == 0; });
  const auto body =
      prepare_body(mesh, test::uniform(mesh, 6.0),
                   {test::held_along("x0", true, false, false), test::held_along("y0", false, true, false),
                    test::held_along("z0", false, false, true)},
                   options_with(0.0, ElementOrder::quadratic), Holding::required)
          .value();
  const double traction = 3.0;
  const auto result = find_equilibrium(body, materials_of(body, MaterialLaw::corotational),
                                       force_on_end(body, 10, {100 * traction, 0, 0}))
                          .value();
  ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    EXPECT_LT((result.displacement_mm[p] - Vector3d(traction / 6.0 * mesh.points_mm[p].x(), 0, 0)).norm(), 1e-5);
  }
  EXPECT_NEAR(result.largest_strain, 0.5, 1e-6);
}

TEST(Equilibrium, ForcesBalanceAndStableNeoHookeanSurvivesACrush) {
  // 30 kPa on the end of a 6 kPa body: crushed to a fraction, yet in equilibrium.
  const Body body = body_of(beam(4, 4, 4, {10, 10, 10}), 6, 0.3, ElementOrder::linear);
  const VectorXd force = force_on_end(body, 10, {-3000, 0, 0});
  const auto result = find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean), force).value();
  ASSERT_TRUE(result.converged()) << result.why_stopped;
  EXPECT_FALSE(result.may_be_used());  // some cells are inside out
  EXPECT_LT((result.applied_force_mN + result.fixed_reaction_mN).norm(), 1e-5 * 3000);
  EXPECT_GT(result.max_displacement_mm, 5);
}

TEST(Equilibrium, SaysWhereItGaveUp) {
  const Body body = body_of(beam(4, 2, 2, {20, 5, 5}), 6, 0.3, ElementOrder::linear);
  const VectorXd force = force_on_end(body, 20, {0, 0, -200});
  const auto result =
      find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean), force, {.max_steps = 1, .max_halvings = 2})
          .value();
  EXPECT_FALSE(result.may_be_used());
  EXPECT_THAT(result.why_stopped, HasSubstr("% of the load no equilibrium was found within 1 Newton steps"));
}

}  // namespace
}  // namespace glisson::mechanics
