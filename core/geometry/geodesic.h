#pragma once
// Distances along a surface.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::geometry {

class HeatMethod;

// Geodesic distances by the heat method (Crane, Weischedel, Wardetzky 2013) on the intrinsic Delaunay triangulation:
// factorised once, then two sparse solves a source. On well-shaped meshes within some per cent of the exact distance.
class HeatGeodesics {
 public:
  // Failures: those of check_surface; surface-not-manifold (a triangle that does not fit its neighbours is named);
  // surface-in-pieces (distances between pieces are infinite); geodesic-singular (degenerate triangles).
  static Result<HeatGeodesics> prepare(const Surface& surface);

  HeatGeodesics(HeatGeodesics&&) noexcept;
  HeatGeodesics& operator=(HeatGeodesics&&) noexcept;
  ~HeatGeodesics();

  // From one point of the surface to each, in mm. Safe from several threads.
  [[nodiscard]] Eigen::VectorXd distances_mm(int from_point) const;
  // From each of many points, one a row, by all threads; each row what it is alone, to rounding.
  [[nodiscard]] Eigen::MatrixXd distances_mm(const std::vector<int>& from_points) const;

 private:
  explicit HeatGeodesics(std::unique_ptr<const HeatMethod> method);
  std::unique_ptr<const HeatMethod> method_;
};

// The same exactly (Xin and Wang 2009: windows over the unfolded triangles). Much slower: the judge of the heat method.
Result<std::vector<double>> exact_geodesic_distances_mm(const Surface& surface, int from_point);

}  // namespace glisson::geometry
