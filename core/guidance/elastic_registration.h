#pragma once
// Where an organ lies and how it is deformed, from what is seen of its surface. The answer is a pose, and the
// displacement that forces on its surface make (force_modes.h). It says how far each place inside may be from where it
// is said to be.
//
// First the pose alone, by points to planes with weights of Student's t; then pose and forces together. Forces stand
// on what is not seen: what is seen is free, but for the tools. How large they may be is decided by the evidence
// (internal/evidence_fit.h), so that a frame without deformation invents none. The posterior covariance of forces and
// pose gives the standard deviation of each target. An organ whose supports are known is fitted otherwise
// (internal/supported_fit.h): it cannot drift, and a narrow pull bends it far. Positions at rest are in the scan's
// frame, mm.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "guidance/force_modes.h"
#include "guidance/frame.h"
#include "mechanics/elements/point_location.h"

namespace glisson::guidance {

struct RegistrationOptions {
  int rigid_rounds = 25;
  int elastic_rounds = 20;
  std::size_t maximum_points = 1200;  // of the cloud; more are thinned at random
  double guess_sd_mm = 12;            // of a pose that is given: shift and turn of the truth from it
  double guess_sd_deg = 8;
  double largest_rms_mm = 10;       // that forces may displace the surface by, in the mean
  double most_bent_mm = 15;         // that a free organ is believed to be displaced by (rms): else nothing is answered
  double strange_when_bent_mm = 4;  // from here on, a surface that lies off by more than its noise is another organ's:
  double most_strange = 2.1;        // the share of most_bent_mm plus the residual over the stated noise
  double independent_spacing_mm = 16;  // points of a cloud nearer than this repeat each other: the mesh errs alike
  double surface_error_mm = 0.3;       // of a surface of triangles, beside the noise
  double touched_by_unseen = 0.01;     // variance of forces where the surface is seen, beside those elsewhere
  double seen_within_mm = 15;
  // Of organs whose supports are known.
  int supported_rounds = 24;
  double widest_mm = 15;          // that points may be off by in the first round
  int widest_rounds = 14;         // until they are trusted by the noise alone
  int narrow_forces = 3;          // at most, on narrow patches
  double narrow_sd_mm = 15;       // that each moves its own patch by
  double narrow_gain = 8;         // of the log evidence: there are some hundred places to choose from
  double contact_sd_mm = 12;      // of where a tool touches: linear elasticity errs most there
  bool large_deformation = true;  // tried too where an organ turns far; off: linear elasticity alone, some times faster
};

struct FoundTool {
  std::string id;
  Eigen::Vector3d force_mN{0, 0, 0};
  double sd_mN = 0;
};

struct ElasticPlacement {
  bool converged = false;
  Sentence why_not;                                        // where it did not
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // scan to camera
  std::vector<Eigen::Vector3d> displacement_mm;  // one a point of the mesh, in the scan's frame: x -> pose (x + u)
  double residual_rms_mm = 0;                    // of the points that belong to the organ, along the normal
  double visible_share = 0;                      // of the surface's area
  double elastic_rms_mm = 0;                     // of the displacement over the surface
  std::vector<Eigen::Vector3d> target_mm;        // in the camera's frame
  std::vector<double> target_sd_mm;              // of each coordinate
  std::vector<Eigen::Vector3d> further_mm;       // the same of GuidanceCase::further_mm
  std::vector<double> further_sd_mm;
  std::vector<FoundTool> tools;
};

// Of a free organ that lies about where the frame before left it: fewer rounds and points, several times faster.
[[nodiscard]] RegistrationOptions following_options();

// `targets` are places of the mesh of `modes`. `from` is where the search begins, scan to camera; it also weighs as a
// guess of the stated accuracy.
ElasticPlacement register_elastic(const ForceModes& modes, const SeenFrame& frame, const Eigen::Isometry3d& from,
                                  const std::vector<mechanics::PointInMesh>& targets,
                                  const Eigen::Vector3d& gravity_mm_s2 = {0, 0, 0},
                                  const RegistrationOptions& options = {});

}  // namespace glisson::guidance
