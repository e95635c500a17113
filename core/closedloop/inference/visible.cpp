#include "closedloop/inference/visible.h"

#include <fmt/format.h>
#include <algorithm>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "base/parallel.h"

namespace glisson::closedloop {
namespace {

// One parameter of an effect, moved away from where it does nothing.
struct Switch {
  const Effect* effect = nullptr;
  Eigen::Index parameter = 0;
};

class Visibility {
 public:
  Visibility(const ForwardModel& model, const SystematicUncertainty& systematic, const Whitening& whitening,
             const DiagnosisOptions& options, Eigen::VectorXd declared)
      : model_(model),
        systematic_(systematic),
        whitening_(whitening),
        options_(options),
        declared_(std::move(declared)) {}

  [[nodiscard]] bool does_nothing_at_rest(const Effect& effect) const;
  [[nodiscard]] std::optional<SmallestVisible> of(const Switch& which) const;

 private:
  // What the effect changes where its parameter is moved by `way`, and whether that would be found.
  struct Seen {
    double square = 0;  // of the whitened change
    double plain = 0;   // root mean square in noises
    Eigen::Index rows = 0;
    [[nodiscard]] bool acts() const { return square > 1e-12; }
  };
  [[nodiscard]] std::optional<Seen> seen(const Switch& which, double way) const;
  // ... if it were so many times as large.
  [[nodiscard]] double probability(const Seen& seen, double times, Eigen::Index parameters) const;
  [[nodiscard]] double times_to_be_found(const Seen& seen, Eigen::Index parameters) const;

  const ForwardModel& model_;
  const SystematicUncertainty& systematic_;
  const Whitening& whitening_;
  const DiagnosisOptions& options_;
  Eigen::VectorXd declared_;
};

Eigen::VectorXd at_rest(const Effect& effect);
double value_at(const Parameter& parameter, double way);
double longest_way(const Parameter& parameter);
int component_of(const Effect& effect, Eigen::Index parameter);

}  // namespace

Result<std::vector<SmallestVisible>> smallest_visible(const ForwardModel& model,
                                                      const SystematicUncertainty& systematic,
                                                      const Whitening& whitening, const DiagnosisOptions& options,
                                                      const Progress& progress) {
  auto declared = model.predict({});
  if (!declared) return failure(std::move(declared.error()));
  const Visibility visibility(model, systematic, whitening, options, *std::move(declared));
  std::vector<Switch> switches;
  for (const Effect& effect : model.catalogue()) {
    if (effect.late || !visibility.does_nothing_at_rest(effect)) continue;
    for (Eigen::Index p = 0; p < effect.size(); ++p) switches.push_back({&effect, p});
  }
  std::vector<std::optional<SmallestVisible>> found(switches.size());
  parallel_for(switches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) found[i] = visibility.of(switches[i]);
  });
  if (progress.cancelled()) return cancelled();
  std::vector<SmallestVisible> result;
  std::set<std::pair<std::string, std::string>> known;  // kind and parameter: the first form tells
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    const bool same_effect =
        !result.empty() && result.back().kind == found[i]->kind && result.back().form == found[i]->form;
    if (known.insert({found[i]->kind, found[i]->parameter}).second ||
        (same_effect && result.back().parameter == found[i]->parameter))
      result.push_back(*std::move(found[i]));
  }
  return result;
}

std::string visible_sentence(const Explanation& explanation) {
  if (explanation.smallest_visible.empty()) return "";
  std::string text =
      fmt::format("Would have been seen in {:.0f} of 100 such experiments:", 100 * VisibleOptions{}.power);
  const char* between = " ";
  for (const SmallestVisible& one : explanation.smallest_visible) {
    const std::string name = one.parameter + (one.component > 0 ? fmt::format(" {}", one.component) : std::string());
    text += between + fmt::format("{} ({})", one.kind, name) +
            (one.value ? fmt::format(" from {:.3g}", *one.value) : std::string(" at no size in its range"));
    between = "; ";
  }
  return text + ".";
}

