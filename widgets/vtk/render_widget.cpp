#include "vtk/render_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <algorithm>
#include <chrono>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <string_view>

namespace glisson::widgets {
namespace {

bool draws_in_software(const GLubyte* gl_renderer) {
  return std::string_view(reinterpret_cast<const char*>(gl_renderer)).find("llvmpipe") != std::string_view::npos;
}

}  // namespace

struct RenderWidget::Vtk {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCallbackCommand> events;
};

RenderWidget::RenderWidget(QWidget* parent) : QOpenGLWidget(parent), vtk_(std::make_unique<Vtk>()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 100);
  vtk_->window->SetOwnContext(0);
  // Frames stay in VTK's framebuffer until paintGL copies them.
  vtk_->window->SetFrameBlitModeToNoBlit();
  vtk_->window->AddRenderer(vtk_->renderer);
  vtk_->events->SetClientData(this);
  vtk_->events->SetCallback([](vtkObject*, unsigned long event, void* client, void* answer) {
    auto* widget = static_cast<RenderWidget*>(client);
    switch (event) {
      case vtkCommand::WindowMakeCurrentEvent: widget->make_context_current(); break;
      case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(answer) =
            widget->context() != nullptr && QOpenGLContext::currentContext() == widget->context();
        break;
      case vtkCommand::WindowSupportsOpenGLEvent: *static_cast<int*>(answer) = 1; break;
      default: break;
    }
  });
  for (const auto event :
       {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowSupportsOpenGLEvent}) {
    vtk_->window->AddObserver(event, vtk_->events);
  }
  view_ = std::make_unique<scene::View>(*vtk_->renderer);
}

RenderWidget::~RenderWidget() {
  // Qt announces the context's end later, when this object is half gone.
  if (context() != nullptr) disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, nullptr);
  release_graphics();
  view_.reset();
  vtk_->window->RemoveRenderer(vtk_->renderer);
}

scene::View& RenderWidget::view() { return *view_; }
const scene::View& RenderWidget::view() const { return *view_; }

double RenderWidget::mm_per_pixel() const { return view_->camera().visible_height_mm / std::max(1, height()); }

void RenderWidget::initializeGL() {
  // The context changes when the widget is taken into another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &RenderWidget::release_graphics, Qt::UniqueConnection);
  vtk_->window->SetReadyForRendering(true);
  vtk_->window->OpenGLInit();
  // Multisampling and exact transparency each cost a software renderer more than half its frames.
  const bool slow = draws_in_software(context()->functions()->glGetString(GL_RENDERER));
  vtk_->window->SetMultiSamples(slow ? 0 : 4);
  view_->set_transparency(slow ? scene::Transparency::quick : scene::Transparency::exact);
}

void RenderWidget::paintGL() {
  const auto start = std::chrono::steady_clock::now();
  const int width = device_width();
  const int height = device_height();
  vtkOpenGLState* state = vtk_->window->GetState();
  // Qt has drawn since the last frame: VTK's idea of the OpenGL state is out of date.
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  const int drawn_width = std::max(width / shrink(), 1);
  const int drawn_height = std::max(height / shrink(), 1);
  vtk_->window->SetSize(drawn_width, drawn_height);
  view_->set_pixel_scale(devicePixelRatioF());  // another one when the window moves to another screen
  view_->prepare_frame(width, height, shrink());
  vtk_->window->Render();

  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  vtk_->window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  vtk_->window->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, drawn_width, drawn_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                        shrink() > 1 ? GL_LINEAR : GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // Qt composes by alpha, and a frame is opaque whatever was blended in it.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->Pop();
  last_frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// makeCurrent() also binds the widget's framebuffer behind the back of VTK's state, so only where it must be.
void RenderWidget::make_context_current() {
  if (context() == nullptr || QOpenGLContext::currentContext() == context()) return;
  makeCurrent();
  vtk_->window->GetState()->Reset();
}

void RenderWidget::release_graphics() {
  if (context() == nullptr) return;
  makeCurrent();
  vtk_->window->Finalize();
  doneCurrent();
}

}  // namespace glisson::widgets
