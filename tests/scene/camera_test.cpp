#include "scene/camera.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace glisson::scene {
namespace {

const geometry::Box liver_sized{{-100, -80, -150}, {120, 60, 30}};

Eigen::Vector3d right_of_picture(const Camera& camera) { return camera.sight.cross(camera.up); }

TEST(Camera, FromTheFrontThePatientsRightIsOnThePicturesLeft) {
  const Camera camera = look_from(PatientView::anterior, liver_sized, 1.5);
  EXPECT_NEAR(right_of_picture(camera).x(), 1, 1e-12);  // +x is the patient's left
  EXPECT_NEAR(camera.up.z(), 1, 1e-12);
}

TEST(Camera, TransverseSlicesAreSeenFromTheFeetWhicheverWayTheirNormalPoints) {
  for (const double side : {-1.0, 1.0}) {
    const Camera camera = look_at_slice({0, 0, 0}, {0, 0.05, side}, 200);
    EXPECT_GT(camera.sight.z(), 0.99);              // towards the head
    EXPECT_GT(right_of_picture(camera).x(), 0.99);  // the patient's left on the right
    EXPECT_LT(camera.up.y(), -0.99);                // the front up
  }
}

TEST(Camera, CoronalSlicesAreSeenFromTheFrontAndSagittalOnesFromTheLeft) {
  EXPECT_GT(look_at_slice({0, 0, 0}, {0, -1, 0}, 200).sight.y(), 0.99);
  EXPECT_LT(look_at_slice({0, 0, 0}, {1, 0, 0}, 200).sight.x(), -0.99);
}

TEST(Camera, EveryViewHoldsTheWholeBox) {
  for (const auto view : {PatientView::anterior, PatientView::posterior, PatientView::left, PatientView::right,
                          PatientView::superior, PatientView::inferior, PatientView::surgeon}) {
    for (const double aspect : {0.5, 1.0, 2.0}) {
      const Camera camera = look_from(view, liver_sized, aspect);
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d at((corner & 1) != 0 ? liver_sized.min_mm.x() : liver_sized.max_mm.x(),
                                 (corner & 2) != 0 ? liver_sized.min_mm.y() : liver_sized.max_mm.y(),
                                 (corner & 4) != 0 ? liver_sized.min_mm.z() : liver_sized.max_mm.z());
        const Eigen::Vector3d off = at - camera.focus_mm;
        EXPECT_LT(std::abs(off.dot(camera.up)), 0.5 * camera.visible_height_mm);
        EXPECT_LT(std::abs(off.dot(right_of_picture(camera))), 0.5 * aspect * camera.visible_height_mm);
      }
    }
  }
}

TEST(Camera, TurningKeepsItUprightToItselfAndTurningBackUndoesIt) {
  const Camera before = look_from(PatientView::surgeon, liver_sized, 1.5);
  const Camera after = turned(before, 33, -21);
  EXPECT_NEAR(after.sight.norm(), 1, 1e-12);
  EXPECT_NEAR(after.sight.dot(after.up), 0, 1e-12);
  const Camera back = turned(turned(before, 33, 0), -33, 0);
  EXPECT_LT((back.sight - before.sight).norm(), 1e-12);
}

TEST(Camera, DraggingToTheRightBringsThePatientsFrontToTheRight) {
  // Seen from the front; the hand takes the nearest point of the body and pulls it to the right.
  const Camera before = look_from(PatientView::anterior, liver_sized, 1.5);
  const Camera after = turned(before, 10, 0);
  const Eigen::Vector3d nearest = -before.sight;
  EXPECT_GT(nearest.dot(right_of_picture(after)), 0.1);
}

}  // namespace
}  // namespace glisson::scene
