#pragma once
// A backdrop in a window: rays through the scan in a layer below what the renderer draws. So it shines through what is
// clear and covers nothing. The half before a plane is cut away.

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <Eigen/Core>

#include "scene/backdrop.h"
#include "scene/view_changes.h"

namespace glisson::scene {

class BackdropActor {
 public:
  // By the graphics card, or, where a processor does its work, by VTK's own rays over a coarser copy of the scan.
  enum class Drawn { by_card, by_processor };
  // `renderer` is the window's only one, and is again once this ends.
  BackdropActor(vtkRenderWindow& window, vtkRenderer& renderer, const Backdrop& backdrop, Drawn drawn);
  ~BackdropActor();
  BackdropActor(const BackdropActor&) = delete;
  BackdropActor& operator=(const BackdropActor&) = delete;

  // Cuts away what lies before the plane through `middle_mm` across the line of sight, seen as the renderer sees now.
  void stand_behind(const Eigen::Vector3d& middle_mm, const Eigen::Vector3d& sight);
  void set_detail(Detail detail);

 private:
  vtkRenderWindow& window_;
  vtkRenderer& renderer_;
  vtkNew<vtkRenderer> behind_;
  vtkNew<vtkPlane> front_;
  vtkSmartPointer<vtkVolumeMapper> mapper_;
  vtkNew<vtkVolume> volume_;
};

}  // namespace glisson::scene
