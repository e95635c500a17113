#pragma once
// What an answer is worth: whether it was found, how far it is strained, and whether cells were turned inside out. It
// goes with every result, to the window, the reports and the files; the numbers of an unusable one are not shown.

#include <limits>
#include <string>
#include <string_view>

#include "base/sentence.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

enum class AnswerState {
  within,                // of what the model is made for
  outside_of_the_model,  // found, but strained beyond it: an extrapolation
  unusable,              // cells turned inside out: no liver can lie like this
  not_converged,         // no equilibrium
};

// Where small strain ends to describe soft tissue. At 20 % Green's strain and the small one differ by a tenth, as
// (lambda^2 - 1)/2 and lambda - 1 say.
inline constexpr double small_strain_limit = 0.2;
// Of each law; the hyperelastic ones have none.
[[nodiscard]] double strain_limit(MaterialLaw law);

struct Validity {
  bool converged = false;
  double largest_strain = 0;  // principal, in magnitude
  int inverted_cells = 0;
  double limit = small_strain_limit;

  [[nodiscard]] AnswerState state() const;
  // Its numbers may be shown.
  [[nodiscard]] bool usable() const { return state() < AnswerState::unusable; }
  [[nodiscard]] Sentence sentence() const;
  // Of one that is not usable, without a capital and a full stop: to stand in another sentence.
  [[nodiscard]] Sentence why_not() const;
};
[[nodiscard]] Validity validity_of(const StaticResult& result, MaterialLaw law = MaterialLaw::linear);

// Of a result that may not be used: why it stopped, or how many cells are inside out.
[[nodiscard]] std::string why_not_used(const StaticResult& result);

// "within", "outside-of-the-model", "unusable", "not-converged": as files say it.
[[nodiscard]] std::string_view to_string(AnswerState state);

}  // namespace glisson::mechanics
