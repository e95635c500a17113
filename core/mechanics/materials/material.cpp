#include "mechanics/materials/material.h"

namespace glisson::mechanics {
namespace {

Lame times(const Lame& lame, double factor) { return {factor * lame.lambda_kPa, factor * lame.mu_kPa}; }

struct Scaled {
  double factor;
  Material operator()(const SmallStrain& law) const { return SmallStrain{times(law.lame, factor)}; }
  Material operator()(const Corotational& law) const { return Corotational{times(law.lame, factor)}; }
  Material operator()(const StableNeoHookean& law) const { return law.scaled(factor); }
  Material operator()(const NeoHookean& law) const { return NeoHookean{factor * law.shear_kPa, factor * law.bulk_kPa}; }
  Material operator()(const VerondaWestmann& law) const {
    return VerondaWestmann{factor * law.shear_kPa, law.stiffening, factor * law.bulk_kPa};
  }
};

}  // namespace

Material scaled(const Material& material, double factor) { return std::visit(Scaled{factor}, material); }

}  // namespace glisson::mechanics
