#include "widgets/views/patient_views.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <QRegularExpression>
#include <utility>

#include "scene/anatomy.h"
#include "widgets/settings/settings.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr const char* distance_field = "displacement_mm";
constexpr scene::Colour red{1.0, 0.10, 0.10};
constexpr scene::Colour blue{0.12, 0.22, 1.0};
constexpr scene::Colour purple{0.80, 0.20, 0.90};
constexpr scene::Colour amber{1.0, 0.72, 0.20};
constexpr scene::Colour cut_red{0.55, 0.10, 0.10};

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

// Of a triangle by its corners, one a column: along its first side, within it across that, and along its normal.
Eigen::Matrix3d frame_of(const Eigen::Matrix3d& corners_mm) {
  const Eigen::Vector3d side_mm = corners_mm.col(1) - corners_mm.col(0);
  Eigen::Matrix3d frame;
  frame.col(0) = side_mm.normalized();
  frame.col(2) = side_mm.cross(corners_mm.col(2) - corners_mm.col(0)).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// Large organs around must not hide the liver.
scene::SurfaceItem fixed_item(const PatientStructure& structure) {
  constexpr double large_ml = 150;
  constexpr double faint = 0.3;
  const scene::Appearance look = scene::appearance_of(structure.name);
  const bool large = structure.volume_ml > large_ml;
  return {structure.name,
          structure.surface,
          look.colour,
          large ? faint : look.opacity,
          large ? scene::Finish::glass : look.finish,
          {}};
}

}  // namespace

PatientViews::PatientViews(LinkedViews& views, QObject* parent)
    : QObject(parent), views_(views), vessel_tubes_(nullptr) {
  keep_window_.setSingleShot(true);
  keep_window_.setInterval(300);  // a drag is kept once, when it is over
  connect(&keep_window_, &QTimer::timeout, this, &PatientViews::keep_window_now);
  connect(&vessel_tubes_, &VesselTubes::found, this, [this] {
    take_tubes();
    rebuild_space();
  });
  connect(&views_, &LinkedViews::window_chosen, this, [this] {
    if (in_slices_ != SliceImage::anatomy) return;
    chosen_window_ = views_.window();
    keep_window_.start();
  });
}

PatientViews::~PatientViews() {
  if (keep_window_.isActive()) keep_window_now();
}

void PatientViews::keep_window_now() {
  keep_window_.stop();
  keep_window(patient_.folder, chosen_window_);
}

void PatientViews::show_patient(const Patient& patient) {
  if (patient.completes(patient_)) {
    patient_ = patient;
    return;
  }
  const bool another = patient.folder != patient_.folder || patient.name != patient_.name;
  if (keep_window_.isActive()) keep_window_now();
  patient_ = patient;
  if (another) {
    windows_.clear();
    in_slices_.reset();
  }
  bodies_ = Bodies::patient;
  liver_colour_ = LiverColour::tissue;
  slice_image_ = SliceImage::anatomy;
  hidden_.clear();
  workspace_.reset();
  state_.reset();
  tools_.clear();
  patient_body_.clear();
  reference_body_.clear();
  for (const PatientStructure& structure : patient.structures) {
    patient_body_.push_back(movable_copy(*structure.surface));
    reference_body_.push_back(movable_copy(*structure.surface));
  }
  vessel_tubes_.look_for(patient_);
  take_tubes();
  if (!patient.structures.empty()) {
    views_.set_crosshair(geometry::bounding_box(patient.structures.front().surface->points_mm).center_mm());
  } else if (patient.anatomy) {
    const imaging::Grid& grid = patient.anatomy->grid;
    views_.set_crosshair(grid.position_mm(Eigen::Vector3d(grid.size[0], grid.size[1], grid.size[2]) * 0.5));
  }
  views_.show_second_space(false);
  rebuild_slices();
  rebuild_space();
  views_.space().frame_all();
}

void PatientViews::take_tubes() {
  for (Body* tubes : {&patient_tubes_, &reference_tubes_}) {
    tubes->clear();
    for (const PatientStructure& structure : patient_.structures) {
      const VesselTubes::Vessel* vessel = vessel_tubes_.of(structure.name);
      tubes->push_back(vessel != nullptr ? movable_copy(*vessel->drawn) : nullptr);
    }
  }
}

