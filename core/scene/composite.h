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
  Scene in_red;            // the atlas result
  Scene in_blue;           // the result from MR elastography
  std::string red_label;   // "Atlas stiffness, 2.1 kPa"
  std::string blue_label;  // "MRE stiffness"
};

// Draws both with the same camera (that of in_blue, or one that shows both), joins them, and writes titles, labels and
// in_blue's warning over the outcome in white. Landmarks and arrows are drawn in both.
Result<Picture> draw_red_blue(const Comparison& comparison, int width, int height);

}  // namespace glisson::scene
