#pragma once
// A planned resection in space. The part that goes and the part that stays have colours of their own, with the cut's
// face on each. They are drawn apart as far as wanted.

#include <vector>

#include "widgets/resect/live_resection.h"
#include "widgets/views/patient_views.h"

namespace glisson::widgets {

[[nodiscard]] scene::Colour specimen_colour();
[[nodiscard]] scene::Colour remnant_colour();

class ResectionScene {
 public:
  // Nothing to show.
  ResectionScene() = default;
  explicit ResectionScene(std::shared_ptr<const LiveResectionResult> result);

  // Everything where it is at rest.
  void add_to(WorkspaceScene& scene) const;
  // Moves what goes away from what stays, in a view that shows the scene.
  void draw_apart(scene::View& view, double apart_mm) const;

 private:
  std::shared_ptr<const LiveResectionResult> result_;
  std::shared_ptr<const geometry::Surface> face_of_specimen_, face_of_remnant_;
};

}  // namespace glisson::widgets
