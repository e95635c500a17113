#pragma once
// What an experiment gives, whatever its sort: a long vector of measured numbers. Each has its standard deviation. Each
// says what is known about when, where and under which load it was taken. Everything that judges or selects is written
// against this alone.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace glisson::closedloop {

// One measured number: a row of Observations, whose members say more of each.
struct Observation {
  double measured = 0;
  double noise = 0;
  int trial = 0;
  int sample = 0;
  int direction = 0;
  int point = 0;
  double time_s = 0;
  double load = 0;
  std::optional<Eigen::Vector3d> place_mm = {};
  std::vector<double> conditions = {};
};

struct Observations {
  std::string unit;                     // "mm", "kPa"; "noise" where quantities of several units are joined
  std::vector<std::string> directions;  // what the components of a point are called: {"x","y","z"}, {"stress"}, ...
  // Which quantity each direction is of, where several instruments measured: {0, 0, 1, 1} of displacements and forces.
  // Empty: all are judged as one.
  std::vector<int> quantities;
  std::vector<std::string> trials;  // ids

  // Appends rows. All rows of all calls have a place or none has, and have as many conditions. Takes as long as there
  // are rows already: give those of a trial, or all, at once.
  void add(const std::vector<Observation>& more);

  // Row after row, grouped by trial and within it by time; all have as many rows.
  Eigen::VectorXd measured;    // NaN where predict() was asked for what nobody measured
  Eigen::VectorXd noise;       // standard deviation, > 0, of independent errors
  std::vector<int> trial;      // index into `trials`
  std::vector<int> sample;     // rows of one trial with the same number were measured at the same moment
  std::vector<int> direction;  // index into `directions`
  std::vector<int> point;      // rows with the same number make one vector (x, y, z of one marker); consecutive
  Eigen::VectorXd time_s;
  Eigen::VectorXd load;      // what was done: force (N), strain, current (A)
  Eigen::MatrixXd place_mm;  // three columns; no rows where the experiment has no places
  // What else a smooth correction may depend on besides load and place, such as the tool's place, the strain rate or
  // the charge drawn. A column each; may have no columns.
  Eigen::MatrixXd conditions;

  [[nodiscard]] Eigen::Index rows() const { return measured.size(); }
  [[nodiscard]] int trial_count() const { return static_cast<int>(trials.size()); }
  [[nodiscard]] bool has_places() const { return place_mm.rows() == rows() && rows() > 0; }
};

}  // namespace glisson::closedloop
