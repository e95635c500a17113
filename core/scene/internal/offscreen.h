#pragma once
// A render window that shows on no screen. VTK types may stand here.

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <memory>

#include "base/result.h"

namespace glisson::scene {

// An OpenGL window of that size in memory. Where the machine has EGL it needs no display (Mesa's surfaceless platform,
// or a graphics card's own). Else it goes through the X server of $DISPLAY. Fails with "drawing-unavailable" when
// neither is there. It belongs to the calling thread until it is destroyed there.
Result<vtkSmartPointer<vtkRenderWindow>> open_offscreen_window(int width, int height);

}  // namespace glisson::scene
