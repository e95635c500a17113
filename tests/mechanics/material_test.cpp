// Every material against itself (energy, stress, tangent), against turning, and against closed forms.

#include "mechanics/materials/material.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Lame lame = lame_from_youngs(6.0, 0.45);

struct Named {
  const char* name;
  Material material;
};
const std::vector<Named> materials{{"small strain", SmallStrain{lame}},
                                   {"corotational", Corotational{lame}},
                                   {"stable Neo-Hookean", StableNeoHookean(lame)},
                                   {"Neo-Hookean", neo_hookean_from(lame)},
                                   {"Veronda-Westmann", veronda_westmann_from(lame, 1.7)}};

Matrix3d turn(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// Rest, sheared, turned far, stretched and squeezed; all with J > 0.
std::vector<Matrix3d> deformations() {
  Matrix3d shear = Matrix3d::Identity();
  shear(0, 1) = 0.4;
  shear(2, 0) = -0.2;
  const Matrix3d stretch = Vector3d(1.5, 0.8, 0.7).asDiagonal();
  return {Matrix3d::Identity(), shear, turn(2.0, {1, 2, 3}) * shear,
          turn(-1, {0, 1, 1}) * stretch * turn(1, {1, 0, 0})};
}
// Turned inside out along one axis; only some materials go there.
const Matrix3d inverted = turn(0.7, {1, 1, 0}) * Matrix3d(Vector3d(1.2, 0.9, -0.4).asDiagonal()) * turn(0.3, {0, 1, 2});

void expect_consistent(const Named& named, const Matrix3d& f) {
  // Central differences with a step of 1e-5 err by step^2 = 1e-10 of the third derivative, and rounding by 1e-16 of the
  // energy over the step: 1e-5 kPa of moduli near 20 kPa leaves room for the exponential law.
  const double step = 1e-5, tolerance_kPa = 1e-5;
  const Matrix3d stress = first_piola_kPa(named.material, f);
  const Matrix9d tangent = tangent_kPa(named.material, f);
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-10 * tangent.norm()) << named.name;
  for (int k = 0; k < 9; ++k) {
    const Matrix3d d = step * as_matrix(Vector9d::Unit(k));
    const double slope =
        (energy_density_kPa(named.material, f + d) - energy_density_kPa(named.material, f - d)) / (2 * step);
    EXPECT_NEAR(slope, as_vector(stress)[k], tolerance_kPa) << named.name << ", entry " << k << " of\n" << f;
    const Matrix3d change =
        (first_piola_kPa(named.material, f + d) - first_piola_kPa(named.material, f - d)) / (2 * step);
    EXPECT_LT((as_vector(change) - tangent.col(k)).norm(), tolerance_kPa) << named.name << ", column " << k << " at\n"
                                                                          << f;
  }
}

TEST(Materials, StressIsTheSlopeOfEnergyAndTangentTheSlopeOfStress) {
  for (const Named& named : materials) {
    for (const Matrix3d& f : deformations()) expect_consistent(named, f);
  }
  expect_consistent(materials[1], inverted);
  expect_consistent(materials[2], inverted);
}

TEST(Materials, RestHasNoEnergyNoStressAndTheTangentOfLinearElasticity) {
  for (const auto& [name, material] : materials) {
    EXPECT_NEAR(energy_density_kPa(material, Matrix3d::Identity()), 0, 1e-13) << name;
    EXPECT_LT(first_piola_kPa(material, Matrix3d::Identity()).norm(), 1e-13) << name;
    EXPECT_LT((tangent_kPa(material, Matrix3d::Identity()) - isotropic_tangent_kPa(lame)).norm(), 1e-12) << name;
  }
}

TEST(Materials, TurningTheBodyTurnsTheStressAndKeepsTheEnergy) {
  // All but small strain, which is not objective.
  const Matrix3d q = turn(2.5, {3, -1, 2});
  for (std::size_t m = 1; m < materials.size(); ++m) {
    for (const Matrix3d& f : deformations()) {
      const auto& [name, material] = materials[m];
      EXPECT_NEAR(energy_density_kPa(material, q * f), energy_density_kPa(material, f), 1e-11) << name;
      EXPECT_LT((first_piola_kPa(material, q * f) - q * first_piola_kPa(material, f)).norm(), 1e-11) << name;
      EXPECT_LT(first_piola_kPa(material, q).norm(), 1e-12) << name;
    }
  }
}

