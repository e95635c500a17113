#pragma once
// What a body is computed with: its constants, the order of its elements, and the limits of its solver.

#include <cstdint>
#include <optional>

#include "base/tissue.h"
#include "base/units.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/materials/anisotropy.h"
#include "mechanics/materials/capsule.h"

namespace glisson::mechanics {

struct StaticOptions {
  double poisson_ratio = usual_poisson_ratio;
  double density_kg_mm3 = units::kg_mm3_from_kg_m3(1000.0);
  ElementOrder order = ElementOrder::quadratic;
  double relative_tolerance = 1e-6;  // far below any measured modulus; what is reached is usually 1e-12, and 1e-8 near
                                     // incompressibility, where rounding ends it
  std::optional<Capsule> capsule = std::nullopt;                // over the whole boundary
  std::optional<TransverseIsotropy> anisotropy = std::nullopt;  // of the whole body; StaticModel alone knows it
  int max_refinements = 8;  // each gains several digits; more would not help a matrix that needs them
  // May parts hang apart, as they do behind a cut? For equilibrium each must then be fixed by itself.
  enum class Parts { one, several } parts = Parts::one;
  std::uint64_t memory_limit_bytes = std::uint64_t{12} << 30;  // the factor is refused before it asks for more
  // May supports prescribe displacements? Where no one looks at them, such a support is refused.
  bool prescribed_displacements = false;
  // Single: half the memory between the solves, for models that live long; what is solved is refined to the same
  // tolerance. Not together with mutual points.
  enum class FactorPrecision { full, single } factor_precision = FactorPrecision::full;
};

}  // namespace glisson::mechanics
