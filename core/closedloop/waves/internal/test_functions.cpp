#include "closedloop/waves/internal/test_functions.h"

#include <algorithm>
#include <cmath>

#include "base/result.h"

namespace glisson::closedloop {
namespace {

// (1 - x^2)^8: of lower powers the third derivative is too rough for sums over voxels to be integrals.
constexpr int bump_power = 8;

// Coefficients of the bump's `order`-th derivative, by power of x.
Eigen::VectorXd bump_polynomial(int order) {
  Eigen::VectorXd polynomial = Eigen::VectorXd::Ones(1);
  for (int p = 0; p < bump_power; ++p) {
    Eigen::VectorXd next = Eigen::VectorXd::Zero(polynomial.size() + 2);
    next.head(polynomial.size()) += polynomial;
    next.tail(polynomial.size()) -= polynomial;
    polynomial = next;
  }
  for (int d = 0; d < order; ++d) {
    Eigen::VectorXd next(polynomial.size() - 1);
    for (Eigen::Index k = 0; k < next.size(); ++k) next[k] = static_cast<double>(k + 1) * polynomial[k + 1];
    polynomial = next;
  }
  return polynomial;
}

double evaluated(const Eigen::VectorXd& polynomial, double x) {
  double value = 0;
  for (Eigen::Index k = polynomial.size() - 1; k >= 0; --k) value = value * x + polynomial[k];
  return value;
}

}  // namespace

const std::array<Derivative, moments_of_a_component>& derivatives() {
  static const auto all = [] {
    std::array<Derivative, moments_of_a_component> list{};
    std::size_t at = 0;
    for (int order = 0; order <= 3; ++order) {
      for (int x = order; x >= 0; --x) {
        for (int y = order - x; y >= 0; --y) list.at(at++) = {x, y, order - x - y};
      }
    }
    return list;
  }();
  return all;
}

int place_of(const Derivative& derivative) {
  const auto& all = derivatives();
  const auto found = std::find(all.begin(), all.end(), derivative);
  GLISSON_ASSERT(found != all.end());
  return static_cast<int>(found - all.begin());
}

Derivative plus(Derivative derivative, int axis) {
  ++derivative.at(static_cast<std::size_t>(axis));
  return derivative;
}

TestFunctions::TestFunctions(const std::array<int, 3>& radius, const Eigen::Vector3d& spacing_mm) : radius_(radius) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int reach_here = reach(static_cast<int>(axis));
    for (int order = 0; order < 4; ++order) {
      Eigen::VectorXd& values = factors_.at(axis).at(static_cast<std::size_t>(order));
      if (radius.at(axis) == 0) {
        values = Eigen::VectorXd::Constant(1, order == 0 ? 1 : 0);
        continue;
      }
      const double half_mm = radius.at(axis) * spacing_mm[static_cast<Eigen::Index>(axis)];
      const Eigen::VectorXd polynomial = bump_polynomial(order);
      values.resize(2 * reach_here + 1);
      for (int offset = -reach_here; offset <= reach_here; ++offset)
        values[offset + reach_here] =
            evaluated(polynomial, static_cast<double>(offset) / radius.at(axis)) / std::pow(half_mm, order);
    }
  }
  gram_.resize(moments_of_a_component, moments_of_a_component);
  for (int a = 0; a < moments_of_a_component; ++a) {
    for (int b = 0; b < moments_of_a_component; ++b) {
      double product = 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto order = [&](int of) {
          return static_cast<std::size_t>(derivatives().at(static_cast<std::size_t>(of)).at(axis));
        };
        product *= factors_.at(axis).at(order(a)).dot(factors_.at(axis).at(order(b)));
      }
      gram_(a, b) = product;
    }
  }
}

int TestFunctions::reach(int axis) const { return std::max(0, radius_.at(static_cast<std::size_t>(axis)) - 1); }

double TestFunctions::factor(int axis, int order, int offset) const {
  return factors_.at(static_cast<std::size_t>(axis)).at(static_cast<std::size_t>(order))[offset + reach(axis)];
}

double TestFunctions::value(const Derivative& derivative, const std::array<int, 3>& offset) const {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    product *= factor(axis, derivative.at(a), offset.at(a));
  }
  return product;
}

}  // namespace glisson::closedloop
