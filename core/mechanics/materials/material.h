#pragma once
// What a body may be made of. Each material is its constants and three functions of the deformation gradient F. They
// are the energy per rest volume (kPa, which is uJ/mm3) and the first Piola-Kirchhoff stress P = d energy / dF (kPa).
// The third is the tangent dP/dF (kPa, 9x9 in the order of deformation.h). A file each; this one chooses between them.

#include <variant>

#include "mechanics/materials/corotational.h"
#include "mechanics/materials/isochoric.h"
#include "mechanics/materials/small_strain.h"
#include "mechanics/materials/stable_neo_hookean.h"

namespace glisson::mechanics {

using Material = std::variant<SmallStrain, Corotational, StableNeoHookean, NeoHookean, VerondaWestmann>;

[[nodiscard]] inline double energy_density_kPa(const Material& material, const Eigen::Matrix3d& f) {
  return std::visit([&](const auto& law) { return law.energy_density_kPa(f); }, material);
}
[[nodiscard]] inline Eigen::Matrix3d first_piola_kPa(const Material& material, const Eigen::Matrix3d& f) {
  return std::visit([&](const auto& law) { return law.first_piola_kPa(f); }, material);
}
[[nodiscard]] inline Matrix9d tangent_kPa(const Material& material, const Eigen::Matrix3d& f) {
  return std::visit([&](const auto& law) { return law.tangent_kPa(f); }, material);
}

// The same law with all moduli `factor` times as large.
[[nodiscard]] Material scaled(const Material& material, double factor);

}  // namespace glisson::mechanics
