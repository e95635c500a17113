#pragma once
// One surface in a renderer, whose points and colours may change from frame to frame.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <array>
#include <Eigen/Core>
#include <vector>

#include "scene/scene.h"
#include "scene/view_changes.h"

namespace glisson::scene {

class SurfaceActor {
 public:
  SurfaceActor(vtkRenderer& renderer, const SurfaceItem& item);
  ~SurfaceActor();
  SurfaceActor(const SurfaceActor&) = delete;
  SurfaceActor& operator=(const SurfaceActor&) = delete;

  void move(const std::vector<Eigen::Vector3d>& points_mm);
  void recolour(const std::vector<double>& values);
  // Of clear surfaces: each pixel sorted by VTK, or drawn in turn over what is there.
  void sort_what_is_clear(bool sorted);
  void set_detail(Detail detail);
  // From here on drawn last. What it holds in the graphics card's memory stays there.
  void draw_last();
  void set_shown(bool shown) { actor_->SetVisibility(shown ? 1 : 0); }

 private:
  void colour_by(const Colouring& colouring);
  void make_coarse();
  void shade_as_glass();
  void shade_as_light();

  vtkRenderer& renderer_;
  geometry::Surface surface_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkFloatArray> values_;
  vtkNew<vtkPolyData> mesh_;
  vtkNew<vtkPolyDataMapper> mapper_;
  // The same points with fewer triangles; made when it is first asked for.
  vtkNew<vtkPolyData> coarse_mesh_;
  vtkSmartPointer<vtkPolyDataMapper> coarse_mapper_;
  vtkSmartPointer<vtkActor> actor_;
};

// The surface's triangles between one point of each cube of that edge; those that shrink to a line or a point are left
// out.
[[nodiscard]] std::vector<std::array<int, 3>> clustered_triangles(const geometry::Surface& surface, double edge_mm);

// One value an item: the field itself, or the length of each of its vectors.
[[nodiscard]] std::vector<double> values_to_colour(const geometry::Field& field);

}  // namespace glisson::scene
