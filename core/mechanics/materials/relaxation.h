#pragma once
// How the stress of a whole body relaxes, by a Prony series of its modulus:
//   G(t) / G(0) = 1 - sum g_k (1 - exp(-t / tau_k)),   g_k > 0,   sum g_k < 1.
// Weights are shares of the modulus at once, G(0): that is the modulus which is declared, here and everywhere else. All
// moduli relax alike, so that Poisson's ratio stays. Foundations, ligaments, capsule and tools do not relax.
//
// The stress is T(t) = integral of G(t - s) / G(0) dT0(s), T0 the elastic one of the body's law:
// - linear: the stress of small strain (e.g. Christensen 1982, Theory of Viscoelasticity, 1.2).
// - corotational: the same in the frame that turns with the material, Biot's stress R^T P.
// - the laws of large strain: the second Piola-Kirchhoff stress F^-1 P, which no turn of the body changes. That is
//   Fung's quasi-linear viscoelasticity (Fung 1993, Biomechanics: Mechanical Properties of Living Tissues, ch. 7).
//   Simo's (1987, Comput. Methods Appl. Mech. Eng. 60:153-173) is the same of the deviator alone.
// At small strain all three are one. Valid where one function of time fits all strains.

#include <vector>

#include "base/result.h"

namespace glisson::mechanics {

struct RelaxationTerm {
  double weight = 0;  // g
  double time_s = 0;  // tau
};
using Relaxation = std::vector<RelaxationTerm>;  // empty: nothing relaxes

inline constexpr std::size_t most_relaxation_terms = 16;  // each is a stress a cell

// Failure: "relaxation-invalid" (which term; the weights' sum; too many).
Result<void> check_relaxation(const Relaxation& relaxation);

// What is left of the modulus after long: 1 - sum g.
[[nodiscard]] double long_term_share(const Relaxation& relaxation);

// A step h in time, exact where T0 changes evenly within it (Taylor, Pister, Goudreau 1970, Int. J. Numer. Methods Eng.
// 2:45-59; Simo and Hughes 1998, Computational Inelasticity, ch. 10). With T = (1 - sum g) T0 + sum H:
//   H(t + h) = decay H(t) + share (T0(t + h) - T0(t)),   decay = exp(-h / tau),   share = g (1 - decay) tau / h.
struct RelaxationStep {
  double decay = 0;
  double share = 0;
};
[[nodiscard]] std::vector<RelaxationStep> steps_of(const Relaxation& relaxation, double step_s);
// The share of T0(t + h) in T(t + h): a step answers as elastic tissue of that share of its moduli does. 1 where
// nothing relaxes.
[[nodiscard]] double share_within(const Relaxation& relaxation, double step_s);

// Creep under a constant stress: J(t) / J(0) = 1 + sum a_k (1 - exp(-t / T_k)).
struct CreepTerm {
  double amplitude = 0;  // a, not negative
  double time_s = 1;     // T
};
// The relaxation of a body that creeps so, exactly: as many terms, whose times lie between those of creep (Gross 1953,
// Mathematical Structure of the Theories of Viscoelasticity, ch. 5). Of one term g = a / (1 + a), tau = T / (1 + a).
// The longest time comes first.
[[nodiscard]] Relaxation relaxation_of(std::vector<CreepTerm> creep);

}  // namespace glisson::mechanics
