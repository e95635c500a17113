#pragma once
// The numbers in which a law's energy is not linear: where a search for them begins, and how it goes on. Each set of
// them has its coefficients by least squares.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "closedloop/fullfield/laws.h"

namespace glisson::closedloop {

// A law with its coefficients by least squares about a state.
struct Fitted {
  PlaneLaw law;
  double chi2 = std::numeric_limits<double>::infinity();
  double bic = std::numeric_limits<double>::infinity();
};

// All combinations of what its shapes' lists hold.
[[nodiscard]] std::vector<Eigen::VectorXd> shapes_to_try(const LawForm& form);

// Between what was tried a law may fit far better. One shape after the other, a parabola through three places leads to
// its minimum, until chi-squared falls by less than 1. (Brent 1973, ch. 5, without the golden sections: a step that
// gains nothing is divided by three.)
using FitOfShapes = std::function<Fitted(const Eigen::VectorXd& shapes)>;
[[nodiscard]] Fitted with_better_shapes(Fitted from, const FitOfShapes& fit);

}  // namespace glisson::closedloop
