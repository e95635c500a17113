#pragma once
// Whether a stereo calibration is that of two pictures: asked of the pictures, not of the file.

#include "base/result.h"
#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::vision {

struct PictureCheck {
  int matches = 0;         // features that both pictures show
  double epipolar_px = 0;  // their median distance from one another's epipolar lines
  double in_front = 1;     // share of those within three pixels of their lines that lie in front of both eyes
};

// Both directions of left-to-right give nearly the same epipolar lines. But with the wrong one, or with the pictures
// exchanged, everything that is seen lies behind the camera. Failures: "stereo-eyes-exchanged" (most lies behind), and
// "calibration-not-of-pictures" (half of the features miss their lines by more than a fiftieth of the picture's
// height). With fewer than twenty features nothing is refused. Turns and sizes are not looked at: checked() and
// StereoMatcher do that.
Result<PictureCheck> check_against_pictures(const StereoCalibration& calibration, const Frame& left,
                                            const Frame& right);

}  // namespace glisson::vision
