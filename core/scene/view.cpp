#include "scene/view.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <algorithm>
#include <map>

#include "scene/drawing.h"
#include "scene/frame.h"
#include "scene/furniture.h"
#include "scene/markers.h"
#include "scene/overlay.h"
#include "scene/slice_actor.h"
#include "scene/surface_actor.h"

namespace glisson::scene {
namespace {

void light(vtkRenderer& renderer);
void paint_background(vtkRenderer& renderer, const Scene& scene);
std::vector<Legend> legends_of(const Scene& scene);
void place(vtkCamera& camera, const Frame& frame);

struct Hit {
  double distance_mm = 0;
  Eigen::Vector3d normal{0, 0, 1};
  std::array<int, 3> corners{};
  Eigen::Vector3d weights{1, 0, 0};
};
std::optional<Hit> first_hit(const geometry::Surface& surface, const Ray& ray);

}  // namespace

struct View::Parts {
  Parts(vtkRenderer& into, double scale)
      : renderer(into), pixel_scale(scale), overlay(into), markers(into), drawing(into) {}

  SurfaceActor* actor_of(const SurfaceId& surface) {
    const auto found = surfaces.find(surface);
    return found == surfaces.end() ? nullptr : found->second.get();
  }

  vtkRenderer& renderer;
  double pixel_scale;
  Scene scene;
  std::vector<Legend> legends;
  std::map<SurfaceId, std::unique_ptr<SurfaceActor>> surfaces;
  std::map<SurfaceId, geometry::Surface> cut_shapes;  // of surfaces that slices cut and that have moved
  std::vector<std::unique_ptr<SliceActor>> slices;
  std::vector<LineItem> lines;
  Overlay overlay;
  Markers markers;
  Drawing drawing;
  Frame frame;
  bool framed = false;  // whether a camera was ever chosen
  Transparency transparency = Transparency::exact;
};

View::View(vtkRenderer& renderer, double pixel_scale) : parts_(std::make_unique<Parts>(renderer, pixel_scale)) {
  parts_->drawing.set_line_scale(pixel_scale);
  light(renderer);
  // A few layers are enough for a clear liver with clear things in it.
  renderer.SetMaximumNumberOfPeels(4);
  renderer.SetOcclusionRatio(0);
}

View::~View() = default;

Result<void> View::show(const Scene& scene) {
  if (auto fine = check_scene(scene); !fine) return fine;
  Parts& parts = *parts_;
  parts.scene = scene;
  parts.surfaces.clear();
  parts.slices.clear();
  parts.cut_shapes.clear();
  for (const SurfaceItem& item : scene.surfaces) {
    parts.surfaces.emplace(item.surface, std::make_unique<SurfaceActor>(parts.renderer, item));
  }
  for (const SliceItem& item : scene.slices) {
    parts.slices.push_back(std::make_unique<SliceActor>(parts.renderer, item));
    parts.slices.back()->set_line_scale(parts.pixel_scale);
  }
  parts.legends = legends_of(scene);
  set_landmarks(scene.landmarks);
  set_arrows(scene.arrows);
  paint_background(parts.renderer, scene);
  if (scene.camera) {
    set_camera(*scene.camera);
  } else if (!parts.framed) {
    set_camera(fit(scene, PatientView::surgeon, 1.4));
  }
  return {};
}

void View::move_surface(const SurfaceId& surface, const std::vector<Eigen::Vector3d>& points_mm) {
  GLISSON_ASSERT(points_mm.size() == surface->points_mm.size());
  if (SurfaceActor* actor = parts_->actor_of(surface)) actor->move(points_mm);
  const auto cuts_it = [&](const CutLine& line) { return line.surface == surface; };
  for (const auto& slice : parts_->slices) {
    const auto& cuts = slice->item().cuts;
    if (std::none_of(cuts.begin(), cuts.end(), cuts_it)) continue;
    auto& now = parts_->cut_shapes.try_emplace(surface, *surface).first->second;
    now.points_mm = points_mm;
    slice->recut(surface.get(), now);
  }
}

void View::recolour_surface(const SurfaceId& surface, const std::vector<double>& values) {
  if (SurfaceActor* actor = parts_->actor_of(surface)) actor->recolour(values);
}

void View::set_visibility(const SurfaceId& surface, Visibility visibility) {
  if (SurfaceActor* actor = parts_->actor_of(surface)) actor->set_shown(visibility == Visibility::shown);
}

void View::set_landmarks(const std::vector<LandmarkItem>& landmarks) {
  parts_->scene.landmarks = landmarks;
  parts_->markers.set_landmarks(landmarks);
}

void View::set_arrows(const std::vector<ArrowItem>& arrows) {
  parts_->scene.arrows = arrows;
  parts_->markers.set_arrows(arrows);
}

void View::set_rods(const std::vector<RodItem>& rods) { parts_->markers.set_rods(rods); }

void View::set_crosshair(const std::optional<CrosshairItem>& crosshair) { parts_->scene.crosshair = crosshair; }

void View::set_lines(const std::vector<LineItem>& lines) { parts_->lines = lines; }

void View::turn_slice(std::size_t slice, const Eigen::Vector3d& normal) {
  GLISSON_ASSERT(slice < parts_->slices.size());
  parts_->slices[slice]->turn_to(normal);
}

void View::move_slice(std::size_t slice, const Eigen::Vector3d& center_mm) {
  GLISSON_ASSERT(slice < parts_->slices.size());
  parts_->slices[slice]->move_to(center_mm);
}

void View::set_window(std::size_t slice, double center, double width) {
  GLISSON_ASSERT(slice < parts_->slices.size());
  parts_->slices[slice]->set_window(center, width);
}

void View::set_furniture(const Furniture& furniture) { parts_->scene.furniture = furniture; }

void View::set_drawn_lines(const std::vector<DrawnLines>& lines) { parts_->drawing.set_lines(lines); }

void View::set_drawn_cells(const std::optional<DrawnCells>& cells) { parts_->drawing.set_cells(cells); }

void View::set_pixel_scale(double pixel_scale) {
  if (pixel_scale == parts_->pixel_scale) return;
  parts_->pixel_scale = pixel_scale;
  for (const auto& slice : parts_->slices) slice->set_line_scale(pixel_scale);
  parts_->drawing.set_line_scale(pixel_scale);
}

void View::set_transparency(Transparency transparency) { parts_->transparency = transparency; }

void View::set_detail(Detail detail) {
  for (const auto& [surface, actor] : parts_->surfaces) actor->set_detail(detail);
}

void View::set_camera(const Camera& camera) {
  parts_->frame.camera = camera;
  parts_->framed = true;
}

const Camera& View::camera() const { return parts_->frame.camera; }

void View::prepare_frame(int width, int height, int shrink) {
  Parts& parts = *parts_;
  parts.frame.width = std::max(width, 1);
  parts.frame.height = std::max(height, 1);
  place(*parts.renderer.GetActiveCamera(), parts.frame);
  parts.renderer.SetUseDepthPeeling(parts.transparency == Transparency::exact ? 1 : 0);
  for (const auto& [surface, actor] : parts.surfaces) actor->set_transparency(parts.transparency);
  parts.renderer.ResetCameraClippingRange();
  for (const auto& slice : parts.slices) {
    slice->lift_lines(-parts.frame.camera.sight * 0.002 * parts.frame.camera.visible_height_mm);
  }
  parts.drawing.lift(-parts.frame.camera.sight * 0.002 * parts.frame.camera.visible_height_mm);
  Frame drawn = parts.frame;
  drawn.width = std::max(drawn.width / shrink, 1);
  drawn.height = std::max(drawn.height / shrink, 1);
  lay_out(parts.overlay, drawn,
          {parts.scene.furniture, parts.legends, parts.scene.landmarks, parts.scene.arrows, parts.scene.crosshair,
           parts.lines, parts.scene.background},
          parts.pixel_scale / shrink);
}

std::optional<View::Pick> View::pick(double x, double y) const {
  const Ray ray = parts_->frame.ray_through(x, parts_->frame.height - y);
  std::optional<Pick> nearest;
  double nearest_mm = 0;
  for (const auto& [surface, actor] : parts_->surfaces) {
    if (!actor->shown()) continue;
    const std::optional<Hit> hit = first_hit(actor->surface(), ray);
    if (!hit || (nearest && hit->distance_mm >= nearest_mm)) continue;
    nearest_mm = hit->distance_mm;
    nearest = Pick{surface, ray.origin_mm + hit->distance_mm * ray.direction, hit->normal, hit->corners, hit->weights};
  }
  return nearest;
}

Eigen::Vector3d View::position_in_focal_plane(double x, double y) const {
  return parts_->frame.in_focal_plane(x, parts_->frame.height - y);
}

Eigen::Vector3d View::position_beside(const Eigen::Vector3d& place_mm, double x, double y) const {
  const Frame& frame = parts_->frame;
  const Ray ray = frame.ray_through(x, frame.height - y);
  const double along_mm =
      frame.camera.sight.dot(place_mm - ray.origin_mm) / std::max(frame.camera.sight.dot(ray.direction), 1e-6);
  return ray.origin_mm + along_mm * ray.direction;
}

Eigen::Vector2d View::pixel_of(const Eigen::Vector3d& place_mm) const {
  const Eigen::Vector2d from_below = parts_->frame.pixel_of(place_mm);
  return {from_below.x(), parts_->frame.height - from_below.y()};
}

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

void place(vtkCamera& camera, const Frame& frame) {
  const Eigen::Vector3d eye = frame.eye_mm();
  const Eigen::Vector3d& focus = frame.camera.focus_mm;
  const Eigen::Vector3d& up = frame.camera.up;
  camera.SetPosition(eye.x(), eye.y(), eye.z());
  camera.SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera.SetViewUp(up.x(), up.y(), up.z());
  camera.SetViewAngle(perspective_angle_deg);
  camera.SetParallelProjection(frame.camera.projection == Projection::parallel ? 1 : 0);
  camera.SetParallelScale(0.5 * frame.camera.visible_height_mm);
}

// Moeller and Trumbore's test over all triangles; both sides count.
std::optional<Hit> first_hit(const geometry::Surface& surface, const Ray& ray) {
  std::optional<Hit> nearest;
  for (const auto& triangle : surface.triangles) {
    const auto& a = surface.points_mm[static_cast<std::size_t>(triangle[0])];
    const Eigen::Vector3d along_b = surface.points_mm[static_cast<std::size_t>(triangle[1])] - a;
    const Eigen::Vector3d along_c = surface.points_mm[static_cast<std::size_t>(triangle[2])] - a;
    const Eigen::Vector3d across = ray.direction.cross(along_c);
    const double determinant = along_b.dot(across);
    if (std::abs(determinant) < 1e-12) continue;
    const Eigen::Vector3d from_a = ray.origin_mm - a;
    const double b = from_a.dot(across) / determinant;
    if (b < 0 || b > 1) continue;
    const Eigen::Vector3d other = from_a.cross(along_b);
    const double c = ray.direction.dot(other) / determinant;
    if (c < 0 || b + c > 1) continue;
    const double distance_mm = along_c.dot(other) / determinant;
    if (distance_mm <= 0 || (nearest && distance_mm >= nearest->distance_mm)) continue;
    nearest = Hit{distance_mm, along_b.cross(along_c).normalized(), triangle, {1 - b - c, b, c}};
  }
  return nearest;
}

}  // namespace
}  // namespace glisson::scene
