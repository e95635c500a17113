#include "views/patient_views.h"

#include <algorithm>
#include <cmath>
#include <QRegularExpression>

#include "scene/anatomy.h"
#include "words/told.h"

namespace glisson::widgets {
namespace {

constexpr const char* distance_field = "displacement_mm";
constexpr scene::Colour red{1.0, 0.10, 0.10};
constexpr scene::Colour blue{0.12, 0.22, 1.0};
constexpr scene::Colour purple{0.80, 0.20, 0.90};
constexpr scene::Colour tool_colour{0.20, 0.83, 0.85};
constexpr scene::Colour calm{0.90, 0.93, 0.96};
constexpr scene::Colour amber{1.0, 0.72, 0.20};

// A copy to be moved, with a place for how far each point went.
std::shared_ptr<const geometry::Surface> movable_copy(const geometry::Surface& rest) {
  auto copy = std::make_shared<geometry::Surface>();
  copy->points_mm = rest.points_mm;
  copy->triangles = rest.triangles;
  copy->point_fields = {{distance_field, 1, std::vector<double>(rest.points_mm.size(), 0.0)}};
  return copy;
}

// The end of a colour scale that suits a largest value: 5, 10, 15, 20, 30, 50, 75, 100, 150, ...
double round_range_mm(double largest_mm) {
  for (double decade = 10;; decade *= 10) {
    for (const double step : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 7.5}) {
      if (largest_mm <= step * decade) return step * decade;
    }
  }
}

// Where the tissue is now that was at a place on a surface at rest: with its nearest point.
Eigen::Vector3d moved_with(const std::vector<Eigen::Vector3d>& rest_mm, const std::vector<Eigen::Vector3d>& now_mm,
                           const Eigen::Vector3d& place_mm) {
  std::size_t nearest = 0;
  for (std::size_t p = 1; p < rest_mm.size(); ++p) {
    if ((rest_mm[p] - place_mm).squaredNorm() < (rest_mm[nearest] - place_mm).squaredNorm()) nearest = p;
  }
  return place_mm + now_mm[nearest] - rest_mm[nearest];
}

}  // namespace

