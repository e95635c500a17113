#include "closedloop/experiment/forward_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace glisson::closedloop {
namespace {

// A step that a parameter can take inside its bounds, large enough to stand out of the rounding of a solver.
double step_of(const Parameter& parameter, double value) {
  constexpr double relative = 1e-4;
  const double size = parameter.scale == Scale::logarithmic
                          ? value
                          : std::max(std::abs(value), parameter.prior_high - parameter.prior_low);
  const double step = relative * size;
  return value + step <= parameter.upper ? step : -step;
}

// Central differences, one-sided at a bound.
Result<Linearisation> differences(const ForwardModel& model, const Settings& settings,
                                  const std::function<Result<Eigen::VectorXd>(const Settings&)>& predict) {
  auto here = predict(settings);
  if (!here) return failure(std::move(here.error()));
  Linearisation result{std::move(*here), {}};
  result.derivatives.resize(result.predicted.size(), parameter_count(settings));
  Settings moved = settings;
  Eigen::Index column = 0;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const Effect* effect = effect_of(model, settings[s]);
    GLISSON_ASSERT(effect != nullptr);
    for (Eigen::Index p = 0; p < settings[s].parameters.size(); ++p, ++column) {
      const Parameter& parameter = effect->parameters[static_cast<std::size_t>(p)];
      const double value = settings[s].parameters[p];
      const double step = step_of(parameter, value);
      moved[s].parameters[p] = value + step;
      auto ahead = predict(moved);
      if (!ahead) return failure(std::move(ahead.error()));
      if (value - step >= parameter.lower && value - step <= parameter.upper) {
        moved[s].parameters[p] = value - step;
        auto behind = predict(moved);
        if (!behind) return failure(std::move(behind.error()));
        result.derivatives.col(column) = (*ahead - *behind) / (2 * step);
      } else {
        result.derivatives.col(column) = (*ahead - result.predicted) / step;
      }
      moved[s].parameters[p] = value;
    }
  }
  return result;
}

}  // namespace

Result<Linearisation> ForwardModel::linearise(const Settings& settings) const {
  return differences(*this, settings, [this](const Settings& at) { return predict(at); });
}

Result<Linearisation> ForwardModel::linearise_further(const Settings& settings) const {
  return differences(*this, settings, [this](const Settings& at) { return predict_further(at); });
}

std::vector<Start> ForwardModel::starts(const Effect& effect, const Settings&, const Eigen::VectorXd&) const {
  std::vector<Start> starts;
  for (const Eigen::VectorXd& values : effect.starts) starts.push_back({values});
  return starts;
}

Result<Eigen::VectorXd> ForwardModel::predict_as(const std::string&, const Settings& settings) const {
  return predict(settings);
}

Result<Eigen::VectorXd> ForwardModel::predict_further(const Settings&) const {
  return failure("no-further-trials", GLISSON_TEXT("This experiment proposes no further trials."));
}

const Effect* effect_of(const ForwardModel& model, const Setting& setting) {
  const auto& catalogue = model.catalogue();
  const auto found = std::find_if(catalogue.begin(), catalogue.end(), [&](const Effect& effect) {
    return effect.kind == setting.kind && effect.form == setting.form && effect.size() == setting.parameters.size();
  });
  return found == catalogue.end() ? nullptr : &*found;
}

}  // namespace glisson::closedloop
