#include "scene/composite.h"

#include <algorithm>
#include <cmath>

namespace glisson::scene {
namespace {

std::uint8_t luminance(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>(std::lround(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]));
}

// A scene to be read by its channel alone: no words, no legend, on plain black; white vessels and tumours, which show
// the smallest shift, in a grey organ.
Scene stripped(Scene scene, const Camera& camera) {
  scene.camera = camera;
  scene.annotations = {Annotations::Orientation::hidden, Annotations::ScaleBar::hidden, "", "", "", 1, {}};
  scene.background = Background::black;
  for (SurfaceItem& item : scene.surfaces) {
    item.colouring.reset();
    const double grey = item.finish == Finish::glass ? 0.60 : 1.0;
    item.colour = {grey, grey, grey};
  }
  for (SliceItem& item : scene.slices) item.legend_title.clear();
  for (LandmarkItem& item : scene.landmarks) item.label.clear();
  for (ArrowItem& item : scene.arrows) item.label.clear();
  return scene;
}

// Red and blue alone look darker than the same grey: the darks are lifted, black stays black and white white.
Picture lifted(Picture picture) {
  constexpr double gamma = 0.65;
  for (std::uint8_t& value : picture.rgb) {
    value = static_cast<std::uint8_t>(std::lround(255 * std::pow(value / 255.0, gamma)));
  }
  return picture;
}

// The words of the comparison alone, on black: laid over the joined picture by taking the brighter of the two.
Scene words_of(const Comparison& comparison, const Camera& camera) {
  Scene words;
  words.camera = camera;
  words.background = Background::black;
  words.annotations = comparison.in_blue.annotations;
  words.annotations.key = {{{1.0, 0.25, 0.25}, comparison.red_label},
                           {{0.35, 0.45, 1.0}, comparison.blue_label},
                           {{0.80, 0.30, 0.95}, comparison.agreement_label}};
  words.landmarks = comparison.in_blue.landmarks;
  for (LandmarkItem& landmark : words.landmarks) landmark.radius_mm = 0.01;
  return words;
}

}  // namespace

Picture red_blue(const Picture& in_red, const Picture& in_blue) {
  GLISSON_ASSERT(in_red.width == in_blue.width && in_red.height == in_blue.height);
  Picture joined = in_red;
  for (std::size_t k = 0; k < joined.rgb.size(); k += 3) {
    joined.rgb[k] = luminance(&in_red.rgb[k]);
    joined.rgb[k + 1] = 0;
    joined.rgb[k + 2] = luminance(&in_blue.rgb[k]);
  }
  return joined;
}

Result<Picture> draw_red_blue(const Comparison& comparison, int width, int height) {
  const Camera camera = comparison.in_blue.camera.value_or(
      fit(comparison.in_blue, PatientView::surgeon, static_cast<double>(width) / height));
  const auto red = draw(stripped(comparison.in_red, camera), width, height);
  if (!red) return red;
  const auto blue = draw(stripped(comparison.in_blue, camera), width, height);
  if (!blue) return blue;
  const auto words = draw(words_of(comparison, camera), width, height);
  if (!words) return words;
  Picture joined = red_blue(lifted(*red), lifted(*blue));
  for (std::size_t k = 0; k < joined.rgb.size(); ++k) joined.rgb[k] = std::max(joined.rgb[k], words->rgb[k]);
  return joined;
}

}  // namespace glisson::scene
