#pragma once
// Elastic registration of an organ whose supports are known. They tie the pose to the displacement. An organ that a
// tool pulls is not where its visible part, laid over the cloud, would have it. So pose and forces are fitted together
// from several starts, and the start is kept of which the evidence (Laplace's approximation) is largest.
//
// Points far off are trusted at first and less from round to round (graduated non-convexity; Blake and Zisserman,
// Visual Reconstruction), so that a part of the surface that a tool has drawn away is not passed over. Where a declared
// tool is seen to touch is a row in each direction. A narrow patch of the surface is pulled by itself, declared or not,
// where the evidence grows much by it.
//
// Where linear elasticity would err by more than 1 mm in turning the organ, it is fitted by corotational elasticity too
// (large_deformation.h). Forces act about where the organ lies, anew every second round. At last they are in
// equilibrium with it. Linear elasticity is kept only where the evidence says so very strongly.

#include "guidance/elastic_registration.h"

namespace glisson::guidance {

[[nodiscard]] ElasticPlacement register_supported(const ForceModes& modes, const SeenFrame& frame,
                                                  const Eigen::Isometry3d& from,
                                                  const std::vector<mechanics::PointInMesh>& targets,
                                                  const Eigen::Vector3d& gravity_mm_s2,
                                                  const RegistrationOptions& options);

}  // namespace glisson::guidance
