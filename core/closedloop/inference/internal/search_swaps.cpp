#include "closedloop/inference/internal/search_swaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glisson::closedloop {
namespace {

using Others = std::vector<Candidate>;

Result<Others> in_place_of(const Search& search, const Candidate& chosen, std::size_t which, const Others& singles);
bool takes_the_place(const Search& search, const Candidate& other, const Candidate& chosen, std::size_t which);

}  // namespace

Result<Swapped> with_swaps(const Search& search, const Candidate& declared, Candidate chosen,
                           const std::vector<Candidate>& singles) {
  // An explanation that leaves most of the error is none, and which of its effects could be another does not matter.
  if (search.excess(chosen) > search.options().search.excess_worth_swaps * search.excess(declared)) {
    std::vector<Others> none(chosen.fit.settings.size());
    return Swapped{std::move(chosen), std::move(none)};
  }
  for (std::size_t round = 0; round < search.options().search.swap_rounds; ++round) {
    std::vector<Others> in_place;
    bool swapped = false;
    for (std::size_t which = 0; which < chosen.fit.settings.size() && !swapped; ++which) {
      auto others = in_place_of(search, chosen, which, singles);
      if (!others) return failure(std::move(others.error()));
      std::stable_sort(others->begin(), others->end(),
                       [&](const auto& a, const auto& b) { return search.bic_of(a) < search.bic_of(b); });
      const auto better = std::find_if(others->begin(), others->end(), [&](const Candidate& other) {
        return takes_the_place(search, other, chosen, which);
      });
      if (better != others->end()) {
        chosen = *better;
        swapped = true;
      }
      in_place.push_back(std::move(*others));
    }
    if (!swapped) return Swapped{std::move(chosen), std::move(in_place)};
  }
  // Still swapping: the last choice stands, and its alternatives are found once more.
  return with_alternatives(search, std::move(chosen), singles);
}

Result<Swapped> with_alternatives(const Search& search, Candidate chosen, const std::vector<Candidate>& singles) {
  std::vector<Others> in_place;
  for (std::size_t which = 0; which < chosen.fit.settings.size(); ++which) {
    auto others = in_place_of(search, chosen, which, singles);
    if (!others) return failure(std::move(others.error()));
    in_place.push_back(std::move(*others));
  }
  return Swapped{std::move(chosen), std::move(in_place)};
}

namespace {

// What could stand in the place of a single effect was fitted in the search's first step, where there was one.
Result<Others> in_place_of(const Search& search, const Candidate& chosen, std::size_t which, const Others& singles) {
  if (chosen.fit.settings.size() != 1 || singles.empty()) return search.in_place_of(chosen, which);
  Others others = singles;
  const Setting& own = chosen.fit.settings.front();
  std::erase_if(others, [&](const Candidate& other) {
    return !other.fitted() || search.ran_out_of_range(other) || (other.kind == own.kind && other.form == own.form);
  });
  return others;
}

// Whether the catalogue names `kind` before `other`.
bool comes_before(const ForwardModel& model, const std::string& kind, const std::string& other) {
  const auto place = [&](const std::string& wanted) {
    return std::find_if(model.catalogue().begin(), model.catalogue().end(),
                        [&](const Effect& effect) { return effect.kind == wanted; });
  };
  return place(kind) < place(other);
}

// Their predictions differ by less than an error whose shape nobody knows, and which `other` does not exceed either: of
// those, evidence that takes rows for independent finds the shape of the error. (Where a shape is expected, how much of
// it shows is weighed by itself: share_of.)
bool within_error_of_unknown_shape(const Search& search, const Candidate& other, const Candidate& chosen) {
  if (search.indistinct() == 0 || search.systematic().expected.size() > 0 || !search.leaves_nothing(other))
    return false;
  const Eigen::VectorXd difference =
      (other.fit.predicted - chosen.fit.predicted).cwiseQuotient(search.model().observations().noise);
  return difference.norm() <= search.indistinct() * std::sqrt(static_cast<double>(difference.size()));
}

bool takes_the_place(const Search& search, const Candidate& other, const Candidate& chosen, std::size_t which) {
  const double clearly = search.options().search.swap_bic;
  const double alike_bic = search.options().alike_bic;
  const double gain = search.bic_of(chosen) - search.bic_of(other);
  const auto more = parameter_count(other.fit.settings) - parameter_count(chosen.fit.settings);
  // Of two that the data cannot tell apart, the one of fewer numbers leads.
  if (more != 0 && within_error_of_unknown_shape(search, more < 0 ? other : chosen, more < 0 ? chosen : other))
    return more < 0;
  if (more < 0 && gain > -alike_bic)
    return (search.leaves_nothing(other) || !search.leaves_nothing(chosen)) &&
           other.left_out.chi2 <= search.options().search.about_as_well_left_out * chosen.left_out.chi2;
  // Of as many numbers, the one that the catalogue names first: it begins with the plainest causes.
  if (more == 0 && gain > -clearly && comes_before(search.model(), other.kind, chosen.fit.settings[which].kind) &&
      search.leaves_nothing(other) == search.leaves_nothing(chosen))
    return other.left_out.chi2 <= chosen.left_out.chi2;
  return gain > (more > 0 ? alike_bic : clearly) && other.left_out.chi2 <= chosen.left_out.chi2;
}

}  // namespace
}  // namespace glisson::closedloop