TEST(Materials, TheWarpedTangentIsLinearElasticityTurned) {
  const Matrix3d q = turn(2.0, {1, 2, 3});
  const Matrix9d warped = Corotational{lame}.warped_tangent_kPa(q);
  // Along a displacement gradient that turns with the body: q e with e symmetric.
  Matrix3d e;
  e << 0.1, 0.02, 0, 0.02, -0.05, 0.03, 0, 0.03, 0.07;
  EXPECT_LT((as_matrix(warped * as_vector(q * e)) - q * stress_kPa(lame, e)).norm(), 1e-13);
  EXPECT_LT((warped - positive_part(warped)).norm(), 1e-12 * warped.norm());
}

// P of a uniaxial stretch with the sides held: P_11 in closed form.
TEST(Materials, StretchedWithTheSidesHeldGivesTheClosedForms) {
  const double mu = lame.mu_kPa, lambda = lame.lambda_kPa, bulk = bulk_from_lame(lame), c2 = 1.7;
  for (const double s : {0.6, 0.9, 1.3, 2.0}) {
    const Matrix3d f = Vector3d(s, 1, 1).asDiagonal();
    EXPECT_NEAR(first_piola_kPa(materials[1].material, f)(0, 0), (lambda + 2 * mu) * (s - 1), 1e-12);
    const double m = 4 * mu / 3, l = lambda + 5 * mu / 6, alpha = 1 + 0.75 * m / l;
    EXPECT_NEAR(first_piola_kPa(materials[2].material, f)(0, 0), m * s * (1 - 1 / (s * s + 3)) + l * (s - alpha),
                1e-11);
    // I1 = s^(-2/3) (s^2 + 2), I2 = s^(-4/3) (2 s^2 + 1).
    const double i1 = std::pow(s, -2.0 / 3) * (s * s + 2);
    const double i1_slope = 4.0 / 3 * (std::pow(s, 1.0 / 3) - std::pow(s, -5.0 / 3));
    const double i2_slope = 4.0 / 3 * (std::pow(s, -1.0 / 3) - std::pow(s, -7.0 / 3));
    EXPECT_NEAR(first_piola_kPa(materials[3].material, f)(0, 0), mu / 2 * i1_slope + bulk * (s - 1), 1e-11);
    EXPECT_NEAR(first_piola_kPa(materials[4].material, f)(0, 0),
                mu * std::exp(c2 * (i1 - 3)) * i1_slope - mu / 2 * i2_slope + bulk * (s - 1), 1e-10);
  }
}

TEST(Materials, IncompressibleUniaxialStressIsThatOfTheTextbooks) {
  // With J = 1 the pressure that frees the sides is what the bulk modulus would hold, so the nominal stress is
  // (P_11 - P_22 s^(-3/2)): Neo-Hookean mu (s - 1/s^2); Veronda-Westmann 2 (s - 1/s^2) (w1 + w2 / s).
  const double mu = lame.mu_kPa, c2 = 1.7;
  for (const double s : {0.7, 1.2, 1.8}) {
    const Matrix3d f = Vector3d(s, 1 / std::sqrt(s), 1 / std::sqrt(s)).asDiagonal();
    const auto nominal = [&](const Material& material) {
      const Matrix3d p = first_piola_kPa(material, f);
      return p(0, 0) - p(1, 1) * std::pow(s, -1.5);
    };
    EXPECT_NEAR(nominal(materials[3].material), mu * (s - 1 / (s * s)), 1e-11);
    const double growth = std::exp(c2 * (s * s + 2 / s - 3));
    EXPECT_NEAR(nominal(materials[4].material), 2 * (s - 1 / (s * s)) * (mu * growth - mu / 2 / s), 1e-10);
  }
}

TEST(Materials, StableNeoHookeanPushesBackFromFlatAndInverted) {
  // At any squeeze, through flat (0) to inside out, the stress along it points back to rest.
  for (const double s : {0.5, 0.1, 0.0, -0.3, -1.0}) {
    const Matrix3d f = Vector3d(1, 1, s).asDiagonal();
    EXPECT_LT(first_piola_kPa(materials[2].material, f)(2, 2), 0) << s;
    EXPECT_TRUE(std::isfinite(energy_density_kPa(materials[2].material, f)));
  }
  EXPECT_EQ(energy_density_kPa(materials[3].material, inverted), INFINITY);
}

TEST(Deformation, ThePolarRotationIsARotationEvenInsideOut) {
  for (const Matrix3d& f : {deformations()[3], inverted}) {
    const auto [rotation, stretch] = polar_decomposition(f);
    EXPECT_LT((rotation * rotation.transpose() - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(rotation.determinant(), 1, 1e-14);
    EXPECT_LT((rotation * stretch - f).norm(), 1e-14);
    EXPECT_LT((stretch - stretch.transpose()).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace glisson::mechanics
