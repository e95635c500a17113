#pragma once
// Landmarks as spheres, forces as arrows and solid tools as rods, moved from frame to frame.

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>
#include <array>
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace glisson::scene {

class Markers {
 public:
  explicit Markers(vtkRenderer& renderer);
  ~Markers();
  Markers(const Markers&) = delete;
  Markers& operator=(const Markers&) = delete;

  void set_landmarks(const std::vector<LandmarkItem>& landmarks);
  void set_arrows(const std::vector<ArrowItem>& arrows);
  void set_rods(const std::vector<RodItem>& rods);

 private:
  struct Rod {
    vtkNew<vtkLineSource> axis;
    vtkNew<vtkTubeFilter> tube;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> shaft;
    std::array<vtkNew<vtkActor>, 2> ends;
  };
  struct Arrow {
    vtkNew<vtkArrowSource> shape;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };

  vtkRenderer& renderer_;
  vtkNew<vtkSphereSource> ball_;
  vtkNew<vtkPolyDataMapper> ball_mapper_;
  std::vector<vtkSmartPointer<vtkActor>> balls_;
  std::vector<std::unique_ptr<Arrow>> arrows_;
  std::vector<std::unique_ptr<Rod>> rods_;
};

}  // namespace glisson::scene
