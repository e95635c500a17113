// A hyperelastic body in motion in the hand: against the steps of `simulate` by Newton's method, and where it rests.

#include "mechanics/dynamics/moving_live_body.h"

#include <gmock/gmock.h>

#include "mechanics/bodies.h"
#include "mechanics/dynamics/internal/implicit_step.h"
#include "mechanics/elements/internal/mass_matrix.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

// A bar held at one end, whose other end is drawn to the side by a dead load and let go.
struct Swing {
  Vector3d size_mm;
  double youngs_kPa;
  ChosenLaw law;
  ToolLoad load;
  double step_s;
};
// Of the first the number of conjugate gradients was chosen.
const Swing beam{{90, 30, 30}, 5, MaterialLaw::neo_hookean, {{90, 15, 30}, 12, {0, 0, 120}}, 0.02};
const Swing other_beam{{80, 40, 25}, 4, {MaterialLaw::veronda_westmann, 2.0}, {{80, 20, 0}, 13, {-20, 60, -90}}, 0.03};

geometry::TetMesh mesh_of(const Swing& swing) {
  auto mesh = test::box(6, 2, 2, swing.size_mm);
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  return mesh;
}
const std::vector<Support> by_its_end{test::fixed("x0")};

TEST(MovingLiveBody, StepsAreThoseOfTheSlowMotionAtLargeStrain) {
  for (const Swing& swing : {beam, other_beam}) {
    const auto mesh = mesh_of(swing);
    const StaticModel at_rest = StaticModel::create(mesh, test::uniform(mesh, swing.youngs_kPa), by_its_end).value();
    const std::vector<PointInMesh> places =
        locate_points(mesh, {0.95 * swing.size_mm.cwiseProduct(Vector3d(1, 0.5, 0.5)), 0.5 * swing.size_mm});
    const DynamicsOptions options{.step_s = swing.step_s, .mass_damping_per_s = 0.5};
    const auto moving = MovingLiveBody::create(at_rest, swing.law, by_its_end, {}, places, 2, options).value();
    MovingLiveState state = moving.untouched();

    const Body body = at_rest.body();
    const auto materials = materials_of(body, swing.law.law, swing.law.strain_stiffening);
    VectorXd lumped_kg = consistent_mass_kg(body).diagonal();
    double volume_mm3 = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) volume_mm3 += geometry::cell_volume_mm3(mesh, c);
    lumped_kg *= 3 * volume_mm3 * body.options.density_kg_mm3 / lumped_kg.sum();
    const Eigen::SparseMatrix<double> mass_kg(lumped_kg.asDiagonal());
    const VectorXd pulls_mN =
        load_vector(mesh, body.layout, body.boundary, body.options.density_kg_mm3, {swing.load}).value();
    VectorXd u_mm = VectorXd::Zero(pulls_mN.size()), v_mm_s = u_mm;
    double largest_mm = 0, farthest_mm = 0;
    for (int step = 1; step <= 60; ++step) {
      const bool pulled = step <= 25;
      const std::vector<ContactTool> hand{{"hand", swing.load}};
      state = moving.step(state, pulled ? hand : std::vector<ContactTool>()).value();
      const AppliedLoads loads{pulled ? pulls_mN : VectorXd::Zero(pulls_mN.size())};
      const ImplicitStep slow(body, materials, loads, options, mass_kg, u_mm, v_mm_s);
      const auto found =
          minimise(slow.potential(), body.resolved.fixed, slow.scale_mN(), u_mm, {1e-8, 40, std::uint64_t{1} << 32}, {})
              .value();
      ASSERT_TRUE(found.converged);
      v_mm_s = (found.u_mm - u_mm) / options.step_s;
      u_mm = found.u_mm;
      largest_mm = std::max(largest_mm, u_mm.cwiseAbs().maxCoeff());
      farthest_mm = std::max(farthest_mm, (state.u_mm - u_mm).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(farthest_mm, 0.02 * largest_mm);  // 0.6 and 1.0 % were found
    EXPECT_GT(largest_mm, 20);  // far beyond what small rotations know
  }
}

TEST(MovingLiveBody, RefusesDampingByStiffness) {
  const auto mesh = mesh_of(beam);
  const StaticModel at_rest = StaticModel::create(mesh, test::uniform(mesh, beam.youngs_kPa), by_its_end).value();
  EXPECT_THAT(MovingLiveBody::create(at_rest, MaterialLaw::neo_hookean, by_its_end, {}, {}, 0,
                                     {.step_s = 0.02, .stiffness_damping_s = 0.01})
                  .error()
                  .message(),
              HasSubstr("damped by its mass alone"));
}

}  // namespace
}  // namespace glisson::mechanics
