#include "closedloop/material/effects.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/units.h"

namespace glisson::closedloop {
namespace {

// What the trials went through.
struct MaterialReach {
  double largest_strain = 0;
  double largest_stress_kPa = 0;  // of the declared order: modulus times strain
  double shortest_s = 0;          // between samples, the median
  double longest_s = 0;           // of a trial
  bool unloads = false;           // strain falls by a tenth of its largest value after its largest value
  bool returns = false;           // ... and rises again
  bool both_sides = false;
};

MaterialReach reach_of(const Material& material);

using MaterialEffects = std::vector<MaterialEffect>;
MaterialEffects effects_within(const Material& material, const MaterialReach& reach);
void add_stiffness(const Material& material, const MaterialReach& reach, MaterialEffects& effects);
void add_stiffening(const Material& material, const MaterialReach& reach, MaterialEffects& effects);
void add_relaxation(const MaterialReach& reach, MaterialEffects& effects);
void add_dissipation(const MaterialReach& reach, MaterialEffects& effects);
void add_load_cell(const Material& material, const MaterialReach& reach, MaterialEffects& effects);

}  // namespace

std::vector<MaterialEffect> material_effects(const Material& material) {
  return effects_within(material, reach_of(material));
}

std::vector<MaterialEffect> known_material_effects(const Material& material) {
  MaterialReach reach = reach_of(material);
  reach.unloads = reach.both_sides = true;
  if (!(reach.longest_s > 0)) reach.longest_s = reach.shortest_s = 1;
  return effects_within(material, reach);
}

namespace {

MaterialEffects effects_within(const Material& material, const MaterialReach& reach) {
  MaterialEffects effects;
  add_stiffness(material, reach, effects);
  add_stiffening(material, reach, effects);
  if (reach.longest_s > 0) add_relaxation(reach, effects);
  if (reach.unloads) add_dissipation(reach, effects);
  add_load_cell(material, reach, effects);
  return effects;
}

MaterialReach reach_of(const Material& material) {
  MaterialReach reach;
  double lowest = 1;
  double highest = 1;
  std::vector<double> steps;
  for (const MaterialTrial& trial : material.trials) {
    if (trial.time_s.size() < 2) continue;
    double largest = 0;
    double after = 0;  // the least strain since the largest
    for (Eigen::Index i = 0; i < trial.time_s.size(); ++i) {
      const double strain = std::abs(trial.stretch[i] - 1);
      lowest = std::min(lowest, trial.stretch[i]);
      highest = std::max(highest, trial.stretch[i]);
      if (strain >= largest) {
        largest = strain;
        after = strain;
      }
      after = std::min(after, strain);
      if (after < 0.9 * largest) reach.unloads = true;
      if (reach.unloads && strain > after + 0.1 * largest) reach.returns = true;
      if (i > 0 && trial.time_s[i] > trial.time_s[i - 1]) steps.push_back(trial.time_s[i] - trial.time_s[i - 1]);
    }
    reach.largest_strain = std::max(reach.largest_strain, largest);
    reach.longest_s = std::max(reach.longest_s, trial.time_s[trial.time_s.size() - 1] - trial.time_s[0]);
  }
  if (!steps.empty()) {
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    reach.shortest_s = steps[steps.size() / 2];
  }
  reach.largest_strain = std::max(reach.largest_strain, 1e-3);
  reach.largest_stress_kPa = material.young_kPa * reach.largest_strain;
  reach.both_sides = lowest < 1 - 0.1 * reach.largest_strain && highest > 1 + 0.1 * reach.largest_strain;
  return reach;
}

void add_stiffness(const Material&, const MaterialReach& reach, MaterialEffects& effects) {
  effects.push_back({{"stiffness-scale",
                      "",
                      {{"factor", 1, 0.02, 50, 0.5, 2, Scale::logarithmic}},
                      GLISSON_TEXT("The specimen is stiffer or softer than declared, everywhere and at every load."),
                      {numbers_of({1.0})}},
                     [](const auto& p, auto& behaviour) { behaviour.young_kPa *= p[0]; }});
  if (!reach.both_sides) return;
  const auto sentence = GLISSON_TEXT("The specimen is not equally stiff under tension and under compression.");
  effects.push_back({{"tension-compression-asymmetry",
                      "tension",
                      {{"ratio", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}},
                      sentence,
                      {numbers_of({1.0})}},
                     [](const auto& p, auto& behaviour) { behaviour.tension_factor = p[0]; }});
  effects.push_back({{"tension-compression-asymmetry",
                      "compression",
                      {{"ratio", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}},
                      sentence,
                      {numbers_of({1.0})}},
                     [](const auto& p, auto& behaviour) { behaviour.compression_factor = p[0]; }});
}

void add_stiffening(const Material& material, const MaterialReach& reach, MaterialEffects& effects) {
  const double strain = reach.largest_strain;
  const auto law = [&](std::string form, ElasticLaw elastic, std::vector<Parameter> parameters,
                       std::vector<Eigen::VectorXd> starts) {
    effects.push_back(
        {{"strain-stiffening", std::move(form), std::move(parameters),
          GLISSON_TEXT(
              "The tissue gets stiffer (or softer) the further it is deformed: its law is not a straight line."),
          std::move(starts)},
         [elastic](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
           behaviour.law = elastic;
           if (p.size() > 0) behaviour.a = p[0];
           if (p.size() > 1) behaviour.b = p[1];
         }});
  };
  // In these shape numbers a law of order 1 / strain doubles the stress at the largest strain.
  const double order = 1 / strain;
  const double order2 = order * order;
  if (material.law == DeclaredLaw::linear) law("neo-hookean", ElasticLaw::neo_hookean, {}, {Eigen::VectorXd()});
  law("quadratic", ElasticLaw::quadratic, {{"a", 0, -0.9 * order, 100 * order, -order, 4 * order}},
      {numbers_of({0.0})});
  law("exponential", ElasticLaw::exponential, {{"a", 0, -10 * order, 10 * order, -2 * order, 4 * order}},
      {numbers_of({0.0})});
  law("mooney-rivlin", ElasticLaw::mooney_rivlin, {{"a", 0, -5, 5, -1, 1}}, {numbers_of({0.0})});
  law("ogden", ElasticLaw::ogden, {{"a", 2, -30, 30, -8, 8}},
      {numbers_of({3.0}), numbers_of({-3.0}), numbers_of({8.0})});
  law("yeoh-2", ElasticLaw::yeoh, {{"a", 0, -0.3 * order2, 100 * order2, -order2, 2 * order2}}, {numbers_of({0.0})});
  law("gent", ElasticLaw::gent, {{"a", 1e4, 1e-2, 1e5, 0.1, 1e3, Scale::logarithmic}},
      {numbers_of({20 * std::max(0.05, strain * strain)}), numbers_of({1000})});
  law("cubic", ElasticLaw::cubic,
      {{"a", 0, -20 * order, 100 * order, -order, 4 * order},
       {"b", 0, -20 * order2, 100 * order2, -order2, 4 * order2}},
      {numbers_of({0.0, 0.0})});
  law("yeoh-3", ElasticLaw::yeoh,
      {{"a", 0, -10 * order2, 100 * order2, -order2, 2 * order2},
       {"b", 0, -10 * order2 * order2, 100 * order2 * order2, -order2 * order2, 2 * order2 * order2}},
      {numbers_of({0.0, 0.0})});
}

void add_relaxation(const MaterialReach& reach, MaterialEffects& effects) {
  const double fast = std::max(reach.shortest_s, 1e-4 * reach.longest_s);
  const double slow = reach.longest_s;
  const Parameter amplitude{"amplitude", 0, 0, 0.98, 0, 0.6};
  const Parameter time{"time_s", std::sqrt(fast * slow), 0.2 * fast, 5 * slow, fast, slow, Scale::logarithmic};
  const auto between = [&](double share) { return fast * std::pow(slow / fast, share); };
  for (int terms = 1; terms <= 3; ++terms) {
    Effect effect{"viscoelastic-creep",
                  terms == 1 ? "" : "prony-" + std::to_string(terms),
                  {},
                  GLISSON_TEXT("The tissue gives way slowly under a load that is held, and recovers slowly after it."),
                  {}};
    for (int i = 0; i < terms; ++i) effect.parameters.push_back(amplitude);
    for (int i = 0; i < terms; ++i) effect.parameters.push_back(time);
    Eigen::VectorXd start(2 * terms);
    start.head(terms).setConstant(0.3 / terms);
    if (terms == 1) {
      for (const double share : {0.25, 0.5, 0.85}) {
        start[1] = between(share);
        effect.starts.push_back(start);
      }
    } else {
      for (int i = 0; i < terms; ++i) start[terms + i] = between((i + 0.7) / terms);
      effect.starts.push_back(start);
    }
    effects.push_back({std::move(effect), [terms](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                         behaviour.prony.clear();
                         for (int i = 0; i < terms; ++i) behaviour.prony.push_back({p[i], p[terms + i]});
                       }});
  }
}

void add_dissipation(const MaterialReach& reach, MaterialEffects& effects) {
  const auto softening_sentence =
      GLISSON_TEXT("Once stretched, the tissue stays softer up to the deformation that it has seen (Mullins effect).");
  const auto softening = [&](std::string form, SofteningLaw law, std::vector<Parameter> parameters,
                             Eigen::VectorXd start) {
    effects.push_back({{"softening", std::move(form), std::move(parameters), softening_sentence, {std::move(start)}},
                       [law](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                         behaviour.softening = law;
                         behaviour.softening_amplitude = p[0];
                         if (p.size() > 1) behaviour.softening_energy_kPa = p[1];
                       }});
  };
  const Parameter amplitude{"amplitude", 0, 0, 0.95, 0, 0.6};
  const double energy = reach.largest_stress_kPa * reach.largest_strain / 2;
  softening("drop", SofteningLaw::drop, {amplitude}, numbers_of({0.1}));
  softening("approach", SofteningLaw::approach, {amplitude}, numbers_of({0.1}));
  softening(
      "ogden-roxburgh", SofteningLaw::ogden_roxburgh,
      {amplitude, {"energy_kPa", energy, 1e-3 * energy, 100 * energy, 0.05 * energy, 2 * energy, Scale::logarithmic}},
      numbers_of({0.2, 0.3 * energy}));

  const auto hysteresis_sentence =
      GLISSON_TEXT("Less force comes back on the way out than went in on the way in, in every cycle and at any speed.");
  const Parameter slip{"slip_strain",        0.1 * reach.largest_strain,  1e-3 * reach.largest_strain,
                       reach.largest_strain, 0.01 * reach.largest_strain, 0.3 * reach.largest_strain,
                       Scale::logarithmic};
  const double begin = 0.05 * reach.largest_strain;
  effects.push_back({{"hysteresis",
                      "proportional",
                      {{"loss", 0, 0, 0.98, 0, 0.6}, slip},
                      hysteresis_sentence,
                      {numbers_of({0.1, begin})}},
                     [](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                       behaviour.hysteresis = HysteresisLaw::proportional;
                       behaviour.loss = p[0];
                       behaviour.slip_strain = p[1];
                     }});
  const double stress = reach.largest_stress_kPa;
  // Friction may be as large as the elastic stress or larger. From far too little of it the slip strain runs away.
  const auto sliding = [&](std::string form, HysteresisLaw law, std::vector<Parameter> shape,
                           const std::vector<double>& begin_of_shape) {
    std::vector<Eigen::VectorXd> starts;
    for (const double share : {0.05, 0.3, 1.0}) {
      for (const double width : {0.02, 0.08}) {
        starts.emplace_back(2 + begin_of_shape.size());
        starts.back().head<2>() << share * stress, width * reach.largest_strain;
        std::copy(begin_of_shape.begin(), begin_of_shape.end(), starts.back().begin() + 2);
      }
    }
    std::vector<Parameter> parameters{{"friction_kPa", 0, 0, 3 * stress, 0, 0.3 * stress}, slip};
    parameters.insert(parameters.end(), shape.begin(), shape.end());
    effects.push_back({{"hysteresis", std::move(form), std::move(parameters), hysteresis_sentence, std::move(starts)},
                       [law](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                         behaviour.hysteresis = law;
                         behaviour.friction_kPa = p[0];
                         behaviour.slip_strain = p[1];
                         if (p.size() > 2) behaviour.dahl_exponent = p[2];
                       }});
  };
  sliding("friction", HysteresisLaw::friction, {}, {});
  sliding("dahl", HysteresisLaw::dahl, {}, {});
  sliding("dahl-tail", HysteresisLaw::dahl, {{"exponent", 1, 0, 3, 0.5, 2.5}}, {2.0});
}

void add_load_cell(const Material& material, const MaterialReach& reach, MaterialEffects& effects) {
  // Where the size of the specimen is known the offset is a force, as the load cell has it.
  const double kPa_of_unit = material.specimen.area_mm2 ? units::mN_from_N(1.0) / *material.specimen.area_mm2 : 1.0;
  const double zero = reach.largest_stress_kPa / kPa_of_unit;
  const Parameter offset{
      material.specimen.area_mm2 ? "zero_N" : "zero_kPa", 0, -2 * zero, 2 * zero, -0.2 * zero, 0.2 * zero};
  const Parameter gain{"gain", 1, 0.1, 10, 0.8, 1.25, Scale::logarithmic};
  const auto sentence =
      GLISSON_TEXT("The load cell is at fault: it does not read zero without load, or its scale is off.");
  effects.push_back({{"preload",
                      "",
                      {{"pressure_kPa", 0, -2 * reach.largest_stress_kPa, 2 * reach.largest_stress_kPa,
                        -0.2 * reach.largest_stress_kPa, 0.2 * reach.largest_stress_kPa}},
                      GLISSON_TEXT("The specimen was already loaded when the test began."),
                      {numbers_of({0.0})}},
                     [](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) { behaviour.preload_kPa = p[0]; }});
  effects.push_back({{"force-bias", "zero", {offset}, sentence, {numbers_of({0.0})}},
                     [kPa_of_unit](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                       behaviour.zero_kPa = p[0] * kPa_of_unit;
                     }});
  effects.push_back({{"force-bias", "gain", {gain}, sentence, {numbers_of({1.0})}},
                     [](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) { behaviour.gain = p[0]; }});
  effects.push_back({{"force-bias", "", {offset, gain}, sentence, {numbers_of({0.0, 1.0})}},
                     [kPa_of_unit](const Eigen::VectorXd& p, MaterialBehaviour& behaviour) {
                       behaviour.zero_kPa = p[0] * kPa_of_unit;
                       behaviour.gain = p[1];
                     }});
}

}  // namespace
}  // namespace glisson::closedloop
