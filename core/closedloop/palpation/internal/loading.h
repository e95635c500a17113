#pragma once
// What acts on the specimen of a palpation. There are unit loads, the readings of the load cell, and how much of each
// load acts whenever markers were seen.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/palpation/internal/state.h"
#include "closedloop/palpation/internal/structure.h"

namespace glisson::closedloop {

// One moment at which markers were seen.
struct Shot {
  std::size_t trial = 0;
  Eigen::Index sample = 0;            // of the trial
  Eigen::Index first_row = 0;         // of the observations
  std::vector<Eigen::Index> markers;  // among all places of markers
};

// The history of a trial's load cell.
struct History {
  Eigen::VectorXd time_s;
  Eigen::VectorXd reading_mN;
  Eigen::Index load = 0;  // the column of its tool among the unit loads
};

// The columns of unit loads: a mN of each tool, then a mm/s2 of gravity along x, y, z, then a kPa of pressure.
struct LoadColumns {
  Eigen::Index tools = 0;
  [[nodiscard]] Eigen::Index gravity() const { return tools; }
  [[nodiscard]] Eigen::Index pressure() const { return tools + 3; }
  [[nodiscard]] Eigen::Index all() const { return tools + 4; }
};

// How much of each unit load acts at each shot (columns), and its derivatives by the load's own parameters.
struct Loading {
  Eigen::MatrixXd amounts;
  Eigen::MatrixXd by_zero, by_gain;
  std::vector<Eigen::MatrixXd> by_amplitude, by_time;  // one a creep term
};

[[nodiscard]] Loading loading_of(const std::vector<Shot>& all, const std::vector<History>& histories,
                                 const LoadColumns& columns, const Eigen::Vector3d& gravity_mm_s2,
                                 const PalpationState& state);

// A history a trial; sets `columns` and the unit loads themselves, a row an unknown of the specimen (mN). Fails where a
// tool touches nothing, and names its trial.
Result<std::vector<History>> histories_and_loads(const Palpation& experiment, const SpecimenBody& specimen,
                                                 LoadColumns& columns, Eigen::MatrixXd& loads_mN);

}  // namespace glisson::closedloop
