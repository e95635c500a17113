#include "planning/growth.h"

#include <fmt/format.h>
#include <cmath>

namespace glisson::planning {
namespace {

// What a part's volumes are shares of.
struct Whole {
  double before_ml, after_ml;
};

PartGrowth part_of(const Tissue& before, const Tissue& after, const Whole& whole,
                   const std::optional<double>& error_percent = {}) {
  const auto share = [](double ml, double whole_ml) { return whole_ml > 0 ? 100 * ml / whole_ml : 0; };
  PartGrowth part{before, after, share(before.ml, whole.before_ml), share(after.ml, whole.after_ml), false};
  const auto change = part.change_percent();
  part.within_error = change && error_percent && std::abs(*change) <= *error_percent;
  return part;
}

// NaN is not more than 0 either.
Result<void> check(const std::optional<double>& value, const char* code, const char* sentence) {
  if (!value || (*value > 0 && std::isfinite(*value))) return {};
  return failure(code, sentence, {fmt::format("{}", *value)});
}

}  // namespace

std::optional<double> PartGrowth::change_percent() const {
  if (before.ml <= 0) return std::nullopt;
  return 100 * change_ml() / before.ml;
}

Result<Growth> growth_between(const Planner& before, const Planner& after, const std::optional<RemnantCuts>& remnant,
                              const GrowthOptions& options) {
  auto good = check(options.days, "growth-days",
                    GLISSON_TEXT("{0} days between the studies: the second must be later than the first."))
                  .and_then([&] {
                    return check(options.standard_liver_ml, "growth-standard-volume",
                                 GLISSON_TEXT("A standard liver volume of {0} ml is not more than 0."));
                  });
  if (!good) return failure(std::move(good.error()));

  const auto segments_before = before.segments(), segments_after = after.segments();
  const Whole whole{options.standard_liver_ml.value_or(segments_before[0].ml),
                    options.standard_liver_ml.value_or(segments_after[0].ml)};
  Growth growth;
  growth.liver = part_of(segments_before[0], segments_after[0], whole);
  growth.tumours_before_ml = before.tumours_ml();
  growth.tumours_after_ml = after.tumours_ml();
  for (std::size_t s = 1; s < segments_before.size(); ++s) {
    if (segments_before[s].ml <= 0 && segments_after[s].ml <= 0) continue;
    growth.segments.push_back(
        {static_cast<int>(s), part_of(segments_before[s], segments_after[s], whole, options.segment_error_percent)});
  }
  if (!remnant) return growth;
  const auto left_before = before.answer(remnant->before);
  if (!left_before) return failure(left_before.error());
  const auto left_after = after.answer(remnant->after);
  if (!left_after) return failure(left_after.error());
  growth.remnant =
      RemnantGrowth{part_of(left_before->left, left_after->left, whole, options.remnant_error_percent), std::nullopt};
  constexpr double days_of_week = 7;
  if (options.days) {
    growth.remnant->points_per_week = growth.remnant->hypertrophy_points() / (*options.days / days_of_week);
  }
  return growth;
}

}  // namespace glisson::planning
