#include "mechanics/cutting/internal/crossed_faces.h"

#include <cmath>

namespace glisson::mechanics {

std::vector<FacePart> parts_of(const Crossing& crossing, const BoundaryFace& face) {
  Eigen::Vector3d height_mm;
  for (int i = 0; i < 3; ++i) height_mm[i] = crossing.height_mm[face.points[i]];
  const auto above = (height_mm.array() > 0).count();
  if (above == 0 || above == 3) return {{Eigen::Matrix3d::Identity(), 1.0, above == 3}};
  int lone = 0;
  while ((height_mm[lone] > 0) != (above == 1)) ++lone;
  const int next = (lone + 1) % 3, last = (lone + 2) % 3;
  const auto on_edge = [&](int a, int b) -> Eigen::Vector3d {
    const double share_of_b = height_mm[a] / (height_mm[a] - height_mm[b]);
    return (1.0 - share_of_b) * Eigen::Vector3d::Unit(a) + share_of_b * Eigen::Vector3d::Unit(b);
  };
  const Eigen::Vector3d to_next = on_edge(lone, next), to_last = on_edge(lone, last);
  const auto part = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, bool is_above) {
    FacePart made{Eigen::Matrix3d::Zero(), 0, is_above};
    made.corners << a, b, c;
    made.share = std::abs(made.corners.determinant());
    return made;
  };
  const bool lone_above = above == 1;
  return {part(Eigen::Vector3d::Unit(lone), to_next, to_last, lone_above),
          part(to_next, Eigen::Vector3d::Unit(next), Eigen::Vector3d::Unit(last), !lone_above),
          part(to_next, Eigen::Vector3d::Unit(last), to_last, !lone_above)};
}

}  // namespace glisson::mechanics
