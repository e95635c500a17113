#pragma once
// How a small specimen in a testing machine answers a prescribed stretch: an elastic law, and what may act on it. Every
// member stands at "does not act" until an effect (effects.h) changes it.

#include <Eigen/Core>
#include <vector>

#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

// Nominal stress for stretch l, E the modulus at rest, e = l - 1, I = l^2 + 2/l (uniaxial, incompressible):
//   linear        E e                                      neo_hookean  E/3 (l - l^-2)
//   quadratic     E e (1 + a |e|)                          cubic        E e (1 + a |e| + b e^2)
//   exponential   E sign(e) (exp(a |e|) - 1) / a           (Fung's law in one dimension)
//   yeoh          E/3 (l - l^-2) (1 + a (I - 3) + b (I - 3)^2)
//   ogden         2 E / (3 a) (l^(a-1) - l^(-a/2-1))       mooney_rivlin  E/3 (l - l^-2) ((1 - a) + a / l)
//   gent          E/3 (l - l^-2) / (1 - (I - 3) / a)
// In simple shear by g = l - 1: E/3 in place of E and e = g for the laws in e; I - 3 = g^2 and E/3 g in place of E/3
// (l - l^-2) for the others. There ogden and mooney_rivlin are what neo_hookean is. Holzapfel, Nonlinear Solid
// Mechanics (2000), ch. 6; Ogden, Non-linear Elastic Deformations (1984), ch. 7.
enum class ElasticLaw { linear, neo_hookean, quadratic, cubic, exponential, yeoh, ogden, mooney_rivlin, gent };

struct PronyTerm {
  double amplitude = 0;  // share of the instantaneous stress that relaxes
  double time_s = 1;
};

// Below the largest strain so far the stress is less than on the first loading (Mullins). W is the elastic energy:
//   drop            1 - a                                  approach        1 - a (1 - |e| / |e|max)
//   ogden_roxburgh  1 - a erf((Wmax - W) / m)              (Ogden and Roxburgh 1999, with beta = 0)
enum class SofteningLaw { none, drop, approach, ogden_roxburgh };

// A slider follows the strain within `slip_strain`, f from -1 (unloading) to 1 (loading):
//   proportional    the stress times 1 - loss (1 - f) / 2     friction     the stress plus `friction_kPa` times f
//   dahl            as friction, f approaching its limits gradually: what is missing of the limit ahead, w = 1 -+ f,
//                   falls by dw = -w^n |de| / slip_strain, n the exponent (Dahl 1968): 1 an exponential, 0 the slider
//                   above, more than 1 a long tail, as joints with contacts of many sizes have it
enum class HysteresisLaw { none, proportional, friction, dahl };

struct MaterialBehaviour {
  Mode mode = Mode::compression;
  double young_kPa = 0;
  ElasticLaw law = ElasticLaw::linear;
  double a = 0;
  double b = 0;
  double tension_factor = 1;
  double compression_factor = 1;
  std::vector<PronyTerm> prony;
  SofteningLaw softening = SofteningLaw::none;
  double softening_amplitude = 0;
  double softening_energy_kPa = 1;  // m
  HysteresisLaw hysteresis = HysteresisLaw::none;
  double loss = 0;
  double friction_kPa = 0;
  double slip_strain = 0.01;
  double dahl_exponent = 1;
  double preload_kPa = 0;  // stress that is there when stretch is 1
  double zero_kPa = 0;     // what the load cell reads without load
  double gain = 1;         // of the load cell
};

[[nodiscard]] double elastic_stress_kPa(const MaterialBehaviour& behaviour, double stretch);

// What the machine reads at each time. Relaxation acts on the elastic stress with its softening and hysteresis (Fung's
// quasi-linear viscoelasticity). Stress changes linearly between samples. What is there at the first sample came at
// once. Not finite where a law is used beyond its range (gent beyond its locking stretch).
[[nodiscard]] Eigen::VectorXd reading_kPa(const MaterialBehaviour& behaviour, const Eigen::VectorXd& time_s,
                                          const Eigen::VectorXd& stretch);

}  // namespace glisson::closedloop
