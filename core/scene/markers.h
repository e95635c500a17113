#pragma once
// Landmarks as spheres and forces as arrows, moved from frame to frame. Inside the room.

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
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

 private:
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
};

}  // namespace glisson::scene
