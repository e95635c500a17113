#pragma once
// What a live picture shows: a scene, and the quick changes that it needs from frame to frame. Points move or a camera
// turns, and nothing is built again. Values alone: nothing is drawn here. What changed is handed to a Painter
// (scene/painter.h), which may be on another thread. Where things are in the picture is known here at once.

#include <array>
#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "scene/view_changes.h"

namespace glisson::scene {

class View {
 public:
  using SurfaceId = scene::SurfaceId;

  // Shows this scene in place of what was there. The scene's camera applies; without one the present camera stays,
  // or, the first time, everything is brought into view. Refuses as check_scene does and then changes nothing.
  Result<void> show(const Scene& scene);

  // Moves the surface's points, given in the order they have there; what cuts it follows. The count must match, which
  // is asserted; none: back to where the surface has them. A surface that the scene does not show is left alone.
  void move_surface(const SurfaceId& surface, const Points& points_mm);
  // New values for the field that the surface is coloured by, one an item.
  void recolour_surface(const SurfaceId& surface, const std::vector<double>& values);
  void set_visibility(const SurfaceId& surface, Visibility visibility);

  void set_landmarks(const std::vector<LandmarkItem>& landmarks);
  void set_arrows(const std::vector<ArrowItem>& arrows);
  void set_rods(const std::vector<RodItem>& rods);
  void set_crosshair(const std::optional<CrosshairItem>& crosshair);
  void set_lines(const std::vector<LineItem>& lines);
  void move_slice(std::size_t slice, const Eigen::Vector3d& center_mm);
  void turn_slice(std::size_t slice, const Eigen::Vector3d& normal);
  void set_window(std::size_t slice, double center, double width);
  void set_annotations(const Annotations& annotations);
  // What is drawn over the slices while a person works; it stays when another scene is shown.
  void set_drawn_lines(const std::vector<DrawnLines>& lines);
  void set_drawn_cells(const std::optional<DrawnCells>& cells);
  // The scan behind the surfaces; it stays when another scene is shown, and takes no part in what the camera frames.
  void set_backdrop(const std::optional<Backdrop>& backdrop);

  // How many device pixels one pixel of line width or text stands for (2 on a high-resolution screen).
  void set_pixel_scale(double pixel_scale);
  void set_detail(Detail detail);
  // In device pixels, until changes are taken for another size: what pixels are asked for.
  void set_size(int width, int height);
  void set_camera(const Camera& camera);
  [[nodiscard]] const Camera& camera() const { return viewport_.camera; }

  // What a Painter needs for the next frame, of that size in device pixels; the view begins to gather anew.
  [[nodiscard]] ViewChanges take_changes(int width, int height, int shrink = 1);

  struct Pick {
    SurfaceId surface;
    Eigen::Vector3d position_mm{0, 0, 0};
    Eigen::Vector3d normal{0, 0, 1};  // unit, outwards
    std::array<int, 3> corners{};     // the triangle that was hit: points of the surface, and their shares
    Eigen::Vector3d weights{1, 0, 0};
  };
  // The first shown surface under a device pixel (from the top left), or none.
  [[nodiscard]] std::optional<Pick> pick(double x, double y) const;

  // Where the line of sight through a device pixel meets the plane through the focus. In a slice view that is the point
  // of the slice under the pointer.
  [[nodiscard]] Eigen::Vector3d position_in_focal_plane(double x, double y) const;
  // Where it meets the plane through that place, parallel to the picture.
  [[nodiscard]] Eigen::Vector3d position_beside(const Eigen::Vector3d& place_mm, double x, double y) const;

  // The device pixel (from the top left) at which a position is seen in the present frame.
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector3d& position_mm) const;

 private:
  struct Shown {
    Points now;  // where its points were moved to; none while they are where the surface has them
    Visibility visibility = Visibility::shown;
  };

  Viewport viewport_;
  bool framed_ = false;  // whether a camera was ever chosen
  std::map<SurfaceId, Shown> surfaces_;
  std::map<SurfaceId, Shown> cut_;  // those that slices cut
  std::size_t slices_ = 0;
  double pixel_scale_ = 1;
  ViewChanges changes_;
};

}  // namespace glisson::scene
