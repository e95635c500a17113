// draw(): a View in a window that shows on no screen.

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <mutex>
#include <optional>
#include <thread>

#include "scene/offscreen.h"
#include "scene/view.h"

namespace glisson::scene {
namespace {

constexpr int smallest_side_px = 16;
constexpr int largest_side_px = 8192;

// Everything is drawn this many times larger each way and averaged down: smooth edges on every machine, the same with
// and without multisampling hardware.
constexpr int oversampling = 2;

Result<Picture> draw_on_this_thread(const Scene& scene, int width, int height);
Picture averaged_down(const vtkUnsignedCharArray& pixels, int width, int height);

}  // namespace

Result<Picture> draw(const Scene& scene, int width, int height) {
  if (std::min(width, height) < smallest_side_px || std::max(width, height) > largest_side_px) {
    return failure("picture-size",
                   GLISSON_TEXT("A picture has from {0} to {1} pixels a side; {2} x {3} were asked for."),
                   {std::to_string(smallest_side_px), std::to_string(largest_side_px), std::to_string(width),
                    std::to_string(height)});
  }
  if (auto fine = check_scene(scene); !fine) return failure(fine.error());
  // VTK's fonts are shared by the whole program: one picture at a time. On a thread of its own, because EGL refuses a
  // thread that has a window's OpenGL context current, as the desktop's has.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::optional<Result<Picture>> picture;
  std::thread([&] { picture = draw_on_this_thread(scene, width, height); }).join();
  return *picture;
}

namespace {

Result<Picture> draw_on_this_thread(const Scene& scene, int width, int height) {
  const int drawn_width = oversampling * width;
  const int drawn_height = oversampling * height;
  auto window = open_offscreen_window(drawn_width, drawn_height);
  if (!window) return failure(window.error());
  vtkNew<vtkRenderer> renderer;
  (*window)->AddRenderer(renderer);
  Picture picture;
  {
    View view(*renderer, oversampling);
    if (!scene.camera) view.set_camera(fit(scene, PatientView::surgeon, double(width) / height));
    if (auto shown = view.show(scene); !shown) return failure(shown.error());
    view.prepare_frame(drawn_width, drawn_height);
    (*window)->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    (*window)->GetPixelData(0, 0, drawn_width - 1, drawn_height - 1, 0, pixels);
    picture = averaged_down(*pixels, width, height);
  }
  (*window)->RemoveRenderer(renderer);
  return picture;
}

Picture averaged_down(const vtkUnsignedCharArray& pixels, int width, int height) {
  Picture picture{width, height, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto drawn_row = static_cast<std::size_t>(3 * oversampling * width);
  const unsigned char* from = const_cast<vtkUnsignedCharArray&>(pixels).GetPointer(0);
  for (int y = 0; y < height; ++y) {
    // VTK's rows begin at the bottom.
    const auto first_row = static_cast<std::size_t>(oversampling * (height - 1 - y));
    for (int x = 0; x < width; ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (std::size_t down = 0; down < oversampling; ++down) {
          for (std::size_t across = 0; across < oversampling; ++across) {
            const std::size_t column = oversampling * static_cast<std::size_t>(x) + across;
            sum += from[(first_row + down) * drawn_row + 3 * column + channel];
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
