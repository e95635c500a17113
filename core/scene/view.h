#pragma once
// A scene in a renderer that somebody else owns (the window's 3D widget, or draw()), and the quick changes that a
// live picture needs: points that move, a camera that turns, without building anything again.
//
// The one public header in which the name of a VTK class stands, declared and not defined.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/drawing.h"
#include "scene/scene.h"

class vtkRenderer;

namespace glisson::scene {

enum class Visibility { shown, hidden };

// How clear surfaces that overlap are put together: `exact` sorts every pixel; `quick` draws them in the scene's order
// over what is solid, several times faster, and is hard to tell from it for one clear organ that comes last.
enum class Transparency { exact, quick };

// While the camera moves, a slow renderer is helped by fewer triangles: points that lie within a few mm become one.
enum class Detail { full, coarse };

class View {
 public:
  // The renderer must outlive the view and belong to a render window before the first frame.
  explicit View(vtkRenderer& renderer, double pixel_scale = 1);
  ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  // Shows this scene in place of what was there. The scene's camera applies; without one the present camera stays,
  // or, the first time, everything is brought into view. Refuses as check_scene does and then changes nothing.
  Result<void> show(const Scene& scene);

  // A surface is known by the pointer that the scene was given, wherever it stands there: drawn, cut by slices, or
  // both.
  using SurfaceId = std::shared_ptr<const geometry::Surface>;

  // Moves the surface's points, given in the order they have there; what cuts it follows. 20,000 points take a few
  // milliseconds. The count must match, which is asserted.
  void move_surface(const SurfaceId& surface, const std::vector<Eigen::Vector3d>& points_mm);
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
  void set_furniture(const Furniture& furniture);
  // What is drawn over the slices while a person works; it stays when another scene is shown.
  void set_drawn_lines(const std::vector<DrawnLines>& lines);
  void set_drawn_cells(const std::optional<DrawnCells>& cells);

  // How many device pixels one pixel of line width or text stands for (2 on a high-resolution screen).
  void set_pixel_scale(double pixel_scale);
  void set_transparency(Transparency transparency);
  void set_detail(Detail detail);
  void set_camera(const Camera& camera);
  [[nodiscard]] const Camera& camera() const;

  // Call before each frame, with the size of the picture in device pixels: places letters, scale bar and legends. With
  // `shrink` 2 it is drawn at half that size each way and enlarged by whoever shows it; everything else that is said
  // in pixels stays in those of the picture.
  void prepare_frame(int width, int height, int shrink = 1);

  struct Pick {
    SurfaceId surface;
    Eigen::Vector3d position_mm{0, 0, 0};
    Eigen::Vector3d normal{0, 0, 1};  // unit, outwards
    std::array<int, 3> corners{};     // the triangle that was hit: points of the surface, and their shares
    Eigen::Vector3d weights{1, 0, 0};
  };
  // The first shown surface under a device pixel (from the top left), or none.
  [[nodiscard]] std::optional<Pick> pick(double x, double y) const;

  // Where the line of sight through a device pixel meets the plane through the focus: in a slice view, the point of
  // the slice under the pointer.
  [[nodiscard]] Eigen::Vector3d position_in_focal_plane(double x, double y) const;
  // Where it meets the plane through that place, parallel to the picture.
  [[nodiscard]] Eigen::Vector3d position_beside(const Eigen::Vector3d& place_mm, double x, double y) const;

  // The device pixel (from the top left) at which a position is seen in the present frame.
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector3d& position_mm) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace glisson::scene
