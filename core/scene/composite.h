#pragma once
// Two results in one picture: one in the red channel, one in the blue. Where they agree the picture is purple; where
// they disagree it turns red or blue. (The dissertation's figure 4.12 shows the atlas result in red and the one from
// MR elastography in blue.)

#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace glisson::scene {

// Channel by channel: red and blue are the two pictures' luminances (Rec. 709 weights on the sRGB values), green is
// zero. The pictures must have the same size, which is asserted.
[[nodiscard]] Picture red_blue(const Picture& in_red, const Picture& in_blue);

struct Comparison {
  Scene in_red;                 // the atlas result
  Scene in_blue;                // the result from MR elastography
  std::string red_label;        // "Red: atlas stiffness, 2.1 kPa"
  std::string blue_label;       // "Blue: stiffness from MR elastography"
  std::string agreement_label;  // "Purple: both agree"
};

// Draws both with the same camera: in_blue's, or one that fits it. Joins them, and writes in_blue's titles, warning and
// landmark names over the outcome, with a key of the three colours. Failures: those of draw().
Result<Picture> draw_red_blue(const Comparison& comparison, int width, int height);

}  // namespace glisson::scene
