#include "closedloop/palpation/internal/history.h"

#include <cmath>

namespace glisson::closedloop {

Eigen::VectorXd effective_load(const Eigen::VectorXd& time_s, const Eigen::VectorXd& load,
                               const std::vector<CreepTerm>& creep) {
  Eigen::VectorXd effective = load;
  for (const CreepTerm& term : creep) effective += term.amplitude * delayed_load(time_s, load, term.time_s).value;
  return effective;
}

DelayedLoad delayed_load(const Eigen::VectorXd& time_s, const Eigen::VectorXd& load, double delay_s) {
  DelayedLoad delayed{Eigen::VectorXd::Zero(load.size()), Eigen::VectorXd::Zero(load.size())};
  for (Eigen::Index i = 1; i < load.size(); ++i) {
    const double gap_s = time_s[i] - time_s[i - 1];
    const double y = delayed.value[i - 1], by_time = delayed.by_time[i - 1];
    if (gap_s <= 0) {  // a step of the load: the delayed one does not follow at once
      delayed.value[i] = y;
      delayed.by_time[i] = by_time;
      continue;
    }
    // Behind a ramp F + m t, y lags by m T once what it started with has decayed.
    const double slope = (load[i] - load[i - 1]) / gap_s;
    const double decay = std::exp(-gap_s / delay_s);
    const double off = y - load[i - 1] + slope * delay_s;
    delayed.value[i] = load[i] - slope * delay_s + off * decay;
    delayed.by_time[i] = -slope + (by_time + slope) * decay + off * decay * gap_s / (delay_s * delay_s);
  }
  return delayed;
}

}  // namespace glisson::closedloop
