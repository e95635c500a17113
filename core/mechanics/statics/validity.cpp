#include "mechanics/statics/validity.h"

#include <fmt/format.h>

namespace glisson::mechanics {

double strain_limit(MaterialLaw law) {
  const bool small = law == MaterialLaw::linear || law == MaterialLaw::corotational;
  return small ? small_strain_limit : std::numeric_limits<double>::infinity();
}

AnswerState Validity::state() const {
  if (!converged) return AnswerState::not_converged;
  if (inverted_cells > 0) return AnswerState::unusable;
  return largest_strain > limit ? AnswerState::outside_of_the_model : AnswerState::within;
}

Sentence Validity::sentence() const {
  const auto percent = [](double share) { return fmt::format("{:.0f}", 100 * share); };
  switch (state()) {
    case AnswerState::within:
      return {GLISSON_TEXT("Within the model: strains reach {0} %."), {percent(largest_strain)}};
    case AnswerState::outside_of_the_model:
      return {GLISSON_TEXT("Outside of the model: strains reach {0} %, and beyond {1} % it is an extrapolation."),
              {percent(largest_strain), percent(limit)}};
    case AnswerState::unusable:
      return {GLISSON_TEXT("Not to be used: cells turned inside out: {0}."), {std::to_string(inverted_cells)}};
    case AnswerState::not_converged: return {GLISSON_TEXT("Not to be used: the computation did not converge."), {}};
  }
  GLISSON_ASSERT(false);
}

Sentence Validity::why_not() const {
  GLISSON_ASSERT(!usable());
  if (!converged) return {GLISSON_TEXT("the computation did not converge"), {}};
  return {GLISSON_TEXT("cells turned inside out: {0}"), {std::to_string(inverted_cells)}};
}

Validity validity_of(const StaticResult& result, MaterialLaw law) {
  return {result.status == SolveStatus::converged, result.largest_strain, result.inverted_cells, strain_limit(law)};
}

std::string why_not_used(const StaticResult& result) {
  return result.converged() ? validity_of(result).why_not().message() : result.why_stopped;
}

std::string_view to_string(AnswerState state) {
  switch (state) {
    case AnswerState::within: return "within";
    case AnswerState::outside_of_the_model: return "outside-of-the-model";
    case AnswerState::unusable: return "unusable";
    case AnswerState::not_converged: return "not-converged";
  }
  GLISSON_ASSERT(false);
}

}  // namespace glisson::mechanics
