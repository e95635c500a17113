#include "scene/painter.h"

// glew must come before any other OpenGL header.
#include <GL/glew.h>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVersion.h>
#include <algorithm>
#include <cstring>
#include <string_view>

#include "scene/internal/annotations.h"
#include "scene/internal/backdrop_actor.h"
#include "scene/internal/markers.h"
#include "scene/internal/offscreen.h"
#include "scene/internal/overlay.h"
#include "scene/internal/slice_actor.h"
#include "scene/internal/surface_actor.h"

namespace glisson::scene {
namespace {

// A bright light from the upper left of the viewer, a weak one from the right so that no side is black, and a rim
// light from behind that sets tissue off from the background. They move with the viewer.
void light(vtkRenderer& renderer) {
  struct Lamp {
    std::array<double, 3> from;  // in the viewer's right, up, towards the viewer
    double intensity;
    Colour colour;
  };
  const std::array<Lamp, 3> lamps{{{{-0.5, 0.7, 1.0}, 0.86, {1.0, 0.98, 0.95}},
                                   {{0.9, -0.2, 0.6}, 0.30, {0.85, 0.92, 1.0}},
                                   {{0.3, 0.6, -1.0}, 0.35, {0.90, 0.95, 1.0}}}};
  renderer.GetLights()->RemoveAllItems();
  renderer.AutomaticLightCreationOff();
  for (const Lamp& lamp : lamps) {
    vtkNew<vtkLight> shining;
    shining->SetLightTypeToCameraLight();
    shining->SetPosition(lamp.from[0], lamp.from[1], lamp.from[2]);
    shining->SetFocalPoint(0, 0, 0);
    shining->SetIntensity(lamp.intensity);
    shining->SetColor(lamp.colour.red, lamp.colour.green, lamp.colour.blue);
    renderer.AddLight(shining);
  }
}

// Slices want a flat black around them, as on a reading station; space has a quiet gradient.
void paint_background(vtkRenderer& renderer, const Scene& scene) {
  const bool slices_only = scene.surfaces.empty() && !scene.slices.empty();
  if (scene.background == Background::light) {
    renderer.SetBackground(0.90, 0.92, 0.94);
    renderer.SetBackground2(1.0, 1.0, 1.0);
  } else {
    renderer.SetBackground(0.055, 0.063, 0.078);
    renderer.SetBackground2(0.135, 0.157, 0.192);
  }
  renderer.SetGradientBackground(!slices_only && scene.background != Background::black);
  if (slices_only) renderer.SetBackground(0.02, 0.022, 0.027);
  if (scene.background == Background::black) renderer.SetBackground(0, 0, 0);
}

std::vector<Legend> legends_of(const Scene& scene) {
  std::vector<Legend> legends;
  const auto add = [&](Legend legend) {
    const auto same = [&](const Legend& other) { return other.title == legend.title; };
    if (legend.title.empty() || std::any_of(legends.begin(), legends.end(), same)) return;
    legends.push_back(std::move(legend));
  };
  for (const SurfaceItem& item : scene.surfaces) {
    if (item.colouring) add({item.colouring->title, item.colouring->map, item.colouring->range});
  }
  for (const SliceItem& item : scene.slices) {
    add({item.legend_title,
         item.map,
         {item.window_center - 0.5 * item.window_width, item.window_center + 0.5 * item.window_width}});
  }
  return legends;
}

void place(vtkCamera& camera, const Viewport& viewport) {
  const Eigen::Vector3d eye = viewport.eye_mm();
  const Eigen::Vector3d& focus = viewport.camera.focus_mm;
  const Eigen::Vector3d& up = viewport.camera.up;
  camera.SetPosition(eye.x(), eye.y(), eye.z());
  camera.SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera.SetViewUp(up.x(), up.y(), up.z());
  camera.SetViewAngle(perspective_angle_deg);
  camera.SetParallelProjection(viewport.camera.projection == Projection::parallel ? 1 : 0);
  camera.SetParallelScale(0.5 * viewport.camera.visible_height_mm);
}

bool same_colour(const Colour& a, const Colour& b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

// Whether what draws one item draws the other, but for where its points are.
bool look_alike(const SurfaceItem& a, const SurfaceItem& b) {
  return a.surface == b.surface && same_colour(a.colour, b.colour) && a.opacity == b.opacity && a.finish == b.finish &&
         !a.colouring && !b.colouring;
}

}  // namespace

struct Painter::Impl {
  struct Drawn {
    SurfaceItem item;
    std::unique_ptr<SurfaceActor> actor;
    bool moved = false;
  };

