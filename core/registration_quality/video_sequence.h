#pragma once
// A stereo video to a sequence on disk that SIRGn judges. It has a cloud a frame, landmarks tracked through all of
// them, and the model that they are all aligned to.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "vision/stereo.h"
#include "vision/stereo_source.h"
#include "vision/tracks.h"

namespace glisson::registration_quality {

struct VideoSequenceOptions {
  VideoSequenceOptions() { stereo.step_px = 4; }
  vision::StereoOptions stereo;  // a point every four pixels: a millimetre or less of tissue
  vision::TrackOptions tracks;
  int skip = 0;                                // frames at the beginning
  int every = 1;                               // frame of the video, from the first that is taken
  int maximum_frames = 600;                    // 20 seconds; clouds, pictures and geodesics of more fill disks and days
  std::optional<std::filesystem::path> model;  // a surface file; absent: the frames' own, aligned globally
  std::optional<std::filesystem::path> landmarks;  // tracks.csv that an expert made; absent: tracked features

  // How many frames the video needs to have.
  [[nodiscard]] int needed() const { return skip + (maximum_frames - 1) * every + 1; }
};

struct VideoSequence {
  int frames = 0;
  int left_out = 0;  // frames that show hardly anything in depth
  int landmarks = 0;
  double mean_points = 0;  // of a cloud
  double mean_valid_fraction = 0;
  double epipolar_px = 0;  // of the first pair (vision/picture_check.h)
  // The global alignment's root mean squares, before it, after rigid motions and after warps; absent with a given model
  // or an expert's landmarks.
  std::optional<std::array<double, 3>> alignment_rms_mm;
  std::filesystem::path file;      // sequence.json
  std::vector<std::string> notes;  // frames left out, what the global alignment says
};

// A frame that was matched, told before the next one is: `cloud` is whole, with its rectified picture.
struct MatchedFrame {
  int number = 0;  // in the video, from 0
  const vision::StereoCloud& cloud;
  int followed = 0;  // landmarks known from before
};
using FrameMatched = std::function<void(const MatchedFrame&)>;

// Writes folder/sequence.json, f000.png, f000.ply, ..., tracks.csv, model.ply and the calibration (camera.json). Where
// the model is the frames' own and the landmarks are the tracked ones, benchmark.csv too (benchmark.h). A given model
// lies in no space that the alignment knows, so that such a sequence has no benchmark, and a note says so. Every cloud
// is the largest piece that hangs together. The folder must not exist or be empty ("sequence-folder-not-empty"). Fails
// as StereoSource (one video ends before the other), StereoMatcher, check_against_pictures, LandmarkTracker and
// align_globally do, and with "cancelled". Fails with "sequence-too-few-frames" (fewer than three frames show
// anything). Fails with "sequence-no-landmarks" where no model is given, and nothing could be followed to align the
// frames by. After a failure the folder is gone, or as empty as it was.
Result<VideoSequence> make_sequence(vision::StereoSource& video, const vision::StereoCalibration& calibration,
                                    const std::filesystem::path& folder, const VideoSequenceOptions& options = {},
                                    const Progress& progress = {}, const FrameMatched& matched = {});

}  // namespace glisson::registration_quality
