#pragma once
// Everything that effects may change about a palpation, in one value: each effect writes its own part, so that effects
// compose. Default: the declared model.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/palpation/internal/structure.h"
#include "mechanics/materials/relaxation.h"

namespace glisson::closedloop {

// How Young's modulus of the body grows with q = eps : C eps / E, the square of a strain: sigma = E g(q) (C / E) eps.
// Where a bar is pulled, it is the square of the strain itself. The energy E/2 integral of g makes it an elastic law,
// at small strain.
//
// Tissue that stiffens is mostly strained far, so two more laws are for large strain, by principal stretches
// (stretch.h). Their loads keep the direction and the faces that they have at rest. They hold the geometry's own
// nonlinearity too, and replace the declared small strain as soon as they are on at all.
enum class StiffeningLaw {
  exponential,  // g = exp(b q): Fung's
  linear,       // g = 1 + b sqrt(q)
  yeoh,         // large strain
  ogden,        // large strain
};
struct Stiffening {
  StiffeningLaw law = StiffeningLaw::exponential;
  double coefficient = 0;  // b, or Ogden's exponent; 0: no stiffening, whatever the law
};

using mechanics::CreepTerm;

// What settings say of supports refers to these.
struct DeclaredSupports {
  double fixed_from_kPa_per_mm = 0;  // springs as stiff as this are no springs,
  double nothing_to_kPa_per_mm = 0;  // ... and springs as soft as this are none
  std::vector<std::string> names;    // of each: its point array's, where no other has it, or "support-2"
};

struct PalpationState {
  double stiffness_factor = 1;
  Structure structure;
  std::optional<Stiffening> stiffening;
  std::vector<CreepTerm> creep;
  double zero_mN = 0;
  double gain = 1;
  Eigen::Vector3d rotation_deg{0, 0, 0};  // a rotation vector, about the origin of the coordinates
  Eigen::Vector3d translation_mm{0, 0, 0};
  Eigen::Vector3d gravity_mm_s2{0, 0, 0};  // besides the declared one
  double pressure_kPa = 0;

  // Springs and membrane do not scale with the body's modulus: the structure of which this state's displacements are
  // 1 / stiffness_factor times the response.
  [[nodiscard]] Structure scaled_structure() const;
};

// Of an anisotropy's form in effects.h.
[[nodiscard]] mechanics::AnisotropyLaw anisotropy_law(const std::string& form);

// Settings of effects.h.
[[nodiscard]] PalpationState state_of(const Settings& settings, const DeclaredSupports& supports);

}  // namespace glisson::closedloop
