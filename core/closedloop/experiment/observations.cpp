#include "closedloop/experiment/observations.h"

#include "base/result.h"

namespace glisson::closedloop {

void Observations::add(const std::vector<Observation>& more) {
  if (more.empty()) return;
  const Eigen::Index first = rows(), count = first + static_cast<Eigen::Index>(more.size());
  const auto width = static_cast<Eigen::Index>(more.front().conditions.size());
  const bool has_place = more.front().place_mm.has_value();
  GLISSON_ASSERT(first == 0 || (width == conditions.cols() && has_place == has_places()));
  measured.conservativeResize(count);
  noise.conservativeResize(count);
  time_s.conservativeResize(count);
  load.conservativeResize(count);
  conditions.conservativeResize(count, width);
  if (has_place) place_mm.conservativeResize(count, 3);
  Eigen::Index row = first;
  for (const Observation& one : more) {
    GLISSON_ASSERT(static_cast<Eigen::Index>(one.conditions.size()) == width && one.place_mm.has_value() == has_place);
    measured[row] = one.measured;
    noise[row] = one.noise;
    trial.push_back(one.trial);
    sample.push_back(one.sample);
    direction.push_back(one.direction);
    point.push_back(one.point);
    time_s[row] = one.time_s;
    load[row] = one.load;
    if (has_place) place_mm.row(row) = one.place_mm->transpose();
    conditions.row(row) = Eigen::RowVectorXd::Map(one.conditions.data(), width);
    ++row;
  }
}

}  // namespace glisson::closedloop
