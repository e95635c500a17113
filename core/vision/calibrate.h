#pragma once
// A stereo calibration from pictures of a board, taken by both eyes at once.

#include <string>
#include <vector>

#include "base/result.h"
#include "vision/board.h"
#include "vision/calibration.h"

namespace glisson::vision {

// The same moment, seen by both eyes.
struct BoardPair {
  std::string name;  // for the notes: the file, or the number in a video
  Frame left;
  Frame right;
};

// One eye's lens as it was found. Standard deviations are the least-squares fit's own, of the points' scatter. They
// show what the pictures cannot tell at all, as a focal length from views all square to the board.
struct CameraFit {
  double rms_px = 0;  // of the reprojection error, over both coordinates of all points
  double focal_sd_px = 0;
  double principal_point_sd_px = 0;
};

struct CalibrationFit {
  StereoCalibration calibration;
  CameraFit left, right;
  double stereo_rms_px = 0;  // of both eyes with one rigid motion between them
  int pairs = 0;             // in which both eyes see the board
  int points = 0;            // seen by both eyes, in all pairs
  std::vector<double> pair_rms_px;
  std::vector<std::string> notes;  // pairs left out, and why
};

// Zhang 2000 for each eye with five coefficients of distortion, then the motion between the eyes with the lenses held
// (OpenCV). Failures: those of check(board); "calibration-too-few-views" (fewer than three pairs show the board);
// "stereo-image-sizes" (pictures of several sizes); "calibration-failed".
Result<CalibrationFit> calibrate(const std::vector<BoardPair>& pairs, const Board& board);

// How far points of the board are from where a camera known beforehand would show them, each view's pose being fitted.
Result<double> reprojection_rms_px(const Camera& known, const std::vector<Frame>& frames, const Board& board);

}  // namespace glisson::vision
