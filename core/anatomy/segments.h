#pragma once
// Couinaud's eight segments of a generated liver (Couinaud 1957, Le foie; Strasberg 2000, HPB 2:333, for the names).
//
// The planes of the right and the middle hepatic vein stand on the vena cava's axis. The umbilical fissure parts II and
// III from IV, a plane through the left hepatic vein II from III. Heights of the right portal branches part VII from
// VI, and VIII from V. The middle plane runs through the gall bladder's fossa, the umbilical plane through the
// falciform ligament: these follow from the shape. The other planes stand where each segment gets its share of its
// section.

#include <array>
#include <cstdint>
#include <memory>

#include "anatomy/liver_body.h"

namespace glisson::anatomy {

// Of the section that is divided. Means after Mise et al. 2014 (HPB 16:439): VIII is the largest segment, VII the next.
struct SegmentShares {
  double posterior_of_right = 0.44;  // VI + VII of V to VIII
  double seventh_of_posterior = 0.58;
  double eighth_of_anterior = 0.6;
  double second_of_left = 0.46;  // II of II + III
};

class Segments {
 public:
  Segments(std::shared_ptr<const LiverBody> liver, const SegmentShares& shares);

  // 1 to 8, of any place (outside the liver: of the planes' extension).
  [[nodiscard]] int at(const Eigen::Vector3d& patient_mm) const;

  // A place in the plane of the right (or middle) hepatic vein, by its height and distance from the vena cava's axis.
  enum class Plane { right, middle };
  [[nodiscard]] Eigen::Vector3d on_plane(Plane plane, double z_mm, double from_cava_mm) const;
  // The nearest place in the plane between II and III.
  [[nodiscard]] Eigen::Vector3d on_left_plane(const Eigen::Vector3d& patient_mm) const;

  [[nodiscard]] const Eigen::Vector3d& centroid_mm(int segment) const;
  [[nodiscard]] double volume_ml(int segment) const;  // by voxels of the liver's field

 private:
  [[nodiscard]] double azimuth_deg(const Eigen::Vector3d& patient_mm) const;
  [[nodiscard]] Eigen::Vector3d cava_at(double z_mm) const;
  [[nodiscard]] bool is_caudate(const Eigen::Vector3d& patient_mm) const;

  std::shared_ptr<const LiverBody> liver_;
  Tube cava_;
  Eigen::Vector3d left_normal_;
  double right_azimuth_deg_ = 0, middle_azimuth_deg_ = 0, posterior_height_mm_ = 0, anterior_height_mm_ = 0,
         left_offset_mm_ = 0;
  std::array<Eigen::Vector3d, 9> centroids_mm_;
  std::array<double, 9> volumes_ml_{};
};

}  // namespace glisson::anatomy
