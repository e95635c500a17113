// draw(): one frame of a Painter, larger than asked for and averaged down.

#include <mutex>
#include <optional>
#include <thread>

#include "scene/painter.h"
#include "scene/view.h"

namespace glisson::scene {
namespace {

constexpr int smallest_side_px = 16;
constexpr int maximum_drawn_px = 8192;

// Everything is drawn this many times larger each way and averaged down: smooth edges on every machine, the same with
// and without multisampling hardware.
constexpr int oversampling = 2;

Result<Picture> draw_on_this_thread(const Scene& scene, int width, int height);
Picture averaged_down(const DrawnFrame& drawn, int width, int height);

}  // namespace

Result<Picture> draw(const Scene& scene, int width, int height) {
  if (std::min(width, height) < smallest_side_px || std::max(width, height) > maximum_drawn_px) {
    return failure("picture-size",
                   GLISSON_TEXT("A picture has from {0} to {1} pixels a side; {2} x {3} were asked for."),
                   {std::to_string(smallest_side_px), std::to_string(maximum_drawn_px), std::to_string(width),
                    std::to_string(height)});
  }
  if (auto fine = check_scene(scene); !fine) return failure(fine.error());
  // One picture at a time: each takes memory for all its samples. On a thread of its own, because a thread has one
  // OpenGL context at a time, and the caller's may be in use.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::optional<Result<Picture>> picture;
  std::thread([&] { picture = draw_on_this_thread(scene, width, height); }).join();
  return *picture;
}

namespace {

Result<Picture> draw_on_this_thread(const Scene& scene, int width, int height) {
  View view;
  view.set_pixel_scale(oversampling);
  if (!scene.camera) view.set_camera(fit(scene, PatientView::surgeon, double(width) / height));
  if (auto shown = view.show(scene); !shown) return failure(shown.error());
  Painter painter;
  painter.set_transparency(Transparency::exact);
  return painter.paint(view.take_changes(oversampling * width, oversampling * height))
      .map([&](const DrawnFrame& drawn) { return averaged_down(drawn, width, height); });
}

Picture averaged_down(const DrawnFrame& drawn, int width, int height) {
  Picture picture{width, height, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto drawn_row = static_cast<std::size_t>(4 * oversampling * width);
  for (int y = 0; y < height; ++y) {
    const auto first_row = static_cast<std::size_t>(oversampling * y);
    for (int x = 0; x < width; ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (std::size_t down = 0; down < oversampling; ++down) {
          for (std::size_t across = 0; across < oversampling; ++across) {
            const std::size_t column = oversampling * static_cast<std::size_t>(x) + across;
            sum += drawn.bgrx[(first_row + down) * drawn_row + 4 * column + 2 - channel];
          }
        }
        constexpr int samples = oversampling * oversampling;
        picture.rgb[3 * (static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y)) +
                    channel] = static_cast<std::uint8_t>((sum + samples / 2) / samples);
      }
    }
  }
  return picture;
}

}  // namespace
}  // namespace glisson::scene
