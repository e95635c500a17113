#include "closedloop/fullfield/internal/law_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glisson::closedloop {
namespace {

// Positive numbers are searched by their logarithms.
double for_search(const LawParameter& parameter, double value) { return parameter.lower > 0 ? std::log(value) : value; }

double from_search(const LawParameter& parameter, double x) {
  return std::clamp(parameter.lower > 0 ? std::exp(x) : x, parameter.lower, parameter.upper);
}

// Between the values that are tried, about one of them.
double spacing_of(const LawParameter& parameter, double value) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double other : parameter.tried) {
    const double away = std::abs(for_search(parameter, other) - for_search(parameter, value));
    if (away > 1e-9) nearest = std::min(nearest, away);
  }
  return nearest;
}

// Shape `s` moved while the others stay.
Fitted with_better_shape(Fitted from, Eigen::Index s, double step, const FitOfShapes& fit) {
  const Eigen::Index coefficients = from.law.form->coefficients();
  const LawParameter& parameter = from.law.form->parameters[static_cast<std::size_t>(coefficients + s)];
  const auto at = [&](double x) {
    Eigen::VectorXd shapes = from.law.parameters.tail(from.law.parameters.size() - coefficients);
    shapes[s] = from_search(parameter, x);
    return fit(shapes);
  };
  constexpr int steps = 4;
  for (int k = 0; k < steps; ++k) {
    const double here = for_search(parameter, from.law.parameters[coefficients + s]);
    Fitted before = at(here - step), after = at(here + step);
    const double bend = before.chi2 - 2 * from.chi2 + after.chi2;
    const double minimum = 0.5 * step * (before.chi2 - after.chi2) / bend;
    Fitted lowest = before.chi2 < after.chi2 ? std::move(before) : std::move(after);
    if (bend > 0 && std::abs(minimum) < step) {
      if (Fitted guessed = at(here + minimum); guessed.chi2 < lowest.chi2) lowest = std::move(guessed);
    }
    if (!(lowest.chi2 < from.chi2)) {
      step /= 3;
      continue;
    }
    const bool near = from.chi2 - lowest.chi2 < 1;
    from = std::move(lowest);
    if (near) break;
    step /= 2;
  }
  return from;
}

}  // namespace

std::vector<Eigen::VectorXd> shapes_to_try(const LawForm& form) {
  std::vector<Eigen::VectorXd> all{Eigen::VectorXd()};
  for (std::size_t p = static_cast<std::size_t>(form.coefficients()); p < form.parameters.size(); ++p) {
    std::vector<Eigen::VectorXd> longer;
    for (const Eigen::VectorXd& shorter : all) {
      for (const double value : form.parameters[p].tried) {
        longer.emplace_back(shorter.size() + 1);
        longer.back() << shorter, value;
      }
    }
    all = std::move(longer);
  }
  return all;
}

Fitted with_better_shapes(Fitted from, const FitOfShapes& fit) {
  const LawForm& form = *from.law.form;
  const Eigen::Index coefficients = form.coefficients();
  const Eigen::Index shapes = from.law.parameters.size() - coefficients;
  std::vector<double> steps;
  for (Eigen::Index s = coefficients; s < from.law.parameters.size(); ++s)
    steps.push_back(0.5 * spacing_of(form.parameters[static_cast<std::size_t>(s)], from.law.parameters[s]));
  const int rounds = shapes > 1 ? 3 : 1;  // where one moves the other's best
  for (int round = 0; round < rounds; ++round) {
    for (Eigen::Index s = 0; s < shapes; ++s) {
      double& step = steps[static_cast<std::size_t>(s)];
      from = with_better_shape(std::move(from), s, step, fit);
      step /= 4;
    }
  }
  return from;
}

}  // namespace glisson::closedloop
