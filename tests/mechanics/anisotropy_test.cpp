// A body with a fibre direction: each ratio is that of the modulus that it names, whichever way the fibres lie.

#include "mechanics/materials/anisotropy.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "mechanics/materials/small_strain.h"

namespace glisson::mechanics {
namespace {

constexpr double nu_of_fibres = 0.45;
const Eigen::Vector3d fibres = Eigen::Vector3d(1, 2, -0.5).normalized();
const Eigen::Vector3d across = fibres.unitOrthogonal(), third = fibres.cross(across);

// Shear stress over shear angle in the plane of two directions, per Young's modulus.
double shear_modulus(const TransverseIsotropy& anisotropy, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Matrix3d strain = 0.5 * (a * b.transpose() + b * a.transpose());
  return a.dot(as_matrix(unit_tangent(anisotropy, nu_of_fibres) * as_vector(strain)) * b);
}

TEST(TransverseIsotropy, ShearsAlongItsAxisAsItsRatioSays) {
  const double isotropic = 1 / (2 * (1 + nu_of_fibres));
  for (const AnisotropyLaw law : {AnisotropyLaw::fibres, AnisotropyLaw::engineering}) {
    const TransverseIsotropy sheared{law, 3 * fibres, 2, 0.4};
    EXPECT_NEAR(shear_modulus(sheared, fibres, across), 0.4 * isotropic, 1e-12);
    EXPECT_NEAR(shear_modulus(sheared, third, fibres), 0.4 * isotropic, 1e-12);
    EXPECT_NEAR(shear_modulus(sheared, across, third), isotropic, 1e-12);
    // What is not sheared does not notice.
    const Eigen::Matrix3d pulled = 0.1 * fibres * fibres.transpose() - 0.03 * across * across.transpose();
    EXPECT_LT(((unit_tangent(sheared, nu_of_fibres) - unit_tangent({law, fibres, 2}, nu_of_fibres)) * as_vector(pulled))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
  }
}

TEST(TransverseIsotropy, IsIsotropicWhereAllRatiosAreOne) {
  EXPECT_LT((unit_tangent({AnisotropyLaw::engineering, fibres, 1, 1}, nu_of_fibres) -
             isotropic_tangent_kPa(lame_from_youngs(1, nu_of_fibres)))
                .cwiseAbs()
                .maxCoeff(),
            1e-12);
}

TEST(TransverseIsotropy, RefusesAShearRatioThatIsNone) {
  for (const double ratio : {0.0, -1.0, std::nan("")}) {
    const auto checked = check_anisotropy({AnisotropyLaw::fibres, fibres, 2, ratio}, nu_of_fibres);
    ASSERT_FALSE(checked) << ratio;
    EXPECT_EQ(checked.error().code, "grain-invalid");
  }
}

}  // namespace
}  // namespace glisson::mechanics
