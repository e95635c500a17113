#pragma once
// What a laparoscope's picture shows besides tissue.

#include <cstdint>
#include <string>
#include <vector>

#include "vision/frame.h"

namespace glisson::vision {

enum class Masking { off, on };

// Brightness and greyness are of 8-bit colours. Chosen on pictures of laparoscopes; none of the rules is learned, so a
// white organ or a coloured tool is mistaken.
struct MaskOptions {
  // A reflection shows nothing of the tissue. It is saturated in all colours, or it adds light to all colours of a
  // small place. Such a place is greyer than usual, and above the median of the darkest colour around it, over a tenth
  // of the picture's height.
  int highlight_brightness = 240;
  int highlight_above_surround = 40;
  int darkest = 10;  // below in all colours: the black border of the scope
  Masking tools = Masking::on;
  // Steel is grey: its colours differ by less than this share of what the picture's usually do. It must reach the
  // scope's border, as tools do, and fill at least the second share of the picture.
  double tool_greyness = 0.35;
  double smallest_tool = 0.005;
  Masking smoke = Masking::on;
  // Smoke adds light to all colours and takes contrast. Its darkest colour is bright, and it hardly differs from place
  // to place (standard deviation over about a twentieth of the picture's height).
  int smoke_brightness = 140;
  double smoke_contrast = 7;
};

// How much of the picture each thing covers, 0..1; a pixel counts for the first that names it.
struct MaskedShares {
  double border = 0;
  double highlights = 0;
  double tools = 0;
  double smoke = 0;
};

struct UsablePixels {
  std::vector<std::uint8_t> usable;  // usable[x + width * y]: 255 for tissue, 0 for anything else
  MaskedShares shares;
};

// 255 for a tool, 0 for anything else, by the same rule.
[[nodiscard]] std::vector<std::uint8_t> tool_pixels(const Frame& frame, const MaskOptions& options = {});

// A picture without colours (a grey camera's) has no tools by this rule.
[[nodiscard]] UsablePixels usable_pixels(const Frame& frame, const MaskOptions& options = {});

}  // namespace glisson::vision
