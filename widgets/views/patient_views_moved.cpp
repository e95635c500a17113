// What of the patient moves under tools: its bodies, an open cut, landmarks and the tools themselves.

#include <algorithm>
#include <QRegularExpression>

#include "geometry/clip_surface.h"
#include "widgets/views/patient_views.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr scene::Colour tool_colour{0.20, 0.83, 0.85};
constexpr scene::Colour tool_steel{0.72, 0.76, 0.80};
constexpr scene::Colour calm{0.90, 0.93, 0.96};
constexpr scene::Colour far_colour{1.0, 0.72, 0.20};

// The triangles of a cut liver that are its walls, or those that are not, with the points that they use.
geometry::Surface part_on_wall(const geometry::Surface& cut, bool wall) {
  const auto& on_wall = geometry::find_field(cut.cell_fields, "wall")->values;
  return geometry::kept_part(cut, [&](std::size_t t) { return (on_wall[t] != 0) == wall; });
}

// An opened surface as it lies without tools and opening.
geometry::Surface at_rest_of(const geometry::Surface& cut) {
  geometry::Surface rest = cut;
  const auto& at_rest_mm = geometry::find_field(cut.point_fields, "at_rest_mm")->values;
  for (std::size_t p = 0; p < rest.points_mm.size(); ++p) {
    rest.points_mm[p] = Eigen::Map<const Eigen::Vector3d>(&at_rest_mm[3 * p]);
  }
  return rest;
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

void PatientViews::apply_state() {
  const bool moved = state_ && !at_rest();
  const rehearsal::RehearsalBody* own = moved ? &state_->patient : nullptr;
  const rehearsal::RehearsalBody* reference = moved && state_->reference ? &*state_->reference : nullptr;
  move_body(patient_body_, own);
  move_body(reference_body_, reference);
  move_tubes(patient_tubes_, own);
  move_tubes(reference_tubes_, reference);
  draw_cut(moved ? state_->cut.get() : nullptr);

  draw_marks(views_.space(), bodies_ == Bodies::reference && reference != nullptr ? reference : own);
  if (bodies_ == Bodies::side_by_side) draw_marks(views_.second_space(), reference != nullptr ? reference : own);
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
      const bool known = has_figures();
      const bool far = known && landmark.displacement_mm >= rehearsal::significant_mm;
      const QString name = structure_label(landmark.id);
      const QString text = known ? tr("%1  %2 mm").arg(name).arg(landmark.displacement_mm, 0, 'f', 1) : name;
      landmarks.push_back({named ? text.toStdString() : std::string(), landmark.displaced_mm,
                           landmark.id == marked_landmark_ ? 3.5 : 2.2, far ? far_colour : calm});
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
    if (k != 0 || liver_colour_ != LiverColour::displacement || !has_figures() || bodies_ == Bodies::both) continue;
    std::vector<double> distance_mm(points_mm.size());
    for (std::size_t p = 0; p < distance_mm.size(); ++p) distance_mm[p] = (points_mm[p] - rest_mm[p]).norm();
    for (SpaceView* space : {&views_.space(), &views_.second_space()})
      space->view().recolour_surface(body[k], distance_mm);
  }
}

void PatientViews::move_tubes(const Body& tubes, const rehearsal::RehearsalBody* displaced) {
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (tubes[k] == nullptr) continue;
    const bool moved = displaced != nullptr && k < displaced->structures_mm.size();
    const VesselTubes::Vessel* vessel = vessel_tubes_.of(patient_.structures[k].name);
    scene::Points now_mm;
    if (moved && vessel != nullptr) {
      now_mm = std::make_shared<const std::vector<Eigen::Vector3d>>(
          VesselTubes::moved(*vessel, displaced->structures_mm[k]));
    }
    for (SpaceView* space : {&views_.space(), &views_.second_space()}) space->view().move_surface(tubes[k], now_mm);
  }
}

void PatientViews::draw_cut(const rehearsal::SessionCut* cut) {
  std::vector<geometry::Surface> parts;
  if (cut != nullptr) parts = {part_on_wall(cut->patient, false), part_on_wall(cut->patient, true)};
  cut_now_mm_ = parts.empty() ? std::vector<Eigen::Vector3d>() : parts.front().points_mm;
  const bool same = std::equal(parts.begin(), parts.end(), cut_body_.begin(), cut_body_.end(),
                               [](const auto& a, const auto& b) { return a.triangles == b->triangles; });
  if (!same) {
    cut_rest_mm_ = cut != nullptr ? part_on_wall(at_rest_of(cut->patient), false).points_mm : cut_now_mm_;
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

}  // namespace glisson::widgets
