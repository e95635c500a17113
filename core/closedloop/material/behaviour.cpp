#include "closedloop/material/behaviour.h"

#include <algorithm>
#include <cmath>

namespace glisson::closedloop {
namespace {

// (exp(x) - 1) / x, also for small x.
double growth(double x) { return std::abs(x) < 1e-8 ? 1 + x / 2 : std::expm1(x) / x; }

double law_in_strain(const MaterialBehaviour& behaviour, double modulus_kPa, double strain) {
  const double size = std::abs(strain);
  switch (behaviour.law) {
    case ElasticLaw::quadratic: return modulus_kPa * strain * (1 + behaviour.a * size);
    case ElasticLaw::cubic: return modulus_kPa * strain * (1 + behaviour.a * size + behaviour.b * size * size);
    case ElasticLaw::exponential: return modulus_kPa * strain * growth(behaviour.a * size);
    default: return modulus_kPa * strain;
  }
}

// `excess` is I - 3, `base` the neo-Hookean stress over G = E / 3.
double law_in_invariant(const MaterialBehaviour& behaviour, double shear_kPa, double base, double excess) {
  switch (behaviour.law) {
    case ElasticLaw::yeoh: return shear_kPa * base * (1 + behaviour.a * excess + behaviour.b * excess * excess);
    case ElasticLaw::gent: return shear_kPa * base / std::max(1e-6, 1 - excess / behaviour.a);
    default: return shear_kPa * base;
  }
}

bool in_strain(ElasticLaw law) {
  return law == ElasticLaw::linear || law == ElasticLaw::quadratic || law == ElasticLaw::cubic ||
         law == ElasticLaw::exponential;
}

// Work from rest to a stretch, a volume of specimen: Simpson's rule, exact for the laws up to cubic.
double elastic_energy_kPa(const MaterialBehaviour& behaviour, double stretch) {
  constexpr int intervals = 8;
  const double step = (stretch - 1) / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * elastic_stress_kPa(behaviour, 1 + i * step);
  }
  return sum * step / 3;
}

// Remembers the largest strain so far.
class Softening {
 public:
  explicit Softening(const MaterialBehaviour& behaviour) : behaviour_(behaviour) {}

  double factor(double stretch) {
    if (behaviour_.softening == SofteningLaw::none) return 1;
    const double size = std::abs(stretch - 1);
    const double energy =
        behaviour_.softening == SofteningLaw::ogden_roxburgh ? elastic_energy_kPa(behaviour_, stretch) : 0;
    const bool virgin = size >= largest_;
    largest_ = std::max(largest_, size);
    largest_energy_kPa_ = std::max(largest_energy_kPa_, energy);
    if (virgin) return 1;
    switch (behaviour_.softening) {
      case SofteningLaw::drop: return 1 - behaviour_.softening_amplitude;
      case SofteningLaw::approach: return 1 - behaviour_.softening_amplitude * (1 - size / largest_);
      default:
        return 1 - behaviour_.softening_amplitude *
                       std::erf((largest_energy_kPa_ - energy) / behaviour_.softening_energy_kPa);
    }
  }

 private:
  const MaterialBehaviour& behaviour_;
  double largest_ = 0;
  double largest_energy_kPa_ = 0;
};

// A slider between -1 and 1 that the strain drags along.
class Slider {
 public:
  Slider(double slip_strain, double begin) : slip_strain_(slip_strain), at_(begin) {}

  double follow(double strain) {
    at_ = std::clamp(at_ + (strain - strain_) / slip_strain_, -1.0, 1.0);
    strain_ = strain;
    return at_;
  }

  // Dahl's law in closed form over the step.
  double approach(double strain, double exponent) {
    const double limit = strain > strain_ ? 1 : -1;
    const double way = std::abs(strain - strain_) / slip_strain_;
    double missing = 1 - at_ * limit;
    if (std::abs(exponent - 1) < 1e-6) {
      missing *= std::exp(-way);
    } else if (missing > 0) {
      const double power = std::pow(missing, 1 - exponent) + (exponent - 1) * way;
      missing = power > 0 ? std::pow(power, 1 / (1 - exponent)) : 0;
    }
    at_ = limit * (1 - missing);
    strain_ = strain;
    return at_;
  }

 private:
  double slip_strain_;
  double at_;
  double strain_ = 0;
};

}  // namespace

double elastic_stress_kPa(const MaterialBehaviour& behaviour, double stretch) {
  const double factor = stretch > 1 ? behaviour.tension_factor : behaviour.compression_factor;
  const double young_kPa = factor * behaviour.young_kPa;
  const double strain = stretch - 1;
  const double shear_kPa = young_kPa / 3;
  if (behaviour.mode == Mode::shear) {
    return in_strain(behaviour.law) ? law_in_strain(behaviour, shear_kPa, strain)
                                    : law_in_invariant(behaviour, shear_kPa, strain, strain * strain);
  }
  if (in_strain(behaviour.law)) return law_in_strain(behaviour, young_kPa, strain);
  if (behaviour.law == ElasticLaw::ogden) {
    const double a = std::abs(behaviour.a) < 1e-6 ? 1e-6 : behaviour.a;
    return 2 * shear_kPa / a * (std::pow(stretch, a - 1) - std::pow(stretch, -a / 2 - 1));
  }
  const double base = stretch - 1 / (stretch * stretch);
  if (behaviour.law == ElasticLaw::mooney_rivlin) return shear_kPa * base * ((1 - behaviour.a) + behaviour.a / stretch);
  return law_in_invariant(behaviour, shear_kPa, base, stretch * stretch + 2 / stretch - 3);
}

Eigen::VectorXd reading_kPa(const MaterialBehaviour& behaviour, const Eigen::VectorXd& time_s,
                            const Eigen::VectorXd& stretch) {
  Eigen::VectorXd reading(time_s.size());
  Softening softening(behaviour);
  Slider of_size(behaviour.slip_strain, 1);
  Slider of_strain(behaviour.slip_strain, 0);
  std::vector<double> relaxing(behaviour.prony.size(), 0.0);  // the part of each term that has not relaxed yet
  double elastic_before = 0;
  for (Eigen::Index i = 0; i < time_s.size(); ++i) {
    const double strain = stretch[i] - 1;
    double elastic = elastic_stress_kPa(behaviour, stretch[i]) * softening.factor(stretch[i]);
    if (behaviour.hysteresis == HysteresisLaw::proportional)
      elastic *= 1 - behaviour.loss * (1 - of_size.follow(std::abs(strain))) / 2;
    if (behaviour.hysteresis == HysteresisLaw::friction) elastic += behaviour.friction_kPa * of_strain.follow(strain);
    if (behaviour.hysteresis == HysteresisLaw::dahl)
      elastic += behaviour.friction_kPa * of_strain.approach(strain, behaviour.dahl_exponent);

    double stress = elastic;
    const double passed_s = i == 0 ? 0 : time_s[i] - time_s[i - 1];
    for (std::size_t term = 0; term < relaxing.size(); ++term) {
      const auto& [amplitude, constant_s] = behaviour.prony[term];
      const double x = passed_s / constant_s;
      // dh/dt = d(elastic)/dt - h / tau, the elastic stress changing linearly.
      relaxing[term] = relaxing[term] * std::exp(-x) + (elastic - elastic_before) * growth(-x);
      stress += amplitude * (relaxing[term] - elastic);
    }
    elastic_before = elastic;
    reading[i] = behaviour.gain * (stress + behaviour.preload_kPa) + behaviour.zero_kPa;
  }
  return reading;
}

}  // namespace glisson::closedloop
