#pragma once
// Where rigid tools are near a surface of triangles, found anew as either moves.
//
// `moved_mm` begins with the displacement of each point of the surface, 3 a point; `advance_mm` has one a tool, how far
// it slid from its pose.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "mechanics/contact/contact.h"

namespace glisson::mechanics {

struct ContactCandidate {
  std::size_t tool, rod;
  std::array<int, 3> points;  // of the surface
  Eigen::Vector3d weights;
  Eigen::Vector3d normal;  // out of the tool
  double gap_mm;
  Eigen::Vector3d place_mm;  // on the moved surface
};

// The same place of the surface as it moves on, kept from round to round. Else pushing the surface out of the tool at
// one place could let it in again at another that was left a round before.
struct TrackedContact {
  std::size_t tool, rod;
  std::array<int, 3> points;
  Eigen::Vector3d weights;
};

// Adds the place, unless one of the same rod lies beside it.
void keep(const TrackedContact& place, const geometry::Surface& surface, std::vector<TrackedContact>& kept);

// The nearest place of each triangle whose gap is at most the margin. Graspers touch nothing.
[[nodiscard]] std::vector<ContactCandidate> contact_candidates(const geometry::Surface& surface,
                                                               const std::vector<ContactTool>& tools,
                                                               const Eigen::VectorXd& advance_mm,
                                                               const Eigen::VectorXd& moved_mm, double margin_mm);

// Those that are kept, where they are now, within the margin.
[[nodiscard]] std::vector<ContactCandidate> tracked_candidates(const geometry::Surface& surface,
                                                               const std::vector<TrackedContact>& kept,
                                                               const std::vector<ContactTool>& tools,
                                                               const Eigen::VectorXd& advance_mm,
                                                               const Eigen::VectorXd& moved_mm, double margin_mm);

// How far a tool slides forward until it is 0.05 mm from the surface. Failure: "tool-touches-nothing".
Result<double> way_to_surface(const geometry::Surface& surface, const TouchingTool& tool,
                              const Eigen::VectorXd& moved_mm);

// A patch in the jaws of a grasper.
struct Gripped {
  std::size_t tool;
  std::vector<int> points;  // of the surface
  std::vector<double> weights;
};

// Of the grasper that is the tool of that index; the weights are by area and sum to 1. Failures: "tool-invalid",
// "tool-touches-nothing".
Result<Gripped> grip(const geometry::Surface& surface, std::size_t index, const Grasp& grasp);

// "not-available" where one of them spreads a force over a patch.
Result<void> check_no_patch(const std::vector<ContactTool>& tools);

inline Eigen::Vector3d unit_or_zero(const Eigen::Vector3d& v) {
  return v.norm() > 0 ? Eigen::Vector3d(v.normalized()) : Eigen::Vector3d::Zero();
}

}  // namespace glisson::mechanics
