#pragma once
// Draws what a View shows, frame after frame, off screen: with EGL and no X server where there is one of the two.
//
// A painter belongs to the thread that made it: every call, and its end, come from there. Several painters may live on
// several threads; text is drawn one frame at a time, because VTK's fonts are shared by the whole program.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/view_changes.h"

namespace glisson::scene {

// A drawn frame: 8-bit blue, green, red and one byte without meaning, rows from the top, no padding.
struct DrawnFrame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgrx;
};

// How clear surfaces that overlap are put together: `exact` sorts every pixel; `quick` draws them in the scene's order
// over what is solid, several times faster. It is hard to tell from `exact` for one clear organ that comes last.
enum class Transparency { exact, quick };

class Painter {
 public:
  Painter();
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  // Without a choice: quick where a processor does the work of the graphics card.
  void set_transparency(Transparency transparency);

  // The next frame of the view that these changes were taken from. Fails, and stays as it was, where the machine has no
  // OpenGL 3.2 at all, not even in software ("drawing-unavailable").
  Result<DrawnFrame> paint(const ViewChanges& changes);

  // "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first frame.
  [[nodiscard]] const std::string& drawn_by() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// "VTK 9.1.0".
[[nodiscard]] std::string drawing_library();

}  // namespace glisson::scene
