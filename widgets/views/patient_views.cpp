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
constexpr scene::Colour tool_colour{0.20, 0.83, 0.85};
constexpr scene::Colour tool_steel{0.72, 0.76, 0.80};
constexpr scene::Colour calm{0.90, 0.93, 0.96};
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

// The triangles of a cut liver that are its walls, or those that are not, with the points that they use.
geometry::Surface part_on_wall(const geometry::Surface& cut, bool wall) {
  const auto& on_wall = geometry::find_field(cut.cell_fields, "wall")->values;
  geometry::Surface part;
  std::vector<int> number(cut.points_mm.size(), -1);
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    if ((on_wall[t] != 0) != wall) continue;
    std::array<int, 3> triangle = cut.triangles[t];
    for (int& p : triangle) {
      int& known = number[static_cast<std::size_t>(p)];
      if (known < 0) {
        known = static_cast<int>(part.points_mm.size());
        part.points_mm.push_back(cut.points_mm[static_cast<std::size_t>(p)]);
      }
      p = known;
    }
    part.triangles.push_back(triangle);
  }
  return part;
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

PatientViews::PatientViews(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {
  keep_window_.setSingleShot(true);
  keep_window_.setInterval(300);  // a drag is kept once, when it is over
  connect(&keep_window_, &QTimer::timeout, this, &PatientViews::keep_window_now);
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
  views_.show_second_space(false);
  rebuild_slices();
  rebuild_space();
  views_.space().frame_all();
}

namespace {

// Of an answer that is not to be used no length is told: neither beside a landmark nor by a colour bar.
bool has_figures(const std::optional<rehearsal::RehearsalState>& state) { return !state || state->validity.usable(); }

}  // namespace

void PatientViews::show_state(const rehearsal::RehearsalState* state, const std::vector<ToolInView>& tools) {
  const bool had_figures = has_figures(state_);
  state_ = state != nullptr ? std::optional(*state) : std::nullopt;
  tools_ = tools;
  const double largest_mm = state_ ? state_->patient.max_displacement_mm : 0;
  if (liver_colour_ == LiverColour::displacement && had_figures != has_figures(state_)) {
    rebuild_space();
    return;
  }
  if (liver_colour_ == LiverColour::displacement && has_figures(state_) &&
      (largest_mm > colour_range_mm_ || largest_mm < 0.2 * colour_range_mm_) &&
      round_range_mm(largest_mm) != colour_range_mm_) {
    colour_range_mm_ = round_range_mm(largest_mm);
    rebuild_space();
    return;
  }
  apply_state();
}

void PatientViews::draw_cut(const rehearsal::SessionCut* cut) {
  std::vector<geometry::Surface> parts;
  if (cut != nullptr) parts = {part_on_wall(cut->patient, false), part_on_wall(cut->patient, true)};
  const bool same = std::equal(parts.begin(), parts.end(), cut_body_.begin(), cut_body_.end(),
                               [](const auto& a, const auto& b) { return a.triangles == b->triangles; });
  if (!same) {
    cut_body_.clear();
    for (geometry::Surface& part : parts) {
      cut_body_.push_back(std::make_shared<const geometry::Surface>(std::move(part)));
    }
    crossed_ = cut != nullptr ? cut->crossed : std::vector<std::size_t>();
    rebuild_space();
    return;
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto points_mm = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(parts[k].points_mm));
    for (SpaceView* space : {&views_.space(), &views_.second_space()}) {
      space->view().move_surface(cut_body_[k], points_mm);
    }
  }
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
  const bool liver = !patient_body_.empty() && (pick.surface == patient_body_[0] || pick.surface == atlas_body_[0]);
  if (!liver) return std::nullopt;
  const auto& rest_mm = patient_.structures.front().surface->points_mm;
  std::array<Eigen::Vector3d, 3> corners_mm;
  for (std::size_t k = 0; k < 3; ++k) corners_mm[k] = rest_mm[static_cast<std::size_t>(pick.corners[k])];
  return PlaceOnLiver{
      pick.weights[0] * corners_mm[0] + pick.weights[1] * corners_mm[1] + pick.weights[2] * corners_mm[2],
      (corners_mm[1] - corners_mm[0]).cross(corners_mm[2] - corners_mm[0]).normalized()};
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
  scene::SurfaceItem item{name, body[structure], look.colour, look.opacity, look.finish, {}};
  if (bodies == Bodies::both) {
    item.colour = &body == &atlas_body_ ? red : blue;
    item.opacity = structure == 0 ? 0.45 : 0.8;
    item.finish = scene::Finish::light;
  } else if (structure == 0 && liver_colour_ == LiverColour::displacement && has_figures(state_)) {
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
    scene::Scene atlas = space_scene(Bodies::atlas);
    atlas.annotations.title = tr("One stiffness from the atlas").toStdString();
    for (scene::Scene* each : {&patient, &atlas}) each->annotations.text_scale = 0.8;
    views_.space().show_scene(patient);
    views_.second_space().show_scene(atlas);
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
    if (bodies != Bodies::patient) scene.surfaces.push_back(item(k, atlas_body_, bodies));
    if (bodies == Bodies::atlas) continue;
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
    if (cuts(Bodies::atlas)) content.cuts.push_back({atlas_body_[k], has_both() ? red : colour, 1.6});
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

void PatientViews::apply_state() {
  const bool moved = state_ && !at_rest();
  const rehearsal::RehearsalBody* own = moved ? &state_->patient : nullptr;
  const rehearsal::RehearsalBody* atlas = moved && state_->atlas ? &*state_->atlas : nullptr;
  move_body(patient_body_, own);
  move_body(atlas_body_, atlas);
  draw_cut(moved ? state_->cut.get() : nullptr);

  draw_marks(views_.space(), bodies_ == Bodies::atlas && atlas != nullptr ? atlas : own);
  if (bodies_ == Bodies::side_by_side) draw_marks(views_.second_space(), atlas != nullptr ? atlas : own);
  // On the screen that is said above the views; a picture that leaves it says it itself, by its first clause.
  static const QRegularExpression end_of_clause("[:,]");
  views_.set_caption_of_pictures(translated(patient_.origin).section(end_of_clause, 0, 0));
  views_.redraw();
}

void PatientViews::draw_marks(SpaceView& space, const rehearsal::RehearsalBody* shown) {
  std::vector<scene::LandmarkItem> landmarks;
  if (shown != nullptr) {
    for (const auto& landmark : shown->landmarks) {
      const bool named = landmark.id == marked_landmark_ || landmark.id.starts_with("tumour");
      const bool known = has_figures(state_);
      const bool far = known && landmark.displacement_mm >= rehearsal::significant_mm;
      const QString name = structure_label(landmark.id);
      const QString text = known ? tr("%1  %2 mm").arg(name).arg(landmark.displacement_mm, 0, 'f', 1) : name;
      landmarks.push_back({named ? text.toStdString() : std::string(), landmark.displaced_mm,
                           landmark.id == marked_landmark_ ? 3.5 : 2.2, far ? amber : calm});
    }
  }
  std::vector<scene::ArrowItem> arrows;
  std::vector<scene::RodItem> rods;
  std::optional<SpaceView::Grips> grips;
  for (const ToolInView& tool : at_rest() ? std::vector<ToolInView>() : tools_) {
    Eigen::Vector3d at_mm = tool.center_mm;
    if (shown != nullptr && !shown->structures_mm.empty()) {
      at_mm = moved_with(patient_body_.front()->points_mm, shown->structures_mm.front(), at_mm);
    }
    const Eigen::Vector3d reach_mm = arrow_length_mm(tool.force_N) * tool.direction;
    const Eigen::Vector3d free_end_mm = at_mm + (tool.pulls ? reach_mm : Eigen::Vector3d(-reach_mm));
    arrows.push_back({tool.pulls ? at_mm : free_end_mm, tool.pulls ? free_end_mm : at_mm, 3.2, tool_colour,
                      tr("%1 N").arg(tool.force_N, 0, 'f', 1).toStdString()});
    for (const mechanics::Rod& rod : drawn_tool(tool, at_mm))
      rods.push_back({rod.from_mm, rod.to_mm, rod.radius_mm, tool_steel});
    if (tool_movable_) grips = SpaceView::Grips{at_mm, free_end_mm};
  }
  if (workspace_) {
    landmarks.insert(landmarks.end(), workspace_->marks.begin(), workspace_->marks.end());
    arrows.insert(arrows.end(), workspace_->arrows.begin(), workspace_->arrows.end());
  }
  space.set_grips(grips);
  space.view().set_landmarks(landmarks);
  space.view().set_arrows(arrows);
  space.view().set_rods(rods);
}

void PatientViews::move_body(const Body& body, const rehearsal::RehearsalBody* displaced) {
  for (std::size_t k = 0; k < body.size(); ++k) {
    const bool moved = displaced != nullptr && k < displaced->structures_mm.size();
    const auto& rest_mm = body[k]->points_mm;
    const auto& points_mm = moved ? displaced->structures_mm[k] : rest_mm;
    const scene::Points shared_mm = moved ? std::make_shared<const std::vector<Eigen::Vector3d>>(points_mm) : nullptr;
    for (SpaceView* space : {&views_.space(), &views_.second_space()}) space->view().move_surface(body[k], shared_mm);
    for (SliceView* slice : views_.slices()) slice->view().move_surface(body[k], shared_mm);
    if (k != 0 || liver_colour_ != LiverColour::displacement || !has_figures(state_) || bodies_ == Bodies::both)
      continue;
    std::vector<double> distance_mm(points_mm.size());
    for (std::size_t p = 0; p < distance_mm.size(); ++p) distance_mm[p] = (points_mm[p] - rest_mm[p]).norm();
    for (SpaceView* space : {&views_.space(), &views_.second_space()})
      space->view().recolour_surface(body[k], distance_mm);
  }
}

}  // namespace glisson::widgets
