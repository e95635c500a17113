#include "planning/ranking.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace glisson::planning {
namespace {

// More is better in each.
struct Merits {
  double cleared = 0;  // minus the tumours that are left or cut through
  double margin_mm = 0;
  double living_ml = 0;
};

Merits merits_of(const PlanAnswer& answer) {
  const auto not_cleared = std::count_if(answer.tumours.begin(), answer.tumours.end(),
                                         [](const MarginAnswer& tumour) { return tumour.side != Side::removed; });
  return {-static_cast<double>(not_cleared), answer.margin_mm.value_or(0),
          answer.living_ml.value_or(answer.functional_remnant_ml)};
}

bool beats(const Merits& a, const Merits& b) {
  constexpr double same_mm = 0.5, same_ml = 1;
  const double cleared = a.cleared - b.cleared, margin_mm = a.margin_mm - b.margin_mm,
               living_ml = a.living_ml - b.living_ml;
  const bool as_good = cleared >= 0 && margin_mm >= -same_mm && living_ml >= -same_ml;
  return as_good && (cleared > 0 || margin_mm > same_mm || living_ml > same_ml);
}

double beyond_ml(const PlanAnswer& answer) {
  return std::accumulate(answer.branches.begin(), answer.branches.end(), 0.0,
                         [](double sum, const CutBranch& branch) { return sum + branch.beyond_ml; });
}

}  // namespace

std::optional<RankBy> rank_by(std::string_view name) {
  if (name == "margin") return RankBy::margin;
  if (name == "living") return RankBy::living;
  if (name == "branches") return RankBy::branches;
  return std::nullopt;
}

std::vector<std::size_t> ranked(const std::vector<PlanAnswer>& answers, RankBy by) {
  const auto worth = [&](std::size_t n) {
    const Merits merits = merits_of(answers[n]);
    const double chosen = by == RankBy::margin   ? merits.margin_mm
                          : by == RankBy::living ? merits.living_ml
                                                 : -beyond_ml(answers[n]);
    return std::pair(merits.cleared, chosen);
  };
  std::vector<std::size_t> places(answers.size());
  std::iota(places.begin(), places.end(), 0);
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
  return places;
}

std::vector<std::vector<std::size_t>> beaten_by(const std::vector<PlanAnswer>& answers) {
  std::vector<Merits> merits;
  std::transform(answers.begin(), answers.end(), std::back_inserter(merits), merits_of);
  std::vector<std::vector<std::size_t>> better(answers.size());
  for (std::size_t n = 0; n < answers.size(); ++n) {
    for (std::size_t other = 0; other < answers.size(); ++other) {
      if (beats(merits[other], merits[n])) better[n].push_back(other);
    }
  }
  return better;
}

}  // namespace glisson::planning
