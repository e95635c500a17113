#pragma once
// One plane through a volume in a renderer, with the lines along which surfaces and masks cut it.

#include <vtkActor.h>
#include <vtkImageProperty.h>
#include <vtkImageResliceMapper.h>
#include <vtkImageSlice.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace glisson::scene {

struct Plane {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};
};

// The segments along which a plane cuts a surface: two points each.
[[nodiscard]] std::vector<Eigen::Vector3d> cut(const geometry::Surface& surface, const Plane& plane);

class SliceActor {
 public:
  SliceActor(vtkRenderer& renderer, const SliceItem& item);
  ~SliceActor();
  SliceActor(const SliceActor&) = delete;
  SliceActor& operator=(const SliceActor&) = delete;

  void place(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal);
  void set_window(double center, double width);
  // The lines that cut `original` cut `now` from here on, its present shape, which must stay alive.
  void recut(const geometry::Surface* original, const geometry::Surface& now);
  // Lifts the lines off the plane towards the viewer, so that neither hides the other.
  void lift_lines(const Eigen::Vector3d& towards_viewer_mm);
  void set_line_scale(double pixel_scale);

  [[nodiscard]] const SliceItem& item() const { return item_; }

 private:
  struct Line {
    const geometry::Surface* original = nullptr;  // the surface it cuts, as the scene gave it, or
    std::shared_ptr<const imaging::Mask> mask;    // the mask it outlines
    const geometry::Surface* now = nullptr;       // the surface's present shape
    double width_px = 1;
    vtkNew<vtkPolyData> segments;
    vtkNew<vtkActor> actor;
  };

  void add_volume();
  Line& add_line(const Colour& colour, double width_px);
  void draw_line(Line& line) const;
  void draw_lines();

  vtkRenderer& renderer_;
  SliceItem item_;
  Plane plane_;
  vtkNew<vtkPlane> vtk_plane_;
  vtkNew<vtkImageResliceMapper> mapper_;
  vtkNew<vtkImageProperty> property_;
  vtkNew<vtkImageSlice> slice_;
  std::vector<std::unique_ptr<Line>> lines_;
};

}  // namespace glisson::scene
