#pragma once
// Where seen points lie on a surface that moves, and what each says of its displacement.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/nearest.h"
#include "geometry/surface.h"

namespace glisson::guidance {

// One equation: along `direction`, the place of three points by their weights is to lie at `at_mm`.
struct SeenRow {
  std::array<int, 4> points{-1, -1, -1, -1};  // of the mesh; three of a triangle or four of a cell
  Eigen::Vector4d weights{0, 0, 0, 0};
  Eigen::Vector3d direction{0, 0, 1};
  Eigen::Vector3d at_mm{0, 0, 0};
  double noise_mm = 1;
  double trust = 1;  // of a robust fit: 0 for what does not belong to the organ
  double share = 1;  // of an independent row: neighbours on one surface say the same, and err alike
};

// The surface as it lies now, with what finding places on it needs.
class SeenSurface {
 public:
  // `mesh_point_of` names the mesh's point of each point of the surface.
  SeenSurface(const geometry::Surface& surface, const std::vector<int>& mesh_point_of,
              const std::vector<Eigen::Vector3d>& mesh_points_mm);

  // A row along the surface's smooth normal; `off_mm` is how far the point lies from it, signed, along that normal,
  // and `beside_mm` how far across it, beyond the rim.
  struct Found {
    SeenRow row;
    double off_mm = 0;
    double beside_mm = 0;
  };
  [[nodiscard]] Found find(const Eigen::Vector3d& position_mm) const;

 private:
  geometry::Surface surface_;
  const std::vector<int>& mesh_point_of_;
  std::vector<Eigen::Vector3d> normals_;
  geometry::SurfaceDistance distance_;
};

// Weights of Student's t with four degrees of freedom, for errors that are off more often than Gaussian ones (e.g.
// Lange et al. 1989, J. Am. Stat. Assoc. 84:881): 5 / (4 + (off / noise)^2).
[[nodiscard]] double robust_weight(double off_mm, double noise_mm);

}  // namespace glisson::guidance
