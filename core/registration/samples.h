#pragma once
// A surface seen as a few points spread evenly over it and the geodesic distances from them.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::registration {

struct GeodesicSamples {
  std::vector<int> points;        // of the surface, in the order in which they were chosen
  Eigen::MatrixXd to_surface_mm;  // samples x points of the surface
  Eigen::MatrixXd between_mm;     // samples x samples, symmetric with a zero diagonal
  double covering_radius_mm = 0;  // no point of the surface lies farther than this from its nearest sample
};

// Farthest-point sampling (Eldar et al. 1997; Moenning and Dodgson 2003). Each sample lies as far as can be from those
// before it. So the first k samples are even for any k, and extremities come first. `start` is any point of the
// surface; the first sample is the point farthest from it. Distances by the heat method. Failures: those of
// HeatGeodesics::prepare; "too-few-points" where the surface has fewer points than samples are asked for; "cancelled".
Result<GeodesicSamples> sample_surface(const geometry::Surface& surface, int count, int start = 0,
                                       const Progress& progress = {});

}  // namespace glisson::registration