namespace {

// A law whose parameters cannot undo it (neo-Hookean beside a straight line) is no matter of size.
bool Visibility::does_nothing_at_rest(const Effect& effect) const {
  if (effect.size() == 0) return false;
  const auto predicted = model_.predict({{effect.kind, effect.form, at_rest(effect)}});
  constexpr double nothing = 0.01;  // of chi-squared: far below what any test would see
  return predicted && whitening_.whiten(*predicted - declared_).squaredNorm() < nothing;
}

// The first way is a small part of what a surgeon would expect. From each the next is guessed as if the change grew in
// proportion, which is right where effects are small, and kept between the ways that are known to be too short and long
// enough.
std::optional<SmallestVisible> Visibility::of(const Switch& which) const {
  const Parameter& parameter = which.effect->parameters[static_cast<std::size_t>(which.parameter)];
  SmallestVisible visible{which.effect->kind,  which.effect->form,
                          parameter.name,      component_of(*which.effect, which.parameter),
                          parameter.no_effect, {}};
  const double longest = longest_way(parameter);
  if (longest == 0) return std::nullopt;
  const VisibleOptions& options = options_.visible;
  const int tries = model_.predicts_quickly() ? options.tries_where_quick : options.tries;
  double too_short = 0, long_enough = longest;
  double way = longest > 0 ? std::min(longest, options.first_way) : std::max(longest, -options.first_way);
  bool acts_somewhere = false;
  // Few tries are for the last few percent: whether there is such a size at all is always looked into.
  for (int i = 0; i < tries || (!visible.value && i < options.tries_where_quick); ++i) {
    const auto there = seen(which, way);
    if (!there) {  // has no solution there: less far
      long_enough = way;
      way = (too_short + way) / 2;
      continue;
    }
    acts_somewhere = acts_somewhere || there->acts();
    if (probability(*there, 1, which.effect->size()) >= options.power) {
      long_enough = way;
      visible.value = value_at(parameter, way);
    } else {
      too_short = way;
      if (way == longest) break;
    }
    const double guess = there->acts() ? way * times_to_be_found(*there, which.effect->size()) : 4 * way;
    if (std::abs(guess / way - 1) < options.close_enough) {
      visible.value = value_at(parameter, guess);
      break;
    }
    const bool inside = std::abs(guess) > std::abs(too_short) && std::abs(guess) < std::abs(long_enough);
    way = inside ? guess : visible.value ? (too_short + long_enough) / 2 : longest;
  }
  if (!acts_somewhere) return std::nullopt;  // a shape, which does nothing alone
  return visible;
}

std::optional<Visibility::Seen> Visibility::seen(const Switch& which, double way) const {
  const Parameter& parameter = which.effect->parameters[static_cast<std::size_t>(which.parameter)];
  Eigen::VectorXd values = at_rest(*which.effect);
  values[which.parameter] = value_at(parameter, way);
  const auto predicted = model_.predict({{which.effect->kind, which.effect->form, values}});
  if (!predicted) return std::nullopt;
  const Eigen::VectorXd change = *predicted - declared_;
  return Seen{whitening_.whiten(change).squaredNorm(),
              change.cwiseQuotient(model_.observations().noise).norm() / std::sqrt(static_cast<double>(change.size())),
              change.size()};
}

// Chi-squared must fall by enough for BIC, which is about what it takes to be more probable than nothing. And what is
// left must exceed the prediction's own error, where there is one.
double Visibility::probability(const Seen& seen, double times, Eigen::Index parameters) const {
  using boost::math::cdf, boost::math::complement;
  if (!seen.acts()) return 0;
  const auto rows = static_cast<double>(seen.rows), count = static_cast<double>(parameters);
  const auto beyond = [](double degrees, double noncentrality, double limit) {
    if (noncentrality > 20 * limit) return 1.0;
    return cdf(complement(boost::math::non_central_chi_squared(degrees, std::max(noncentrality, 1e-12)), limit));
  };
  const double entry = beyond(count, times * times * seen.square, options_.entry_bic + count * std::log(rows));
  if (systematic_.indistinct == 0) return entry;
  const double excess = beyond(rows, rows * times * times * seen.plain * seen.plain,
                               rows * (1 + systematic_.indistinct * systematic_.indistinct));
  return std::min(entry, excess);
}

// Fisher's information of one parameter is the square of the change over its way: as long as the change is in
// proportion to the way, this says how long a way it takes.
double Visibility::times_to_be_found(const Seen& seen, Eigen::Index parameters) const {
  const double power = options_.visible.power;
  double low = 0, high = 1;
  constexpr double enough = 1e9;  // times its own size: beyond, it cannot be found
  while (probability(seen, high, parameters) < power && high < enough) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (probability(seen, middle, parameters) < power ? low : high) = middle;
  }
  return high;
}

Eigen::VectorXd at_rest(const Effect& effect) {
  Eigen::VectorXd values(effect.size());
  for (Eigen::Index p = 0; p < values.size(); ++p) values[p] = effect.parameters[static_cast<std::size_t>(p)].no_effect;
  return values;
}

// A way is counted in widths of the range that a surgeon would expect, over logarithms of logarithmic parameters.
struct Line {
  double none, width, lower, upper;
};
Line line_of(const Parameter& parameter) {
  const auto scaled = [&](double x) { return parameter.scale == Scale::logarithmic ? std::log(x) : x; };
  return {scaled(parameter.no_effect), scaled(parameter.prior_high) - scaled(parameter.prior_low),
          scaled(parameter.lower), scaled(parameter.upper)};
}

double value_at(const Parameter& parameter, double way) {
  const Line line = line_of(parameter);
  const double x = line.none + way * line.width;
  return std::clamp(parameter.scale == Scale::logarithmic ? std::exp(x) : x, parameter.lower, parameter.upper);
}

// Towards the side on which more of it is expected; with its sign; 0 where there is none.
double longest_way(const Parameter& parameter) {
  if (parameter.scale == Scale::logarithmic && !(parameter.no_effect > 0)) return 0;
  const Line line = line_of(parameter);
  const double above = parameter.prior_high - parameter.no_effect, below = parameter.no_effect - parameter.prior_low;
  const bool up = (above >= below && line.upper > line.none) || line.lower >= line.none;
  return ((up ? line.upper : line.lower) - line.none) / line.width;
}

// Of a vector, from 1; 0 for a number.
int component_of(const Effect& effect, Eigen::Index parameter) {
  const std::string& name = effect.parameters[static_cast<std::size_t>(parameter)].name;
  int component = 1;
  for (Eigen::Index p = parameter; p > 0 && effect.parameters[static_cast<std::size_t>(p - 1)].name == name; --p)
    ++component;
  const bool more =
      parameter + 1 < effect.size() && effect.parameters[static_cast<std::size_t>(parameter + 1)].name == name;
  return component > 1 || more ? component : 0;
}

}  // namespace
}  // namespace glisson::closedloop
