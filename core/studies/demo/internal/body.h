#pragma once
// What surrounds the demo patient's liver, in simple shapes: the body wall with its ribs, spine, lungs, heart, spleen,
// kidneys, stomach, bowel, pancreas. Sizes are textbook sizes for a liver of 2300 ml, and go with the liver's. Places
// follow from where the generator's liver leaves room for its neighbours (anatomy/liver_shape.h).

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "studies/demo/anatomy.h"

namespace glisson::studies {

struct Ellipsoid {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d semi_axes_mm{1, 1, 1};
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns

  // 1 on the surface, less inside.
  [[nodiscard]] double level(const Eigen::Vector3d& position_mm) const;
  // About how far under the surface; negative outside.
  [[nodiscard]] double depth_mm(const Eigen::Vector3d& position_mm) const;
};

class DemoBody {
 public:
  // `size`: of the body's lengths, 1 for a liver of 2300 ml.
  DemoBody(const geometry::Surface& liver, double size, std::uint64_t seed);

  [[nodiscard]] Tissue tissue_at(const Eigen::Vector3d& position_mm) const;

 private:
  // Positions below are of the body at size 1, mm.
  [[nodiscard]] Eigen::Vector3d at_size_1(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] double depth_under_skin_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] double fat_thickness_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] double diaphragm_height_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] Tissue wall_at(const Eigen::Vector3d& position_mm, double depth_in_wall_mm) const;
  [[nodiscard]] Tissue chest_at(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] Tissue abdomen_at(const Eigen::Vector3d& position_mm) const;

  double size_;
  std::uint64_t seed_;
  std::vector<Ellipsoid> bowel_;
  std::vector<double> dome_mm_;  // height of the diaphragm on a lattice over x and y
};

}  // namespace glisson::studies
