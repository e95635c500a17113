#include "meshing/image_end.h"

#include <array>
#include <Eigen/Geometry>

#include "base/result.h"

namespace glisson::meshing {
namespace {

constexpr double least_share = 0.25;  // of what is touched, to be called the cap
constexpr double facing = 0.9;        // cosine between a triangle and the image's end

}  // namespace

const char* side_of_patient(const Eigen::Vector3d& towards) {
  Eigen::Index axis = 0;
  towards.cwiseAbs().maxCoeff(&axis);
  const bool onwards = towards[axis] > 0;
  if (axis == 0) return onwards ? GLISSON_TEXT("the patient's left") : GLISSON_TEXT("the patient's right");
  if (axis == 1) return onwards ? GLISSON_TEXT("the back") : GLISSON_TEXT("the front");
  return onwards ? GLISSON_TEXT("the head") : GLISSON_TEXT("the feet");
}

const char* cut_off_under(const geometry::Surface& body, const imaging::Grid& image, const Eigen::Vector3d& center_mm,
                          double radius_mm) {
  double touched_mm2 = 0;
  std::array<double, 6> at_end_mm2{};  // of each axis, at its first voxel and at its last
  for (const auto& triangle : body.triangles) {
    const Eigen::Vector3d &a = body.points_mm[triangle[0]], &b = body.points_mm[triangle[1]],
                          &c = body.points_mm[triangle[2]];
    const Eigen::Vector3d middle_mm = (a + b + c) / 3;
    if ((middle_mm - center_mm).norm() > radius_mm) continue;
    const Eigen::Vector3d area_mm2 = 0.5 * (b - a).cross(c - a);
    touched_mm2 += area_mm2.norm();
    const Eigen::Vector3d index = image.index_of(middle_mm);
    for (int axis = 0; axis < 3; ++axis) {
      const double towards_mm2 = area_mm2.dot(image.direction.col(axis));
      const bool last = towards_mm2 > 0;
      const double before_end = last ? image.size[axis] - 0.5 - index[axis] : index[axis] + 0.5;
      const bool faces_it = std::abs(towards_mm2) > facing * area_mm2.norm();
      if (faces_it && before_end <= 1) at_end_mm2[2 * axis + (last ? 1 : 0)] += area_mm2.norm();
    }
  }
  for (int end = 0; end < 6; ++end) {
    if (at_end_mm2[end] <= least_share * touched_mm2) continue;
    const Eigen::Vector3d onwards = image.direction.col(end / 2);
    return side_of_patient(end % 2 == 1 ? onwards : Eigen::Vector3d(-onwards));
  }
  return nullptr;
}

}  // namespace glisson::meshing
