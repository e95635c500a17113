#pragma once
// What every effect of a forward model must do, and how it is found from what it did.

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <stdexcept>
#include <string>

#include "closedloop/experiment/forward_model.h"
#include "closedloop/palpation/internal/effects.h"

namespace glisson::closedloop::test {

inline const Effect& effect_named(const ForwardModel& model, const std::string& kind, const std::string& form = "") {
  for (const Effect& effect : model.catalogue()) {
    if (effect.kind == kind && (form.empty() || effect.form == form)) return effect;
  }
  throw std::runtime_error("no effect " + kind);
}

inline Setting setting(const ForwardModel& model, const std::string& kind, const std::string& form,
                       std::initializer_list<double> values) {
  const Effect& effect = effect_named(model, kind, form);
  return {effect.kind, effect.form,
          Eigen::Map<const Eigen::VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()))};
}

inline std::string name_of(const Setting& one) { return one.kind + " " + one.form; }

inline void expect_nothing_at_default(const ForwardModel& model) {
  const Eigen::VectorXd declared = model.predict({}).value();
  ASSERT_GT(declared.cwiseAbs().maxCoeff(), 1.0);
  for (const Effect& effect : model.catalogue()) {
    Setting off{effect.kind, effect.form, Eigen::VectorXd(effect.size())};
    for (Eigen::Index p = 0; p < effect.size(); ++p) off.parameters[p] = effect.parameters[std::size_t(p)].no_effect;
    EXPECT_LT((model.predict({off}).value() - declared).cwiseAbs().maxCoeff(), 1e-10) << name_of(off);
  }
}

// Central differences of the whole prediction are the slow judge. They err by about 1e-6 of the largest derivative, the
// solver's rounding over the step; with stiffening by 1e-2, for equilibria are found to 1e-6 of their load and slopes
// to 1e-3 of themselves, which is all that a search needs.
inline void expect_exact_derivatives(const ForwardModel& model, const Settings& settings, const std::string& name) {
  const bool iterates = std::any_of(settings.begin(), settings.end(),
                                    [](const Setting& one) { return one.kind == palpation::strain_stiffening; });
  const double tolerance = iterates ? 1e-2 : 1e-5;
  const auto linear = model.linearise(settings).value();
  EXPECT_LT((linear.predicted - model.predict(settings).value()).cwiseAbs().maxCoeff(), 1e-9) << name;
  Eigen::Index column = 0;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    for (Eigen::Index p = 0; p < settings[s].parameters.size(); ++p, ++column) {
      const double step = (iterates ? 1e-2 : 1e-4) * std::max(0.1, std::abs(settings[s].parameters[p]));
      Settings ahead = settings, behind = settings;
      ahead[s].parameters[p] += step;
      behind[s].parameters[p] -= step;
      const Eigen::VectorXd difference = (model.predict(ahead).value() - model.predict(behind).value()) / (2 * step);
      const double scale = std::max(1e-6, difference.cwiseAbs().maxCoeff());
      EXPECT_LT((difference - linear.derivatives.col(column)).cwiseAbs().maxCoeff(), tolerance * scale)
          << name << ", parameter " << p;
    }
  }
}

// Levenberg and Marquardt, in the obvious way: what the starts must be good enough for.
struct FittedEffect {
  Settings settings;
  double rms_mm = 0;
};
inline double rms_of(const Eigen::VectorXd& v) { return std::sqrt(v.squaredNorm() / double(v.size())); }
inline FittedEffect fit(const ForwardModel& model, Settings settings) {
  const Eigen::VectorXd& measured = model.observations().measured;
  double damping = 1e-3;
  auto at = model.linearise(settings).value();
  for (int step = 0; step < 30; ++step) {
    const Eigen::VectorXd residual = measured - at.predicted;
    const Eigen::MatrixXd normal = at.derivatives.transpose() * at.derivatives;
    const Eigen::VectorXd downhill = at.derivatives.transpose() * residual;
    Eigen::MatrixXd damped = normal;
    damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(normal.rows(), 1e-12);
    const Eigen::VectorXd move = damped.ldlt().solve(downhill);
    Settings moved = settings;
    Eigen::Index column = 0;
    for (Setting& one : moved) {
      const Effect& effect = *effect_of(model, one);
      for (Eigen::Index p = 0; p < one.parameters.size(); ++p, ++column) {
        const Parameter& parameter = effect.parameters[std::size_t(p)];
        double value = one.parameters[p] + move[column];
        if (parameter.scale == Scale::logarithmic) {
          value = one.parameters[p] * std::exp(std::clamp(move[column] / one.parameters[p], -1.0, 1.0));
        }
        one.parameters[p] = std::clamp(value, parameter.lower, parameter.upper);
      }
    }
    const auto there = model.predict(moved);
    if (there && (measured - *there).squaredNorm() < residual.squaredNorm()) {
      const double gain = 1 - (measured - *there).squaredNorm() / residual.squaredNorm();
      settings = moved;
      at = model.linearise(settings).value();
      damping = std::max(1e-8, damping / 10);
      if (gain < 1e-9) break;
    } else if ((damping *= 10) > 1e6) {
      break;
    }
  }
  return {settings, rms_of(measured - at.predicted)};
}
inline FittedEffect best_fit(const ForwardModel& model, const Effect& effect, const Settings& active = {}) {
  const Eigen::VectorXd residual = model.observations().measured - model.predict(active).value();
  FittedEffect best{{}, 1e9};
  for (const auto& [start, promise] : model.starts(effect, active, residual)) {
    Settings settings = active;
    settings.push_back({effect.kind, effect.form, start});
    FittedEffect found = fit(model, settings);
    if (found.rms_mm < best.rms_mm) best = found;
  }
  return best;
}

}  // namespace glisson::closedloop::test
