#pragma once
// An effect that a model may lack: what it is called, the few numbers that it has, and what it means to a surgeon.
// How it changes the forward model is the business of each sort of experiment (material/effects.h,
// palpation/internal/effects.h, hardware/effects.h).

#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <vector>

namespace glisson::closedloop {

enum class Scale { linear, logarithmic };  // in which a parameter is searched; logarithmic ones are positive

// One number. Consecutive parameters with one name are the components of a vector (center_mm).
struct Parameter {
  std::string name;  // carries the unit: "foundation_kPa_per_mm"
  double no_effect;  // where the effect vanishes; for a shape parameter (a time, a place) any value in range
  double lower;      // bounds of the search
  double upper;
  double prior_low;  // where a surgeon would expect it: a standard deviation as wide as this range is no knowledge
  double prior_high;
  Scale scale = Scale::linear;
};

struct Effect {
  std::string kind;  // of the contract: "support-compliance"
  std::string form;  // where a kind has several laws ("yeoh", "prony-2"); empty for the only one
  std::vector<Parameter> parameters;
  std::string sentence;  // for a surgeon: what is going on in the specimen

  // Where the search begins: one vector of parameters each, in bounds. Each lies away from a vanishing gradient, as an
  // amplitude of exactly no effect hides its time constant. A forward model may add better ones (ForwardModel::starts).
  std::vector<Eigen::VectorXd> starts;

  // A form whose fits are slow: tried only where another form of its kind does about as well as the best.
  bool late = false;

  // The lower end of the first parameter may be what is: nothing left of a spring. An effect elsewhere that ends there
  // wanted to be something else.
  bool lower_end_may_be = false;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(parameters.size()); }
};

// An effect that is switched on, with its numbers; several act together. Identified by kind and form.
struct Setting {
  std::string kind;
  std::string form;
  Eigen::VectorXd parameters;
};
using Settings = std::vector<Setting>;

// Of an effect's parameters.
[[nodiscard]] inline Eigen::VectorXd numbers_of(std::initializer_list<double> values) {
  return Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size()));
}

// All parameters of all settings one after the other.
[[nodiscard]] inline Eigen::Index parameter_count(const Settings& settings) {
  Eigen::Index count = 0;
  for (const Setting& setting : settings) count += setting.parameters.size();
  return count;
}

}  // namespace glisson::closedloop
