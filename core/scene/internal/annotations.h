#pragma once
// Titles, scale bar, legends, orientation letters and labels, laid out on the overlay of one frame.

#include <vector>

#include "scene/internal/overlay.h"
#include "scene/internal/viewport.h"
#include "scene/scene.h"

namespace glisson::scene {

struct Legend {
  std::string title;
  ColourMap map = ColourMap::viridis;
  std::array<double, 2> range{0, 1};
};

// Everything flat that a frame shows, in the order in which it is laid out.
struct FlatContent {
  const Annotations& annotations;
  const std::vector<Legend>& legends;
  const std::vector<LandmarkItem>& landmarks;
  const std::vector<ArrowItem>& arrows;
  const std::optional<CrosshairItem>& crosshair;
  const std::vector<LineItem>& lines;
  Background background = Background::dark;
};

void lay_out(Overlay& overlay, const Viewport& viewport, const FlatContent& content, double pixel_scale);

}  // namespace glisson::scene