PatientViews::PatientViews(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {}

void PatientViews::show_patient(const Patient& patient) {
  patient_ = patient;
  bodies_ = Bodies::patient;
  liver_colour_ = LiverColour::tissue;
  slice_image_ = SliceImage::anatomy;
  hidden_.clear();
  workspace_.reset();
  frame_.reset();
  tool_.reset();
  patient_body_.clear();
  atlas_body_.clear();
  for (const PatientStructure& structure : patient.structures) {
    patient_body_.push_back(movable_copy(*structure.surface));
    atlas_body_.push_back(movable_copy(*structure.surface));
  }
  if (!patient.structures.empty()) {
    views_.set_crosshair(geometry::bounding_box(patient.structures.front().surface->points_mm).center_mm());
  } else if (patient.anatomy) {
    const imaging::Grid& grid = patient.anatomy->grid;
    views_.set_crosshair(grid.position_mm(Eigen::Vector3d(grid.size[0], grid.size[1], grid.size[2]) * 0.5));
  }
  rebuild_slices();
  rebuild_space();
  views_.space().frame_all();
}

void PatientViews::show_frame(const rehearsal::RehearsalFrame* frame, const ToolInView* tool) {
  frame_ = frame != nullptr ? std::optional(*frame) : std::nullopt;
  tool_ = tool != nullptr ? std::optional(*tool) : std::nullopt;
  const double largest_mm = frame_ ? frame_->patient.max_displacement_mm : 0;
  if (liver_colour_ == LiverColour::displacement &&
      (largest_mm > colour_range_mm_ || largest_mm < 0.2 * colour_range_mm_) &&
      round_range_mm(largest_mm) != colour_range_mm_) {
    colour_range_mm_ = round_range_mm(largest_mm);
    rebuild_space();
    return;
  }
  apply_frame();
}

void PatientViews::set_bodies(Bodies bodies) {
  bodies_ = bodies;
  rebuild_slices();
  rebuild_space();
}

void PatientViews::set_liver_colour(LiverColour colour) {
  liver_colour_ = colour;
  if (frame_) colour_range_mm_ = round_range_mm(frame_->patient.max_displacement_mm);
  rebuild_space();
}

void PatientViews::set_slice_image(SliceImage image) {
  slice_image_ = image;
  rebuild_slices();
}

void PatientViews::set_structure_shown(const std::string& name, bool shown) {
  if (shown) {
    hidden_.erase(name);
  } else {
    hidden_.insert(name);
  }
  rebuild_slices();
  rebuild_space();
}

void PatientViews::reword() {
  if (patient_.structures.empty() && !patient_.anatomy) return;
  rebuild_slices();
  rebuild_space();
}

void PatientViews::set_workspace_scene(std::optional<WorkspaceScene> scene) {
  workspace_ = std::move(scene);
  rebuild_slices();
  rebuild_space();
}

bool PatientViews::at_rest() const {
  return workspace_ && workspace_->patient != WorkspaceScene::Patient::as_rehearsed;
}

void PatientViews::set_marked_landmark(const std::string& id) {
  marked_landmark_ = id;
  apply_frame();
}

scene::SurfaceItem PatientViews::item(std::size_t structure, const Body& body) const {
  const std::string& name = patient_.structures[structure].name;
  const scene::Appearance look = scene::appearance_of(name);
  scene::SurfaceItem item{name, body[structure], look.colour, look.opacity, look.finish, {}};
  if (bodies_ == Bodies::both) {
    item.colour = &body == &atlas_body_ ? red : blue;
    item.opacity = structure == 0 ? 0.45 : 0.8;
    item.finish = scene::Finish::light;
  } else if (structure == 0 && liver_colour_ == LiverColour::displacement) {
    item.opacity = 0.9;
    item.colouring = scene::Colouring{
        distance_field, scene::ColourMap::viridis, {0, colour_range_mm_}, tr("Displacement (mm)").toStdString()};
  }
  return item;
}

void PatientViews::rebuild_space() {
  scene::Scene scene;
  const bool in_space = !workspace_ || workspace_->patient != WorkspaceScene::Patient::at_rest_in_slices_only;
  for (std::size_t k = 0; in_space && k < patient_.structures.size(); ++k) {
    if (hidden_.count(patient_.structures[k].name) != 0) continue;
    if (shows(Bodies::atlas)) scene.surfaces.push_back(item(k, atlas_body_));
    if (shows(Bodies::patient)) scene.surfaces.push_back(item(k, patient_body_));
  }
  if (workspace_) {
    for (const scene::SurfaceItem& surface : workspace_->surfaces) {
      if (hidden_.count(surface.name) == 0) scene.surfaces.push_back(surface);
    }
  }
  // What lies inside is drawn first, so that it shows through the clear liver around it.
  std::stable_sort(scene.surfaces.begin(), scene.surfaces.end(),
                   [](const auto& a, const auto& b) { return a.opacity > b.opacity; });
  // The first clause: the whole sentence stands above the views.
  static const QRegularExpression end_of_clause("[:,]");
  scene.furniture.warning = told(patient_.origin).section(end_of_clause, 0, 0).toStdString();
  if (bodies_ == Bodies::both) {
    scene.furniture.key = {{red, tr("Red: one stiffness from the atlas").toStdString()},
                           {blue, tr("Blue: the patient's own stiffness").toStdString()},
                           {purple, tr("Purple: both agree").toStdString()}};
  }
  if (workspace_) scene.furniture.key.insert(scene.furniture.key.end(), workspace_->key.begin(), workspace_->key.end());
  views_.space().show_scene(scene);
  apply_frame();
}

void PatientViews::rebuild_slices() {
  SliceContent content;
  content.volume = slice_image_ == SliceImage::stiffness ? patient_.stiffness : patient_.anatomy;
  if (content.volume) {
    const GreyWindow window = usual_window(*content.volume);
    content.window_center = window.center;
    content.window_width = window.width;
  }
  if (slice_image_ == SliceImage::stiffness) {
    content.map = scene::ColourMap::viridis;
    content.legend_title = tr("Shear stiffness (kPa)").toStdString();
  }
  for (std::size_t k = 0; k < patient_.structures.size(); ++k) {
    const PatientStructure& structure = patient_.structures[k];
    if (hidden_.count(structure.name) != 0) continue;
    const scene::Colour colour = scene::appearance_of(structure.name).colour;
    // The rest shape stays as a faint line, so that the movement can be read off.
    content.cuts.push_back({structure.surface, {0.45 * colour.red, 0.45 * colour.green, 0.45 * colour.blue}, 1.0});
    if (shows(Bodies::atlas)) {
      content.cuts.push_back({atlas_body_[k], bodies_ == Bodies::both ? red : colour, 1.6});
    }
    if (shows(Bodies::patient)) {
      content.cuts.push_back({patient_body_[k], bodies_ == Bodies::both ? blue : colour, 1.6});
    }
  }
  if (workspace_) content.cuts.insert(content.cuts.end(), workspace_->cuts.begin(), workspace_->cuts.end());
  views_.show_slices(content);
  apply_frame();
  Q_EMIT slices_rebuilt();
}

void PatientViews::apply_frame() {
  const bool moved = frame_ && !at_rest();
  const rehearsal::RehearsalBody* own = moved ? &frame_->patient : nullptr;
  const rehearsal::RehearsalBody* atlas = moved && frame_->atlas ? &*frame_->atlas : nullptr;
  move_body(patient_body_, own);
  move_body(atlas_body_, atlas);

  std::vector<scene::LandmarkItem> landmarks;
  const rehearsal::RehearsalBody* shown = bodies_ == Bodies::atlas && atlas != nullptr ? atlas : own;
  if (shown != nullptr) {
    for (const auto& landmark : shown->landmarks) {
      const bool named = landmark.id == marked_landmark_ || landmark.id.starts_with("tumour");
      const bool far = landmark.displacement_mm >= rehearsal::significant_mm;
      const QString text = tr("%1  %2 mm").arg(structure_label(landmark.id)).arg(landmark.displacement_mm, 0, 'f', 1);
      landmarks.push_back({named ? text.toStdString() : std::string(), landmark.displaced_mm,
                           landmark.id == marked_landmark_ ? 3.5 : 2.2, far ? amber : calm});
    }
  }
  std::vector<scene::ArrowItem> arrows;
  if (tool_ && !at_rest()) {
    // Its length tells the force, within what fits the picture.
    const double length_mm = std::clamp(10 * tool_->force_N, 25.0, 70.0);
    Eigen::Vector3d at_mm = tool_->center_mm;
    if (shown != nullptr && !shown->structures_mm.empty()) {
      at_mm = moved_with(patient_body_.front()->points_mm, shown->structures_mm.front(), at_mm);
    }
    arrows.push_back({at_mm - length_mm * tool_->direction, at_mm, 3.2, tool_colour,
                      tr("%1 N").arg(tool_->force_N, 0, 'f', 1).toStdString()});
  }
  if (workspace_) {
    landmarks.insert(landmarks.end(), workspace_->marks.begin(), workspace_->marks.end());
    arrows.insert(arrows.end(), workspace_->arrows.begin(), workspace_->arrows.end());
  }
  views_.space().view().set_landmarks(landmarks);
  views_.space().view().set_arrows(arrows);
  views_.redraw();
}

void PatientViews::move_body(const Body& body, const rehearsal::RehearsalBody* displaced) {
  for (std::size_t k = 0; k < body.size(); ++k) {
    const bool moved = displaced != nullptr && k < displaced->structures_mm.size();
    const auto& rest_mm = body[k]->points_mm;
    const auto& points_mm = moved ? displaced->structures_mm[k] : rest_mm;
    scene::View& space = views_.space().view();
    space.move_surface(body[k], points_mm);
    for (SliceView* slice : views_.slices()) slice->view().move_surface(body[k], points_mm);
    if (k != 0 || liver_colour_ != LiverColour::displacement || bodies_ == Bodies::both) continue;
    std::vector<double> distance_mm(points_mm.size());
    for (std::size_t p = 0; p < distance_mm.size(); ++p) distance_mm[p] = (points_mm[p] - rest_mm[p]).norm();
    space.recolour_surface(body[k], distance_mm);
  }
}

}  // namespace glisson::widgets
