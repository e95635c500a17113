#include "closedloop/learnt_device.h"

#include <fmt/format.h>
#include <cmath>

#include "base/json.h"

namespace glisson::closedloop {
namespace {

using hardware::Figure;
using hardware::Source;

constexpr double plans_rated_hours = 5;  // battery.h

struct Learner {
  LearntDevice learnt;
  std::string learnt_from;
  std::string effect;

  void set(const char* name, Figure& figure, double value) {
    figure = {value, Source::measured, fmt::format("closed loop, {}: {}", learnt_from, effect)};
    learnt.changed.emplace_back(name);
  }
  void remark(std::string text, std::vector<std::string> arguments) {
    learnt.remarks.push_back({std::move(text), std::move(arguments)});
  }
};

double rated_hours(const std::string& form) { return form == "rated-1h" ? 1 : form == "rated-20h" ? 20 : 5; }

void take_rate_capacity(Learner& learner, const std::string& form, double exponent) {
  hardware::DeviceBattery& battery = learner.learnt.device.battery;
  learner.set("battery.rate_exponent", battery.rate_exponent, exponent);
  if (const double hours = rated_hours(form); hours != plans_rated_hours) {
    learner.set("battery.capacity_mAh", battery.capacity_mAh,
                battery.capacity_mAh.value * std::pow(plans_rated_hours / hours, (exponent - 1) / exponent));
  }
}

// The mean of c_0 + c_1 d + c_2 d^2 + ... over a whole discharge.
double mean_over_discharge(const Json& coefficients) {
  double mean = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    mean += coefficients.at(i).get<double>() / static_cast<double>(i + 1);
  return mean;
}

void take(Learner& learner, const std::string& kind, const std::string& form, const Json& parameters) {
  hardware::Device& device = learner.learnt.device;
  const auto value = [&](const char* name) { return parameters.at(name).get<double>(); };
  if (kind == "internal-resistance") {
    learner.set("battery.internal_resistance_ohm", device.battery.internal_resistance_ohm, value("resistance_ohm"));
  } else if (kind == "rate-capacity") {
    take_rate_capacity(learner, form, value("exponent"));
  } else if (kind == "self-heating" && form == "capacity") {
    learner.set("battery.capacity_per_C", device.battery.capacity_per_C, value("coefficient_per_C"));
  } else if (kind == "discharge-curve") {
    learner.set("battery.voltage_V", device.battery.voltage_V,
                device.battery.voltage_V.value + mean_over_discharge(parameters.at("curve_V")));
  } else if (kind == "static-power") {
    learner.set("idle_W", device.idle_W, device.idle_W.value + value("static_W"));
  } else if (kind == "supply-loss") {
    learner.set("supply_efficiency", device.supply_efficiency, device.supply_efficiency.value * value("efficiency"));
  } else if (kind == "dynamic-power") {
    learner.set("kernel.active_W", device.kernel.active_W, value("full_load_W"));
  } else if (kind == "thermal-throttling") {
    learner.set("throttle_C", device.throttle_C, value("limit_C"));
  } else if (kind == "thermal-resistance") {
    learner.set("thermal_resistance_C_per_W", device.thermal_resistance_C_per_W, value("resistance_C_per_W"));
  } else if (kind == "thermal-inertia") {
    learner.set("thermal_time_constant_s", device.thermal_time_constant_s, value("time_constant_s"));
  } else {
    learner.remark(GLISSON_TEXT("The plan has no figure for the effect {0}; it is left out."), {learner.effect});
  }
}

}  // namespace

Result<LearntDevice> learn_device(const hardware::Device& declared, const std::filesystem::path& model_file) {
  const auto document = read_json_file(model_file);
  if (!document) return failure(document.error());
  Learner learner{{declared, {}, {}}, {}, {}};
  try {
    if (document->at("format") != "glisson-closedloop-model/1" || document->at("kind") != "platform") {
      return failure(Error{"model-invalid",
                           GLISSON_TEXT("{0} was not learnt from the recordings of a platform."),
                           {model_file.filename().string()},
                           GLISSON_TEXT("Use the model.json that glisson-cli explain wrote for an experiment of kind "
                                        "\"platform\"."),
                           model_file});
    }
    learner.learnt_from = document->value("learnt_from", std::string("recordings"));
    for (const Json& effect : document->at("effects")) {
      const auto kind = effect.at("kind").get<std::string>();
      const std::string form = effect.value("law", std::string());
      learner.effect = form.empty() ? kind : kind + " (" + form + ")";
      take(learner, kind, form, effect.at("parameters"));
    }
    if (document->contains("smooth_correction"))
      learner.remark(GLISSON_TEXT("A smooth correction has no cause and is left out of the plan."), {});
    if (document->value("verdict", std::string()) == "unexplained") {
      learner.remark(GLISSON_TEXT("These recordings are not explained by the effects found: they take a part of the "
                                  "error away, and are no proof of a cause."),
                     {});
    }
  } catch (const Json::exception&) {
    return failure(Error{"model-invalid",
                         GLISSON_TEXT("{0} is not a complete model."),
                         {model_file.filename().string()},
                         {},
                         model_file});
  }
  if (const auto sound = check(learner.learnt.device); !sound) return failure(Error(sound.error()).in_file(model_file));
  return std::move(learner.learnt);
}

}  // namespace glisson::closedloop
