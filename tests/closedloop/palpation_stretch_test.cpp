// Laws by principal stretches: stress is the slope of the energy, the tangent the slope of the stress, and at rest both
// are those of linear elasticity.

#include "closedloop/palpation/internal/stretch.h"

#include <gmock/gmock.h>
#include <Eigen/LU>

#include "mechanics/materials/isochoric.h"
#include "mechanics/materials/small_strain.h"

namespace glisson::closedloop {
namespace {

Eigen::Matrix3d bent() {
  Eigen::Matrix3d f;
  f << 1.1, 0.2, -0.1, 0.05, 0.85, 0.1, -0.15, 0.1, 1.05;
  return f;
}

TEST(StretchLaws, TheTangentIsTheSlopeOfTheStress) {
  for (const StretchLaw law : {StretchLaw::yeoh, StretchLaw::ogden}) {
    const StretchMaterial material = stretch_material(law, 5, 0.45);
    for (const Eigen::Matrix3d& f : {bent(), Eigen::Matrix3d(Eigen::Matrix3d::Identity()),
                                     Eigen::Matrix3d(Eigen::Vector3d(0.9, 1.1, 1.1).asDiagonal())}) {
      const PrincipalState state = principal_state(material, f);
      for (int k = 0; k < 9; ++k) {
        Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
        step.data()[k] = 1;
        const double h = 1e-5;
        const Eigen::Matrix3d difference =
            (stress_of(principal_state(material, f + h * step)) - stress_of(principal_state(material, f - h * step))) /
            (2 * h);
        EXPECT_LT((stress_change(state, step) - difference).cwiseAbs().maxCoeff(), 1e-7);
      }
    }
  }
}

TEST(StretchLaws, WithoutStiffeningTheyAreNeoHookean) {
  const mechanics::NeoHookean judge = mechanics::neo_hookean_from(mechanics::lame_from_youngs(1, 0.45));
  for (const StretchMaterial& material :
       {stretch_material(StretchLaw::yeoh, 0, 0.45), stretch_material(StretchLaw::ogden, 2, 0.45)}) {
    EXPECT_LT((stress_of(principal_state(material, bent())) - judge.first_piola_kPa(bent())).cwiseAbs().maxCoeff(),
              1e-12);
  }
}

TEST(StretchLaws, AtRestTheyAreTheDeclaredMaterial) {
  const mechanics::Matrix9d declared = mechanics::isotropic_tangent_kPa(mechanics::lame_from_youngs(1, 0.45));
  Eigen::Matrix3d step;
  step << 1, 2, 3, -1, 0.5, 2, 0.3, -2, 1;
  for (const StretchLaw law : {StretchLaw::yeoh, StretchLaw::ogden}) {
    const PrincipalState state = principal_state(stretch_material(law, 7, 0.45), Eigen::Matrix3d::Identity());
    EXPECT_LT(stress_of(state).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((mechanics::as_vector(stress_change(state, step)) - declared * mechanics::as_vector(step))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
  }
}

}  // namespace
}  // namespace glisson::closedloop
