#pragma once
// What stereo saw of a pair, to look at: the rectified left picture beside its depths.

#include "vision/stereo.h"

namespace glisson::scene {

// Twice as wide as the left picture; near places are bright, and black is what was not seen. Each point fills a square
// of `step_px`, as far apart as the cloud's points are (StereoOptions::step_px).
[[nodiscard]] vision::Frame depth_picture(const vision::StereoCloud& cloud, int step_px = 1);

}  // namespace glisson::scene
