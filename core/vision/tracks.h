#pragma once
// Landmarks G of a stereo video: features that are followed through the whole sequence. They are found again from frame
// to frame by what they look like, in both eyes at once.
//
// A feature of a frame is one that both eyes show, on one another's epipolar lines and in front of the camera. It
// continues a track where the two left pictures and the two right ones each name the other as the best. It must be
// clearly better than the second. They must agree, too: left to right, on in time, back to left and back in time is a
// closed round (cycle consistency; Geiger, Ziegler, Stiller 2011 match so). A match that moves unlike its neighbours is
// none. A track that is lost, behind a tool or a highlight, is looked for in the frames that follow, by what it looked
// like last.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::vision {

struct TrackOptions {
  int features = 1500;       // of each picture, the strongest
  double ratio = 0.85;       // of the best match's distance to the second best's, at most (Lowe 2004)
  double epipolar_px = 1.5;  // from the other eye's line, at most
  double nearest_mm = 30;    // as for the clouds
  double farthest_mm = 300;
  double fastest_mm = 15;           // from frame to frame, or since it was last seen
  double unlike_neighbours_mm = 4;  // from the median motion of the eight nearest matches, at most
  int longest_gap = 15;             // frames that a track may be unseen: half a second of video
  // Shorter tracks are not answered: frames, and the share of all frames. What lies between landmarks is judged in the
  // frames that show them all, and short tracks hardly ever meet.
  int shortest_track = 5;
  double minimum_share = 0.4;
};

struct Track {
  std::string id;
  std::vector<std::optional<Eigen::Vector3d>> positions_mm;  // one a frame, left camera; nothing where it was not seen
};

class LandmarkTracker {
 public:
  explicit LandmarkTracker(const StereoCalibration& calibration, const TrackOptions& options = {});
  LandmarkTracker(LandmarkTracker&&) noexcept;
  LandmarkTracker& operator=(LandmarkTracker&&) noexcept;
  ~LandmarkTracker();

  // The next frame. Failures: "stereo-image-sizes" (the two differ), "stereo-failed".
  Result<void> add(const Frame& left, const Frame& right);

  // How many landmarks the latest frame shows that were known before.
  [[nodiscard]] int followed() const;
  // What was followed so far, the longest first; ids g0, g1, ...
  [[nodiscard]] std::vector<Track> tracks() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace glisson::vision