  Result<void> open();
  void apply(const ViewChanges& changes);
  void build(const Scene& wanted, const std::map<SurfaceId, Points>& moved);
  void change_slices(const std::map<std::size_t, ViewChanges::Slice>& changes);
  void move(const SurfaceId& surface, const Points& points_mm);
  void hang(const std::optional<Backdrop>& wanted);
  void lay_out_viewport(const Viewport& viewport, int shrink);
  DrawnFrame read(int width, int height);

  vtkSmartPointer<vtkRenderWindow> window;  // none before the first frame
  vtkNew<vtkRenderer> renderer;
  std::optional<Transparency> transparency;
  std::string drawn_by;
  bool slow = false;  // a processor does the work of the graphics card
  double pixel_scale = 1;
  Detail detail = Detail::full;
  Scene scene;
  std::vector<Legend> legends;
  std::map<SurfaceId, Drawn> surfaces;
  std::map<SurfaceId, geometry::Surface> cut_shapes;  // of surfaces that slices cut and that have moved
  std::vector<std::unique_ptr<SliceActor>> slices;
  std::vector<LineItem> lines;
  std::unique_ptr<BackdropActor> backdrop;
  Overlay overlay{*renderer};
  Markers markers{*renderer};
  Drawing drawing{*renderer};
};

Painter::Painter() : impl_(std::make_unique<Impl>()) {
  light(*impl_->renderer);
  // A few layers are enough for a clear liver with clear things in it.
  impl_->renderer->SetMaximumNumberOfPeels(4);
  impl_->renderer->SetOcclusionRatio(0);
}

Painter::~Painter() {
  const auto window = impl_->window;
  if (window) window->MakeCurrent();  // what is let go of here lives in its context
  if (window) window->RemoveRenderer(impl_->renderer);
  impl_.reset();
}

void Painter::set_transparency(Transparency transparency) { impl_->transparency = transparency; }

const std::string& Painter::drawn_by() const { return impl_->drawn_by; }

Result<DrawnFrame> Painter::paint(const ViewChanges& changes) {
  Impl& parts = *impl_;
  if (!parts.window) {
    if (auto opened = parts.open(); !opened) return failure(opened.error());
  }
  parts.window->MakeCurrent();  // another painter may have drawn on this thread since
  parts.apply(changes);
  const int width = std::max(changes.viewport.width / changes.shrink, 1);
  const int height = std::max(changes.viewport.height / changes.shrink, 1);
  parts.window->SetSize(width, height);
  parts.lay_out_viewport(changes.viewport, changes.shrink);
  parts.window->Render();
  return parts.read(width, height);
}

Result<void> Painter::Impl::open() {
  constexpr int any_px = 64;
  auto opened = open_offscreen_window(any_px, any_px);
  if (!opened) return failure(opened.error());
  window = *opened;
  window->AddRenderer(renderer);
  window->Start();
  if (const GLubyte* name = glGetString(GL_RENDERER)) drawn_by = reinterpret_cast<const char*>(name);
  slow = std::string_view(drawn_by).find("llvmpipe") != std::string_view::npos;
  if (!transparency) {
    // Multisampling and exact transparency each cost a software renderer more than half its frames.
    window->SetMultiSamples(slow ? 0 : 4);
    transparency = slow ? Transparency::quick : Transparency::exact;
  }
  return {};
}

void Painter::Impl::apply(const ViewChanges& changes) {
  if (changes.pixel_scale) {
    pixel_scale = *changes.pixel_scale;
    for (const auto& slice : slices) slice->set_line_scale(pixel_scale);
    drawing.set_line_scale(pixel_scale);
  }
  if (changes.scene) build(*changes.scene, changes.moved);
  change_slices(changes.slices);
  for (const auto& [surface, points_mm] : changes.moved) move(surface, points_mm);
  for (const auto& [surface, values] : changes.recoloured) surfaces.at(surface).actor->recolour(values);
  for (const auto& [surface, visibility] : changes.visibility) {
    surfaces.at(surface).actor->set_shown(visibility == Visibility::shown);
  }
  if (changes.landmarks) scene.landmarks = *changes.landmarks;
  if (changes.arrows) scene.arrows = *changes.arrows;
  if (changes.scene || changes.landmarks) markers.set_landmarks(scene.landmarks);
  if (changes.scene || changes.arrows) markers.set_arrows(scene.arrows);
  if (changes.rods) markers.set_rods(*changes.rods);
  if (changes.crosshair) scene.crosshair = *changes.crosshair;
  if (changes.lines) lines = *changes.lines;
  if (changes.annotations) scene.annotations = *changes.annotations;
  if (changes.drawn_lines) drawing.set_lines(*changes.drawn_lines);
  if (changes.drawn_cells) drawing.set_cells(*changes.drawn_cells);
  if (changes.backdrop) hang(*changes.backdrop);
  if (changes.detail) detail = *changes.detail;
  if (backdrop) backdrop->set_detail(detail);
  if (changes.scene || changes.detail) {
    for (const auto& [surface, drawn] : surfaces) drawn.actor->set_detail(detail);
  }
}

// Surfaces that look as before stay as they are, with what they hold in the graphics card's memory.
void Painter::Impl::build(const Scene& wanted, const std::map<SurfaceId, Points>& moved) {
  scene = wanted;
  std::map<SurfaceId, Drawn> before = std::exchange(surfaces, {});
  slices.clear();
  cut_shapes.clear();
  for (const SurfaceItem& item : scene.surfaces) {
    Drawn& drawn = surfaces[item.surface];
    const auto known = before.find(item.surface);
    if (known != before.end() && look_alike(known->second.item, item)) {
      drawn = std::move(known->second);
      before.erase(known);
      drawn.actor->draw_last();
      drawn.actor->set_shown(true);
      if (drawn.moved && moved.count(item.surface) == 0) drawn.actor->move(item.surface->points_mm);
      drawn.moved = drawn.moved && moved.count(item.surface) != 0;
    } else {
      drawn = {item, std::make_unique<SurfaceActor>(*renderer, item), false};
    }
  }
  for (const SliceItem& item : scene.slices) {
    slices.push_back(std::make_unique<SliceActor>(*renderer, item));
    slices.back()->set_line_scale(pixel_scale);
  }
  legends = legends_of(scene);
  paint_background(*renderer, scene);
}

void Painter::Impl::change_slices(const std::map<std::size_t, ViewChanges::Slice>& changes) {
  for (const auto& [index, change] : changes) {
    SliceActor& slice = *slices.at(index);
    slice.place(change.center_mm.value_or(slice.item().center_mm), change.normal.value_or(slice.item().normal));
    if (!change.window) continue;
    slice.set_window(change.window->center, change.window->width);
    scene.slices[index].window_center = change.window->center;
    scene.slices[index].window_width = change.window->width;
    legends = legends_of(scene);
  }
}

void Painter::Impl::move(const SurfaceId& surface, const Points& points_mm) {
  const std::vector<Eigen::Vector3d>& now_mm = points_mm ? *points_mm : surface->points_mm;
  if (const auto drawn = surfaces.find(surface); drawn != surfaces.end()) {
    drawn->second.actor->move(now_mm);
    drawn->second.moved = points_mm != nullptr;
  }
  for (const auto& slice : slices) {
    const auto& cuts = slice->item().cuts;
    if (std::none_of(cuts.begin(), cuts.end(), [&](const CutLine& line) { return line.surface == surface; })) continue;
    auto& now = cut_shapes.try_emplace(surface, *surface).first->second;
    now.points_mm = now_mm;
    slice->recut(surface.get(), now);
  }
}

void Painter::Impl::hang(const std::optional<Backdrop>& wanted) {
  backdrop.reset();
  if (!wanted) return;
  const auto drawn = slow ? BackdropActor::Drawn::by_processor : BackdropActor::Drawn::by_card;
  backdrop = std::make_unique<BackdropActor>(*window, *renderer, *wanted, drawn);
}

void Painter::Impl::lay_out_viewport(const Viewport& viewport, int shrink) {
  place(*renderer->GetActiveCamera(), viewport);
  renderer->SetUseDepthPeeling(*transparency == Transparency::exact ? 1 : 0);
  for (const auto& [surface, drawn] : surfaces) drawn.actor->sort_what_is_clear(*transparency == Transparency::exact);
  if (backdrop) backdrop->stand_behind(bounds(scene).center_mm(), viewport.camera.sight);
  renderer->ResetCameraClippingRange();
  const Eigen::Vector3d towards_viewer_mm = -viewport.camera.sight * 0.002 * viewport.camera.visible_height_mm;
  for (const auto& slice : slices) slice->lift_lines(towards_viewer_mm);
  drawing.lift(towards_viewer_mm);
  Viewport drawn = viewport;
  drawn.width = std::max(drawn.width / shrink, 1);
  drawn.height = std::max(drawn.height / shrink, 1);
  lay_out(overlay, drawn,
          {scene.annotations, legends, scene.landmarks, scene.arrows, scene.crosshair, lines, scene.background},
          pixel_scale / shrink);
}

std::string drawing_library() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }

DrawnFrame Painter::Impl::read(int width, int height) {
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  opengl->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  opengl->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  DrawnFrame frame{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_BYTE, frame.bgrx.data());
  // OpenGL's rows begin at the bottom.
  for (int y = 0; y < height / 2; ++y) {
    std::uint8_t* low = &frame.bgrx[row * static_cast<std::size_t>(y)];
    std::swap_ranges(low, low + row, &frame.bgrx[row * static_cast<std::size_t>(height - 1 - y)]);
  }
  return frame;
}

}  // namespace glisson::scene
