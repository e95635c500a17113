#pragma once
// The bar of cut_bar.h under loads, and where it lies with a cut that has opened, its walls free to pass through each
// other.

#include <vector>

#include "cut_bar.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics::test {

inline const Loads loads{ToolLoad{{80, 12, 40}, 12, {-150, 40, 260}}, PressureLoad{0.4}, GravityLoad{{0, 0, -9810}}};

// All corners are seen. The model must outlive it.
inline SeenPart corners_of(const StaticModel& model) {
  SeenPart seen{[&model](const Eigen::MatrixXd& u) {
                  Eigen::MatrixXd part(3 * static_cast<Eigen::Index>(model.mesh().points_mm.size()), u.cols());
                  for (std::size_t p = 0; p < model.mesh().points_mm.size(); ++p) {
                    part.middleRows<3>(3 * static_cast<Eigen::Index>(p)) =
                        u.middleRows<3>(3 * model.nodes().node_of_point[p]);
                  }
                  return part;
                },
                {}};
  for (std::size_t p = 0; p < model.mesh().points_mm.size(); ++p) seen.points.push_back(static_cast<int>(p));
  return seen;
}

inline std::vector<Eigen::Vector3d> displaced(const StaticModel& model, const Opening& opening) {
  std::vector<Eigen::Vector3d> u_mm = model.solve(loads)->displacement_mm;
  const Eigen::VectorXd by_cut_mm = opening.seen_mm(opening.amplitudes_mm(opening.standing_load()));
  for (std::size_t p = 0; p < u_mm.size() && by_cut_mm.size() > 0; ++p) {
    u_mm[p] += by_cut_mm.segment<3>(3 * static_cast<Eigen::Index>(p));
  }
  return u_mm;
}

inline Opening nothing_open(const StaticModel& model) { return Opening::of(model, loads, corners_of(model)).value(); }

}  // namespace glisson::mechanics::test