void PatientViews::show_state(const rehearsal::RehearsalState* state, const std::vector<ToolInView>& tools) {
  const bool had_figures = has_figures();
  const bool moves = state != nullptr && state_ && state->patient.surface_mm != state_->patient.surface_mm;
  state_ = state != nullptr ? std::optional(*state) : std::nullopt;
  tools_ = tools;
  const double largest_mm = state_ ? state_->patient.max_displacement_mm : 0;
  if (liver_colour_ == LiverColour::displacement && had_figures != has_figures()) {
    rebuild_space();
    return;
  }
  if (liver_colour_ == LiverColour::displacement && has_figures() &&
      (largest_mm > colour_range_mm_ || largest_mm < 0.2 * colour_range_mm_) &&
      round_range_mm(largest_mm) != colour_range_mm_) {
    colour_range_mm_ = round_range_mm(largest_mm);
    rebuild_space();
    return;
  }
  if (moves) {
    for (SpaceView* space : {&views_.space(), &views_.second_space()}) space->shape_moved();
  }
  apply_state();
}

void PatientViews::set_bodies(Bodies bodies) {
  bodies_ = bodies;
  views_.show_second_space(bodies == Bodies::side_by_side);
  rebuild_slices();
  rebuild_space();
}

void PatientViews::set_tool_movable(bool movable) {
  tool_movable_ = movable;
  apply_state();
}

std::optional<PatientViews::PlaceOnLiver> PatientViews::place_on_liver(const scene::View::Pick& pick) const {
  const bool cut = !cut_body_.empty() && pick.surface == cut_body_[0];
  const bool reference = !reference_body_.empty() && pick.surface == reference_body_[0];
  const bool liver = cut || reference || (!patient_body_.empty() && pick.surface == patient_body_[0]);
  if (!liver) return std::nullopt;
  const auto& rest_mm = cut ? cut_rest_mm_ : patient_.structures.front().surface->points_mm;
  const rehearsal::RehearsalBody* body = !state_ || at_rest() ? nullptr
                                         : !reference         ? &state_->patient
                                         : state_->reference  ? &*state_->reference
                                                              : nullptr;
  const bool moved = body != nullptr && !body->structures_mm.empty();
  const auto& now_mm = cut ? cut_now_mm_ : moved ? body->structures_mm.front() : rest_mm;
  const auto corners_of = [&](const std::vector<Eigen::Vector3d>& points_mm) {
    Eigen::Matrix3d corners_mm;
    for (int k = 0; k < 3; ++k) corners_mm.col(k) = points_mm[static_cast<std::size_t>(pick.corners[k])];
    return corners_mm;
  };
  const Eigen::Matrix3d at_rest_mm = corners_of(rest_mm);
  const Eigen::Matrix3d rest = frame_of(at_rest_mm);
  return PlaceOnLiver{at_rest_mm * pick.weights, rest.col(2), rest * frame_of(corners_of(now_mm)).transpose()};
}

bool PatientViews::on_wall(const scene::View::Pick& pick) const {
  return !cut_body_.empty() && pick.surface == cut_body_[1];
}

