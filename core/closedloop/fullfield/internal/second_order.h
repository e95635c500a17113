#pragma once
// A number with its first and second derivatives by two variables, carried through arithmetic: strain energies are
// written as formulas and differentiate themselves. (Forward-mode automatic differentiation; Griewank and Walther,
// Evaluating Derivatives (2008), ch. 13.)

#include <cmath>

namespace glisson::closedloop {

struct SecondOrder {
  double value = 0;
  double x = 0, y = 0;            // first derivatives
  double xx = 0, xy = 0, yy = 0;  // second ones

  SecondOrder() = default;
  SecondOrder(double constant) : value(constant) {}  // NOLINT: numbers mix with variables in formulas
  SecondOrder(double v, double dx, double dy) : value(v), x(dx), y(dy) {}

  // g(this), with g's value, slope and curvature here.
  [[nodiscard]] SecondOrder through(double g, double slope, double curvature) const {
    SecondOrder result(g, slope * x, slope * y);
    result.xx = slope * xx + curvature * x * x;
    result.xy = slope * xy + curvature * x * y;
    result.yy = slope * yy + curvature * y * y;
    return result;
  }
};

inline SecondOrder operator+(const SecondOrder& a, const SecondOrder& b) {
  SecondOrder sum(a.value + b.value, a.x + b.x, a.y + b.y);
  sum.xx = a.xx + b.xx;
  sum.xy = a.xy + b.xy;
  sum.yy = a.yy + b.yy;
  return sum;
}

inline SecondOrder operator*(const SecondOrder& a, const SecondOrder& b) {
  SecondOrder product(a.value * b.value, a.value * b.x + b.value * a.x, a.value * b.y + b.value * a.y);
  product.xx = a.value * b.xx + 2 * a.x * b.x + b.value * a.xx;
  product.xy = a.value * b.xy + a.x * b.y + a.y * b.x + b.value * a.xy;
  product.yy = a.value * b.yy + 2 * a.y * b.y + b.value * a.yy;
  return product;
}

inline SecondOrder operator-(const SecondOrder& a, const SecondOrder& b) { return a + SecondOrder(-1.0) * b; }

inline SecondOrder pow(const SecondOrder& a, double exponent) {
  const double power = std::pow(a.value, exponent - 2);
  return a.through(power * a.value * a.value, exponent * power * a.value, exponent * (exponent - 1) * power);
}
inline SecondOrder log(const SecondOrder& a) {
  return a.through(std::log(a.value), 1 / a.value, -1 / (a.value * a.value));
}
inline SecondOrder exp(const SecondOrder& a) {
  const double value = std::exp(a.value);
  return a.through(value, value, value);
}
inline SecondOrder sqrt(const SecondOrder& a) { return pow(a, 0.5); }
inline SecondOrder square(const SecondOrder& a) { return a * a; }

}  // namespace glisson::closedloop
