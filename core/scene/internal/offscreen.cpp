#include "scene/internal/offscreen.h"

// glew must come before any other OpenGL header.
#include <GL/glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>

namespace glisson::scene {
namespace {

// GLEW_ERROR_NO_GLX_DISPLAY: glew has found every OpenGL function and then misses an X server, which we do not need.
constexpr GLenum glew_misses_only_x = 4;

EGLDisplay egl_display();

// An EGL context that draws into framebuffer objects alone.
class SurfacelessContext {
 public:
  SurfacelessContext() {
    if (egl_display() == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return;
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(egl_display(), wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) return;
    const std::array<EGLint, 7> version{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(egl_display(), config, EGL_NO_CONTEXT, version.data());
  }
  ~SurfacelessContext() {
    if (!valid()) return;
    release();
    eglDestroyContext(egl_display(), context_);
  }
  SurfacelessContext(const SurfacelessContext&) = delete;
  SurfacelessContext& operator=(const SurfacelessContext&) = delete;

  [[nodiscard]] bool valid() const { return context_ != EGL_NO_CONTEXT; }
  [[nodiscard]] bool current() const { return valid() && eglGetCurrentContext() == context_; }
  bool make_current() {
    return valid() && eglMakeCurrent(egl_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_FALSE;
  }
  void release() {
    if (current()) eglMakeCurrent(egl_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

 private:
  EGLContext context_ = EGL_NO_CONTEXT;
};

// Debian's VTK knows neither EGL nor OSMesa: this window brings its own context.
class SurfacelessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static SurfacelessWindow* New();
  vtkTypeMacro(SurfacelessWindow, vtkGenericOpenGLRenderWindow)

      bool open() {
    return context_.make_current() && (OpenGLInit(), GlewInitValid);
  }
  void MakeCurrent() override { context_.make_current(); }
  bool IsCurrent() override { return context_.current(); }
  int SupportsOpenGL() override { return context_.valid() ? 1 : 0; }
  void ReleaseCurrent() override { context_.release(); }

  void OpenGLInitContext() override {
    ContextCreationTime.Modified();
    if (Initialized) return;
    glewExperimental = GL_TRUE;
    const GLenum outcome = glewInit();
    GlewInitValid = (outcome == GLEW_OK || outcome == glew_misses_only_x) && GLEW_VERSION_3_2;
    if (!GlewInitValid) return;
    Initialized = true;
    std::array<GLfloat, 2> line_widths{1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, line_widths.data());
    MaximumHardwareLineWidth = std::max(1.0F, line_widths[1]);
  }

 protected:
  SurfacelessWindow() = default;
  ~SurfacelessWindow() override {
    // While our context still exists; the base class would call it when it is gone.
    if (context_.make_current()) Finalize();
  }

 private:
  SurfacelessContext context_;
};
vtkStandardNewMacro(SurfacelessWindow)

    EGLDisplay open_egl_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) return EGL_NO_DISPLAY;
  const auto opens = [](EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) != EGL_FALSE;
  };
  if (EGLDisplay mesa = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr); opens(mesa)) {
    return mesa;
  }
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 8> devices{};
  EGLint count = 0;
  if (query_devices == nullptr ||
      query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) {
    return EGL_NO_DISPLAY;
  }
  for (EGLint k = 0; k < count; ++k) {
    EGLDisplay card = get_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(k)], nullptr);
    if (opens(card)) return card;
  }
  return EGL_NO_DISPLAY;
}

// Opened once for the whole program and left open to its end, as the drivers want it.
EGLDisplay egl_display() {
  static const EGLDisplay display = open_egl_display();
  return display;
}

}  // namespace

Result<vtkSmartPointer<vtkRenderWindow>> open_offscreen_window(int width, int height) {
  vtkSmartPointer<vtkRenderWindow> window;
  const auto surfaceless = vtkSmartPointer<SurfacelessWindow>::New();
  if (surfaceless->open()) {
    surfaceless->SetOwnContext(0);
    surfaceless->SetFrameBlitModeToNoBlit();
    window = surfaceless;
  } else if (const char* display = std::getenv("DISPLAY"); display != nullptr && *display != '\0') {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    window->OffScreenRenderingOn();
    window->SetShowWindow(false);
  } else {
    return failure(Error{"drawing-unavailable",
                         GLISSON_TEXT("There is nothing to draw with: neither EGL with OpenGL 3.2 nor an X server."),
                         {},
                         GLISSON_TEXT("Install Mesa's drivers (on Debian: libegl-mesa0 and libgl1-mesa-dri)."),
                         {}});
  }
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

}  // namespace glisson::scene
