#pragma once
// A stereo calibration from pictures of a board, taken by both eyes at once.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "vision/board.h"
#include "vision/calibration.h"
#include "vision/stereo_source.h"

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
  int looked_at = 0;         // pairs
  int pairs = 0;             // of these, in which both eyes see the board
  int points = 0;            // seen by both eyes, in all pairs
  std::vector<double> pair_rms_px;
  std::vector<std::string> notes;  // pairs left out, and why
};

// Zhang 2000 for each eye with five coefficients of distortion, then the motion between the eyes with the lenses held
// (OpenCV). Failures: those of check(board); "calibration-too-few-views" (fewer than three pairs show the board);
// "stereo-image-sizes" (pictures of several sizes); "calibration-failed".
Result<CalibrationFit> calibrate(const std::vector<BoardPair>& pairs, const Board& board);

// The same pair after pair, for more pictures than the memory holds: of each only the board's points are kept.
class Calibrator {
 public:
  // Failures: those of check(board).
  static Result<Calibrator> begin(const Board& board);
  Calibrator(Calibrator&&) noexcept;
  Calibrator& operator=(Calibrator&&) noexcept;
  ~Calibrator();

  // A pair without the board is noted and left out. Failure: "stereo-image-sizes".
  Result<void> add(const BoardPair& pair);
  // Failures: the others of calibrate().
  [[nodiscard]] Result<CalibrationFit> fit() const;

 private:
  struct Inside;
  explicit Calibrator(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

// Where pictures of a board lie: files, folders and videos, one after another, the two eyes' in one order.
struct BoardPictures {
  std::vector<std::filesystem::path> left;   // or both eyes'
  std::vector<std::filesystem::path> right;  // none: `left` shows both
  Shared shared = Shared::left_then_right;
  Board board;
  int every = 1;  // picture of so many
};

// Failures: those of calibrate(), of FrameSource and of halves(); "calibration-not-paired" (more pictures of one eye
// than of the other); "cancelled".
Result<CalibrationFit> calibrate(const BoardPictures& pictures, const Progress& progress = {});

// How far points of the board are from where a camera known beforehand would show them, each view's pose being fitted.
Result<double> reprojection_rms_px(const Camera& known, const std::vector<Frame>& frames, const Board& board);

}  // namespace glisson::vision
