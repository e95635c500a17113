#include "closedloop/palpation/internal/ball_region.h"

#include <cmath>

namespace glisson::closedloop {
namespace {

// From 0 outside to 1 inside, over about half an edge of the cell.
double steepness_per_mm(double edge_mm) { return 4.0 / edge_mm; }

}  // namespace

double inside(const mechanics::Ball& ball, const Eigen::Vector3d& place_mm, double edge_mm) {
  const double depth_mm = ball.radius_mm - (place_mm - ball.center_mm).norm();
  return 0.5 * (1.0 + std::tanh(steepness_per_mm(edge_mm) * depth_mm));
}

double inside_derivative(const mechanics::Ball& ball, const Eigen::Vector3d& place_mm, double edge_mm,
                         BallParameter by) {
  const double in = inside(ball, place_mm, edge_mm);
  const double by_depth = 2.0 * steepness_per_mm(edge_mm) * in * (1.0 - in);
  if (by == BallParameter::radius) return by_depth;
  const Eigen::Vector3d from_center = place_mm - ball.center_mm;
  const double distance_mm = from_center.norm();
  return distance_mm == 0 ? 0.0 : by_depth * from_center[static_cast<int>(by)] / distance_mm;
}

}  // namespace glisson::closedloop
