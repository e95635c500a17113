#include "widgets/resect/resection_scene.h"

#include "scene/anatomy.h"

namespace glisson::widgets {

using rehearsal::ResectionSide;

scene::Colour specimen_colour() { return {0.56, 0.85, 0.58}; }
scene::Colour remnant_colour() { return scene::appearance_of("liver").colour; }

ResectionScene::ResectionScene(std::shared_ptr<const LiveResectionResult> result) : result_(std::move(result)) {
  if (!result_) return;
  face_of_specimen_ = std::make_shared<geometry::Surface>(result_->plan.cut);
  face_of_remnant_ = std::make_shared<geometry::Surface>(result_->plan.cut);
}

void ResectionScene::add_to(WorkspaceScene& scene) const {
  if (!result_) return;
  for (const ResectedPiece& piece : result_->pieces) {
    const scene::Appearance look = scene::appearance_of(piece.structure);
    scene::SurfaceItem item{piece.structure, piece.surface, look.colour, look.opacity, look.finish, {}};
    if (piece.structure == "liver" && piece.side == ResectionSide::specimen) item.colour = specimen_colour();
    scene.surfaces.push_back(std::move(item));
  }
  constexpr double see_through = 0.5;
  scene.surfaces.push_back({"cut", face_of_specimen_, specimen_colour(), see_through, scene::Finish::solid, {}});
  scene.surfaces.push_back({"cut", face_of_remnant_, remnant_colour(), see_through, scene::Finish::solid, {}});
}

void ResectionScene::draw_apart(scene::View& view, double apart_mm) const {
  if (!result_) return;
  const auto move = [&](const std::shared_ptr<const geometry::Surface>& surface) {
    auto points_mm = std::make_shared<std::vector<Eigen::Vector3d>>(surface->points_mm);
    for (Eigen::Vector3d& point : *points_mm) point += apart_mm * result_->towards_specimen;
    view.move_surface(surface, points_mm);
  };
  for (const ResectedPiece& piece : result_->pieces) {
    if (piece.side == ResectionSide::specimen) move(piece.surface);
  }
  move(face_of_specimen_);
}

}  // namespace glisson::widgets