std::optional<PatientViews::PlaceOnLiver> PatientViews::nearest_on_liver(const Eigen::Vector3d& position_mm) const {
  if (patient_.structures.empty()) return std::nullopt;
  const geometry::Surface& liver = *patient_.structures.front().surface;
  std::optional<PlaceOnLiver> nearest;
  for (const auto& triangle : liver.triangles) {
    const auto corner = [&](std::size_t k) { return liver.points_mm[static_cast<std::size_t>(triangle[k])]; };
    const Eigen::Vector3d middle_mm = (corner(0) + corner(1) + corner(2)) / 3;
    if (nearest && (middle_mm - position_mm).norm() >= (nearest->at_rest_mm - position_mm).norm()) continue;
    nearest = {middle_mm, (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized()};
  }
  return nearest;
}

void PatientViews::set_liver_colour(LiverColour colour) {
  liver_colour_ = colour;
  if (state_) colour_range_mm_ = round_range_mm(state_->patient.max_displacement_mm);
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
  const auto mode = [this] { return workspace_ ? workspace_->patient : WorkspaceScene::Patient::as_rehearsed; };
  const bool was_at_rest = at_rest(), was_hidden = mode() == WorkspaceScene::Patient::hidden;
  const auto cuts_before = workspace_ ? std::exchange(workspace_->cuts, {}) : std::vector<scene::CutLine>();
  workspace_ = std::move(scene);
  // Slices cost most, and most changes leave them as they are.
  const auto& cuts = workspace_ ? workspace_->cuts : std::vector<scene::CutLine>();
  const bool same_cuts = std::equal(cuts.begin(), cuts.end(), cuts_before.begin(), cuts_before.end(),
                                    [](const auto& a, const auto& b) { return a.surface == b.surface; });
  const bool is_hidden = mode() == WorkspaceScene::Patient::hidden;
  if (!same_cuts || was_at_rest != at_rest() || was_hidden != is_hidden) rebuild_slices();
  rebuild_space();
}

bool PatientViews::at_rest() const {
  return workspace_ && workspace_->patient != WorkspaceScene::Patient::as_rehearsed;
}

void PatientViews::set_marked_landmark(const std::string& id) {
  marked_landmark_ = id;
  apply_state();
}

scene::SurfaceItem PatientViews::item(std::size_t structure, const Body& body, Bodies bodies) const {
  const std::string& name = patient_.structures[structure].name;
  const scene::Appearance look = scene::appearance_of(name);
  const auto& tubes = (&body == &reference_body_ ? reference_tubes_ : patient_tubes_)[structure];
  scene::SurfaceItem item{name, tubes ? tubes : body[structure], look.colour, look.opacity, look.finish, {}};
  if (bodies == Bodies::both) {
    item.colour = &body == &reference_body_ ? red : blue;
    item.opacity = structure == 0 ? 0.45 : 0.8;
    item.finish = scene::Finish::light;
  } else if (structure == 0 && liver_colour_ == LiverColour::displacement && has_figures()) {
    item.opacity = 0.9;
    item.colouring = scene::Colouring{
        distance_field, scene::ColourMap::viridis, {0, colour_range_mm_}, tr("Displacement (mm)").toStdString()};
  }
  return item;
}

void PatientViews::rebuild_space() {
  if (bodies_ == Bodies::side_by_side) {
    scene::Scene patient = space_scene(Bodies::patient);
    patient.annotations.title = tr("The patient's own stiffness").toStdString();
    scene::Scene reference = space_scene(Bodies::reference);
    reference.annotations.title = tr("One stiffness from the atlas").toStdString();
    for (scene::Scene* each : {&patient, &reference}) each->annotations.text_scale = 0.8;
    views_.space().show_scene(patient);
    views_.second_space().show_scene(reference);
    views_.second_space().follow(views_.space().view().camera());
  } else {
    views_.space().show_scene(space_scene(bodies_));
  }
  apply_state();
  Q_EMIT space_rebuilt();
}

scene::Scene PatientViews::space_scene(Bodies bodies) const {
  scene::Scene scene;
  const auto mode = workspace_ ? workspace_->patient : WorkspaceScene::Patient::as_rehearsed;
  const bool in_space =
      mode != WorkspaceScene::Patient::at_rest_in_slices_only && mode != WorkspaceScene::Patient::hidden;
  for (std::size_t k = 0; in_space && k < patient_.structures.size(); ++k) {
    if (hidden_.count(patient_.structures[k].name) != 0) continue;
    if (bodies != Bodies::patient) scene.surfaces.push_back(item(k, reference_body_, bodies));
    if (bodies == Bodies::reference) continue;
    scene.surfaces.push_back(item(k, patient_body_, bodies));
    if (bodies == Bodies::both || cut_body_.empty()) continue;
    if (std::count(crossed_.begin(), crossed_.end(), k) != 0 && k > 0) scene.surfaces.back().colour = amber;
    if (k > 0) continue;
    scene.surfaces.back().surface = cut_body_[0];
    scene.surfaces.back().colouring = {};
    scene.surfaces.push_back(scene.surfaces.back());
    scene.surfaces.back().surface = cut_body_[1];
    scene.surfaces.back().colour = cut_red;
    scene.surfaces.back().opacity = 1.0;
  }
  for (const PatientStructure& structure : patient_.around) {
    if (mode == WorkspaceScene::Patient::hidden || hidden_.count(structure.name) != 0) continue;
    scene.surfaces.push_back(fixed_item(structure));
    const VesselTubes::Vessel* vessel = vessel_tubes_.of(structure.name);
    if (vessel != nullptr) scene.surfaces.back().surface = vessel->drawn;
  }
  if (workspace_) {
    for (const scene::SurfaceItem& surface : workspace_->surfaces) {
      if (hidden_.count(surface.name) == 0) scene.surfaces.push_back(surface);
    }
  }
  // What lies inside is drawn first, so that it shows through the clear liver around it.
  if (scene.surfaces.empty()) scene.annotations.scale_bar = scene::Annotations::ScaleBar::hidden;  // of nothing
  std::stable_sort(scene.surfaces.begin(), scene.surfaces.end(),
                   [](const auto& a, const auto& b) { return a.opacity > b.opacity; });
  if (bodies == Bodies::both) {
    scene.annotations.key = {{red, tr("Red: one stiffness from the atlas").toStdString()},
                             {blue, tr("Blue: the patient's own stiffness").toStdString()},
                             {purple, tr("Purple: both agree").toStdString()}};
  }
  if (workspace_)
    scene.annotations.key.insert(scene.annotations.key.end(), workspace_->key.begin(), workspace_->key.end());
  return scene;
}

void PatientViews::rebuild_slices() {
  SliceContent content;
  content.volume = slice_image_ == SliceImage::stiffness ? patient_.stiffness : patient_.anatomy;
  // The person's own window is kept for each image, also when the case is read again after a change.
  const SliceView& any = *views_.slices().front();
  if (in_slices_) windows_[*in_slices_] = {any.window_center(), any.window_width()};
  in_slices_.reset();
  if (content.volume) {
    in_slices_ = slice_image_;
    const auto kept = windows_.find(slice_image_);
    const auto of_case = slice_image_ == SliceImage::anatomy ? kept_window(patient_.folder) : std::nullopt;
    const GreyWindow window = kept != windows_.end() ? kept->second : of_case.value_or(first_window(*content.volume));
    content.window_center = window.center;
    content.window_width = window.width;
  }
  if (slice_image_ == SliceImage::stiffness) {
    content.map = scene::ColourMap::viridis;
    content.legend_title = tr("Shear stiffness (kPa)").toStdString();
  }
  const bool in_slices = !workspace_ || workspace_->patient != WorkspaceScene::Patient::hidden;
  for (std::size_t k = 0; in_slices && k < patient_.structures.size(); ++k) {
    const PatientStructure& structure = patient_.structures[k];
    if (hidden_.count(structure.name) != 0) continue;
    const scene::Colour colour = scene::appearance_of(structure.name).colour;
    // The rest shape stays as a faint line, so that the movement can be read off.
    content.cuts.push_back({structure.surface, {0.45 * colour.red, 0.45 * colour.green, 0.45 * colour.blue}, 1.0});
    if (cuts(Bodies::reference)) content.cuts.push_back({reference_body_[k], has_both() ? red : colour, 1.6});
    if (cuts(Bodies::patient)) content.cuts.push_back({patient_body_[k], has_both() ? blue : colour, 1.6});
  }
  for (const PatientStructure& structure : patient_.around) {
    if (!in_slices || hidden_.count(structure.name) != 0) continue;
    content.cuts.push_back({structure.surface, scene::appearance_of(structure.name).colour, 1.6});
  }
  if (workspace_) content.cuts.insert(content.cuts.end(), workspace_->cuts.begin(), workspace_->cuts.end());
  views_.show_slices(content);
  apply_state();
  Q_EMIT slices_rebuilt();
}

}  // namespace glisson::widgets
