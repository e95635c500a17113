#pragma once
// Rigid alignment: of matched points in closed form, of surfaces by iterated closest points.

#include <Eigen/Geometry>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::registration {

// The rotation and translation that bring `from_mm` nearest to `to_mm`, point by point, in the sense of least squares
// (Kabsch 1976; never a reflection). Weights are nonnegative, one a pair, or none for all alike.
// Failures: "alignment-too-few-points" (fewer than three pairs of weight above 0, or all of them on a line);
// "alignment-sizes" (of different counts, or not finite).
Result<Eigen::Isometry3d> align_points(const std::vector<Eigen::Vector3d>& from_mm,
                                       const std::vector<Eigen::Vector3d>& to_mm,
                                       const std::vector<double>& weights = {});

// Which surface is only a part of the other.
enum class Overlap {
  by_area,  // the smaller one, where it has less than 0.9 of the other's area; else neither
  neither,
  source_is_part,  // every point of the source has its place on the target
  target_is_part   // every point of the target has its place on the source
};

struct RigidIcpOptions {
  Overlap overlap = Overlap::by_area;
  double kept_fraction = 0.9;  // of the pairs, the nearest ones: the rest may have no partner (trimmed ICP,
                               // Chetverikov et al. 2002)
  int iterations = 100;
  double smallest_step_mm = 1e-3;  // of any point of the source, below which it has converged
};

enum class IcpStop { not_run, converged, iterations_used_up, cancelled };

struct RigidIcpResult {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();  // takes the source to the target
  double rms_mm = 0;                                            // of the pairs kept
  int iterations = 0;
  IcpStop stopped = IcpStop::not_run;
};

// Besl and McKay 1992, from where the surfaces lie: it finds the nearest good fit, not the best of all. At most 5000
// points of the one are led to the other's triangles.
// Failures: those of check_surface and align_points.
Result<RigidIcpResult> rigid_icp(const geometry::Surface& source, const geometry::Surface& target,
                                 const RigidIcpOptions& options = {}, const Progress& progress = {});

// The overlap with by_area resolved.
[[nodiscard]] Overlap resolved(Overlap overlap, const geometry::Surface& source, const geometry::Surface& target);

// The surface with its points moved.
[[nodiscard]] geometry::Surface moved(geometry::Surface surface, const Eigen::Isometry3d& transform);

}  // namespace glisson::registration
