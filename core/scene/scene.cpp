#include "scene/scene.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>

namespace glisson::scene {
namespace {

// Finds the first thing that cannot be drawn, and says which.
class Inspection {
 public:
  void surface(const std::string& which, const std::shared_ptr<const geometry::Surface>& surface);
  void colouring(const std::string& which, const geometry::Surface& surface, const Colouring& colouring);
  void slice(const std::string& which, const SliceItem& item);
  void position(const std::string& which, const Eigen::Vector3d& position_mm);
  [[nodiscard]] bool failed() const { return !complaint_.empty(); }
  [[nodiscard]] Result<void> outcome() const;

 private:
  void refuse(const std::string& which, const std::string& why) {
    if (!failed()) complaint_ = which + " " + why;
  }
  std::string complaint_;
};

void take_in(geometry::Box& box, bool& empty, const geometry::Box& more) {
  box.min_mm = empty ? more.min_mm : box.min_mm.cwiseMin(more.min_mm);
  box.max_mm = empty ? more.max_mm : box.max_mm.cwiseMax(more.max_mm);
  empty = false;
}

geometry::Box box_of(const imaging::Grid& grid) {
  std::vector<Eigen::Vector3d> corners;
  for (const int i : {0, grid.size[0] - 1}) {
    for (const int j : {0, grid.size[1] - 1}) {
      for (const int k : {0, grid.size[2] - 1}) corners.push_back(grid.position_mm(i, j, k));
    }
  }
  return geometry::bounding_box(corners);
}

}  // namespace

geometry::Box bounds(const Scene& scene) {
  geometry::Box box;
  bool empty = true;
  for (const SurfaceItem& item : scene.surfaces) {
    if (item.framed) take_in(box, empty, geometry::bounding_box(item.surface->points_mm));
  }
  for (const SliceItem& item : scene.slices) take_in(box, empty, box_of(item.volume->grid));
  for (const LandmarkItem& item : scene.landmarks) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(item.radius_mm);
    take_in(box, empty, {item.position_mm - reach, item.position_mm + reach});
  }
  for (const ArrowItem& item : scene.arrows) {
    take_in(box, empty, {item.tail_mm.cwiseMin(item.tip_mm), item.tail_mm.cwiseMax(item.tip_mm)});
  }
  return box;
}

Camera fit(const Scene& scene, PatientView view, double aspect) {
  Camera camera = look_from(view, bounds(scene), aspect);
  const Eigen::Vector3d right = camera.sight.cross(camera.up);
  Eigen::AlignedBox2d seen;
  const auto take_in_point = [&](const Eigen::Vector3d& p) {
    seen.extend(Eigen::Vector2d(right.dot(p), camera.up.dot(p)));
  };
  for (const SurfaceItem& item : scene.surfaces) {
    if (item.framed) std::for_each(item.surface->points_mm.begin(), item.surface->points_mm.end(), take_in_point);
  }
  for (const ArrowItem& item : scene.arrows) take_in_point(item.tail_mm), take_in_point(item.tip_mm);
  if (seen.isEmpty() || !scene.slices.empty()) return camera;
  const Eigen::Vector2d shift =
      seen.center() - Eigen::Vector2d(right.dot(camera.focus_mm), camera.up.dot(camera.focus_mm));
  camera.focus_mm += shift.x() * right + shift.y() * camera.up;
  // A quarter more than what is seen, for the titles and for what stands nearer than the focus.
  camera.visible_height_mm = 1.25 * std::max(seen.sizes().y(), seen.sizes().x() / std::max(aspect, 1e-3));
  return camera;
}

Result<void> check_scene(const Scene& scene) {
  Inspection inspection;
  for (const SurfaceItem& item : scene.surfaces) {
    const std::string which = fmt::format("the surface \"{}\"", item.name);
    inspection.surface(which, item.surface);
    if (inspection.failed()) break;
    if (item.colouring) inspection.colouring(which, *item.surface, *item.colouring);
  }
  for (std::size_t k = 0; k < scene.slices.size(); ++k) {
    inspection.slice(fmt::format("slice {}", k + 1), scene.slices[k]);
  }
  for (const LandmarkItem& item : scene.landmarks) {
    inspection.position(fmt::format("the landmark \"{}\"", item.label), item.position_mm);
  }
  for (const ArrowItem& item : scene.arrows) {
    inspection.position("an arrow", item.tail_mm);
    inspection.position("an arrow", item.tip_mm);
  }
  return inspection.outcome();
}

namespace {

void Inspection::surface(const std::string& which, const std::shared_ptr<const geometry::Surface>& surface) {
  if (surface == nullptr) return refuse(which, "is missing");
  if (auto fine = geometry::check_surface(*surface); !fine) refuse(which, "is broken: " + fine.error().message());
}

void Inspection::colouring(const std::string& which, const geometry::Surface& surface, const Colouring& colouring) {
  const geometry::Field* on_points = geometry::find_field(surface.point_fields, colouring.field);
  const geometry::Field* field =
      on_points != nullptr ? on_points : geometry::find_field(surface.cell_fields, colouring.field);
  if (field == nullptr) return refuse(which, fmt::format("has no quantity \"{}\" to show", colouring.field));
  const std::size_t wanted = on_points != nullptr ? surface.points_mm.size() : surface.triangles.size();
  if (field->components < 1 || field->items() != wanted) {
    return refuse(which, fmt::format("has {} values of \"{}\" where {} belong", field->items(), field->name, wanted));
  }
  if (!(colouring.range[1] > colouring.range[0])) refuse(which, "is to be coloured over an empty range");
}

void Inspection::slice(const std::string& which, const SliceItem& item) {
  if (item.volume == nullptr || item.volume->grid.voxels() == 0 ||
      item.volume->grid.voxels() != item.volume->values.size()) {
    return refuse(which, "has no volume");
  }
  position(which, item.center_mm);
  position(which, item.normal);
  if (!(item.normal.norm() > 0)) refuse(which, "has no direction");
  if (!(item.window_width > 0)) refuse(which, "has an empty window of grey values");
  for (const CutLine& line : item.cuts) surface(which + ": a surface it cuts", line.surface);
  for (const MaskLine& line : item.masks) {
    if (line.mask == nullptr || line.mask->grid.voxels() == 0 || line.mask->grid.voxels() != line.mask->values.size()) {
      refuse(which, "outlines a mask that is empty");
    }
  }
}

void Inspection::position(const std::string& which, const Eigen::Vector3d& position_mm) {
  if (!position_mm.allFinite()) refuse(which, "has a position that is not a number");
}

Result<void> Inspection::outcome() const {
  if (!failed()) return {};
  return failure("scene-invalid", GLISSON_TEXT("The picture cannot be drawn: {0}."), {complaint_});
}

}  // namespace
}  // namespace glisson::scene
