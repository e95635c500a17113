#include "scene/view.h"

#include <Eigen/Geometry>

#include "geometry/line_and_triangle.h"

namespace glisson::scene {
namespace {

struct Hit {
  double distance_mm = 0;
  Eigen::Vector3d normal{0, 0, 1};
  std::array<int, 3> corners{};
  Eigen::Vector3d weights{1, 0, 0};
};

// Of all triangles, seen from either side.
std::optional<Hit> first_hit(const std::vector<std::array<int, 3>>& triangles,
                             const std::vector<Eigen::Vector3d>& points_mm, const Ray& ray) {
  std::optional<Hit> nearest;
  for (const auto& triangle : triangles) {
    const auto& a = points_mm[static_cast<std::size_t>(triangle[0])];
    const auto& b = points_mm[static_cast<std::size_t>(triangle[1])];
    const auto& c = points_mm[static_cast<std::size_t>(triangle[2])];
    const auto met = geometry::line_meets_triangle(ray.origin_mm, ray.direction, a, b, c);
    if (!met || met->at <= 0 || (nearest && met->at >= nearest->distance_mm)) continue;
    nearest = Hit{met->at, (b - a).cross(c - a).normalized(), triangle, {1 - met->b - met->c, met->b, met->c}};
  }
  return nearest;
}

}  // namespace

Result<void> View::show(const Scene& scene) {
  if (auto fine = check_scene(scene); !fine) return fine;
  surfaces_.clear();
  cut_.clear();
  for (const SurfaceItem& item : scene.surfaces) surfaces_[item.surface] = {};
  for (const SliceItem& slice : scene.slices) {
    for (const CutLine& cut : slice.cuts) cut_[cut.surface] = {};
  }
  slices_ = scene.slices.size();
  changes_.scene = scene;
  changes_.moved.clear();
  changes_.recoloured.clear();
  changes_.visibility.clear();
  changes_.slices.clear();
  changes_.landmarks.reset();
  changes_.arrows.reset();
  changes_.crosshair.reset();
  changes_.annotations.reset();
  if (scene.camera) {
    set_camera(*scene.camera);
  } else if (!framed_) {
    set_camera(fit(scene, PatientView::surgeon, 1.4));
  }
  return {};
}

void View::move_surface(const SurfaceId& surface, const Points& points_mm) {
  GLISSON_ASSERT(!points_mm || points_mm->size() == surface->points_mm.size());
  bool changes = false;
  for (auto* known : {&surfaces_, &cut_}) {
    const auto found = known->find(surface);
    if (found == known->end() || found->second.now == points_mm) continue;
    found->second.now = points_mm;
    changes = true;
  }
  if (changes) changes_.moved[surface] = points_mm;
}

void View::recolour_surface(const SurfaceId& surface, const std::vector<double>& values) {
  if (surfaces_.count(surface) != 0) changes_.recoloured[surface] = values;
}

void View::set_visibility(const SurfaceId& surface, Visibility visibility) {
  const auto found = surfaces_.find(surface);
  if (found == surfaces_.end() || found->second.visibility == visibility) return;
  found->second.visibility = visibility;
  changes_.visibility[surface] = visibility;
}

void View::set_landmarks(const std::vector<LandmarkItem>& landmarks) { changes_.landmarks = landmarks; }
void View::set_arrows(const std::vector<ArrowItem>& arrows) { changes_.arrows = arrows; }
void View::set_rods(const std::vector<RodItem>& rods) { changes_.rods = rods; }
void View::set_crosshair(const std::optional<CrosshairItem>& crosshair) { changes_.crosshair = crosshair; }
void View::set_lines(const std::vector<LineItem>& lines) { changes_.lines = lines; }

void View::turn_slice(std::size_t slice, const Eigen::Vector3d& normal) {
  GLISSON_ASSERT(slice < slices_);
  changes_.slices[slice].normal = normal;
}

void View::move_slice(std::size_t slice, const Eigen::Vector3d& center_mm) {
  GLISSON_ASSERT(slice < slices_);
  changes_.slices[slice].center_mm = center_mm;
}

void View::set_window(std::size_t slice, double center, double width) {
  GLISSON_ASSERT(slice < slices_);
  changes_.slices[slice].window = ViewChanges::Slice::Window{center, width};
}

void View::set_annotations(const Annotations& annotations) { changes_.annotations = annotations; }
void View::set_drawn_lines(const std::vector<DrawnLines>& lines) { changes_.drawn_lines = lines; }
void View::set_drawn_cells(const std::optional<DrawnCells>& cells) { changes_.drawn_cells = cells; }
void View::set_backdrop(const std::optional<Backdrop>& backdrop) { changes_.backdrop = backdrop; }
void View::set_detail(Detail detail) { changes_.detail = detail; }

void View::set_size(int width, int height) {
  viewport_.width = width;
  viewport_.height = height;
}

void View::set_pixel_scale(double pixel_scale) {
  if (pixel_scale == pixel_scale_) return;
  pixel_scale_ = pixel_scale;
  changes_.pixel_scale = pixel_scale;
}

void View::set_camera(const Camera& camera) {
  viewport_.camera = camera;
  framed_ = true;
}

ViewChanges View::take_changes(int width, int height, int shrink) {
  viewport_.width = std::max(width, 1);
  viewport_.height = std::max(height, 1);
  changes_.viewport = viewport_;
  changes_.shrink = shrink;
  return std::exchange(changes_, {});
}

std::optional<View::Pick> View::pick(double x, double y) const {
  const Ray ray = viewport_.ray_through(x, viewport_.height - y);
  std::optional<Pick> nearest;
  double nearest_mm = 0;
  for (const auto& [surface, shown] : surfaces_) {
    if (shown.visibility == Visibility::hidden) continue;
    const auto hit = first_hit(surface->triangles, shown.now ? *shown.now : surface->points_mm, ray);
    if (!hit || (nearest && hit->distance_mm >= nearest_mm)) continue;
    nearest_mm = hit->distance_mm;
    nearest = Pick{surface, ray.origin_mm + hit->distance_mm * ray.direction, hit->normal, hit->corners, hit->weights};
  }
  return nearest;
}

Eigen::Vector3d View::position_in_focal_plane(double x, double y) const {
  return viewport_.in_focal_plane(x, viewport_.height - y);
}

Eigen::Vector3d View::position_beside(const Eigen::Vector3d& place_mm, double x, double y) const {
  const Ray ray = viewport_.ray_through(x, viewport_.height - y);
  const double along_mm =
      viewport_.camera.sight.dot(place_mm - ray.origin_mm) / std::max(viewport_.camera.sight.dot(ray.direction), 1e-6);
  return ray.origin_mm + along_mm * ray.direction;
}

Eigen::Vector2d View::pixel_of(const Eigen::Vector3d& place_mm) const {
  const Eigen::Vector2d from_below = viewport_.pixel_of(place_mm);
  return {from_below.x(), viewport_.height - from_below.y()};
}

}  // namespace glisson::scene
