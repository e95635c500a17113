#pragma once
// Where a picture is seen from, in the words a surgeon uses.

#include <Eigen/Core>

#include "geometry/surface.h"

namespace glisson::scene {

// From which side of the patient. `surgeon` stands at the patient's right side and looks at the liver from the
// front, a little from below, as over an open abdomen.
enum class PatientView { anterior, posterior, left, right, superior, inferior, surgeon };

enum class Projection { perspective, parallel };

// All in patient coordinates (LPS, mm).
struct Camera {
  Eigen::Vector3d focus_mm{0, 0, 0};
  Eigen::Vector3d sight{0, 1, 0};  // unit, from the eye towards the focus
  Eigen::Vector3d up{0, 0, 1};     // unit, upright in the picture
  double visible_height_mm = 300;  // what the picture's height spans in the plane through the focus
  Projection projection = Projection::perspective;
};

// The camera that looks from that side at the whole box, in a picture whose width is `aspect` times its height.
// `margin` is the share of the picture left free around it.
[[nodiscard]] Camera look_from(PatientView view, const geometry::Box& box, double aspect, double margin = 0.08);

// Perpendicular to a slice: the reader's convention, the patient's right on the picture's left and, in a transverse
// slice, seen from the feet. `normal` need not be exactly an axis.
[[nodiscard]] Camera look_at_slice(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal,
                                   double visible_height_mm);

// Turned about the focus by a drag to the right and upwards, as if the hand held the object.
[[nodiscard]] Camera turned(const Camera& camera, double right_deg, double up_deg);

// Shifted in the picture's plane: what lay under the pointer follows it by that many mm.
[[nodiscard]] Camera shifted(const Camera& camera, double right_mm, double up_mm);

}  // namespace glisson::scene
