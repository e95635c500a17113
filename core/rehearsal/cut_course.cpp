#include "rehearsal/cut_course.h"

#include <algorithm>
#include <limits>

namespace glisson::rehearsal {

using Eigen::Vector3d;

Result<CutCourse> course_of(const geometry::TetMesh& liver, const geometry::CutSurface& surface) {
  // To the back and the head; of a plane that lies across that way, to the left.
  const Vector3d wanted = Vector3d(0, 1, 1).normalized();
  const Vector3d& normal = surface.normal();
  constexpr double across = 0.95;
  const Vector3d way = std::abs(wanted.dot(normal)) < across ? wanted : Vector3d(1, 0, 0);
  CutCourse course{surface, surface.point_mm(), (way - way.dot(normal) * normal).normalized(), 0};

  double first_mm = std::numeric_limits<double>::infinity(), last_mm = -first_mm;
  for (const auto& cell : liver.cells) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        const Vector3d &p = liver.points_mm[cell[a]], &q = liver.points_mm[cell[b]];
        const double p_mm = surface.height_mm(p), q_mm = surface.height_mm(q);
        if ((p_mm > 0) == (q_mm > 0)) continue;
        const Vector3d crossing = p + p_mm / (p_mm - q_mm) * (q - p);
        const double at_mm = (crossing - surface.point_mm()).dot(course.forward);
        first_mm = std::min(first_mm, at_mm);
        last_mm = std::max(last_mm, at_mm);
      }
    }
  }
  if (last_mm < first_mm) {
    return failure("cut-misses", GLISSON_TEXT("The planned cut passes the liver by."));
  }
  course.begin_mm += first_mm * course.forward;
  course.length_mm = last_mm - first_mm;
  return course;
}

}  // namespace glisson::rehearsal
