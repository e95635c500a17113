#pragma once
// A sequence as a person orders it of a stereo video, its making, and what is known on the way. Values alone: the page
// knows nothing else of the core.

#include <filesystem>
#include <functional>
#include <optional>
#include <QImage>

#include "registration_quality/video_sequence.h"
#include "vision/calibrate.h"

namespace glisson::widgets {

struct VideoOrder {
  vision::StereoFiles video;
  std::filesystem::path calibration;  // a file, or a folder of text files; empty: made from `board`
  vision::BoardPictures board;
  registration_quality::VideoSequenceOptions options;
  std::filesystem::path folder;  // new
};

struct CalibrationReport {
  bool from_board = false;
  double rms_px = 0;  // of the reprojection error, and in how many pairs of how many the board was seen
  int pairs = 0, looked_at = 0;
  double baseline_mm = 0;
};

struct FrameReport {
  int number = 0;  // in the video, from 0
  std::size_t points = 0;
  double valid_fraction = 0;
  int followed = 0;
  bool may_be_of_size = true;  // see vision::may_be_of_size
  QImage picture;              // scene::depth_picture; null for most frames, which nobody could look at so fast
};

// What came on the way so far.
struct SequenceReport {
  std::optional<CalibrationReport> calibration;
  std::optional<FrameReport> first, latest;
  std::optional<registration_quality::VideoSequence> made;
};

// Told on the worker's thread.
struct SequenceHeard {
  std::function<void(const CalibrationReport&)> calibrated;
  std::function<void(const FrameReport&)> matched;
};

// Long work. Of more than sixty pairs of board pictures, sixty spread evenly are taken. Failures: those of
// vision::calibrate, read_stereo_calibration, StereoSource and make_sequence; "cancelled". Then nothing stays.
Result<registration_quality::VideoSequence> make_from_video(const VideoOrder& order, const Progress& progress,
                                                            const SequenceHeard& heard);

}  // namespace glisson::widgets
