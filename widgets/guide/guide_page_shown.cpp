// What the Guide workspace shows of its video: the frame, its outlines, the view in space, and its words.

#include <cmath>
#include <QLocale>

#include "casefile/structure_landmarks.h"
#include "guidance/hand_pose.h"
#include "widgets/guide/guide_page.h"
#include "widgets/guide/placed_scene.h"
#include "widgets/panels/parts.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// A frame's name in files is not what the window calls it.
QString why_not(const guidance::ElasticPlacement& placement, std::size_t frame) {
  Sentence sentence = placement.why_not;
  for (std::string& argument : sentence.arguments) argument = std::to_string(frame + 1);
  return translated(sentence);
}

}  // namespace

void GuidePage::show_frame() {
  if (!has_video()) return;
  const auto read = images_.image(timeline_->frame(), video_->sequence.images[frame()]);
  if (!read) say_error(read.error());
  const QImage image = read.value_or(QImage());
  if (!image.isNull()) size_px_ = image.size();
  // Without a picture the outlines are drawn on black, as large as the camera's middle tells.
  if (size_px_.isEmpty() && video_->sequence.camera) size_px_ = picture_size(video_->sequence.camera->matrix);
  view_->show_frame(image, size_px_);
  show_marks();
  show_overlay();
  show_in_space();
}

void GuidePage::show_overlay() {
  if (!has_video()) return;
  if (panel_->by_hand() && hand_) {
    hand_outlines_ = guidance::placed_outlines(*video_->sequence.camera, size_px_.width(), size_px_.height(),
                                               video_->guided.guidance.mesh, video_->guided.structures,
                                               guidance::rigid_placement(hand_->pose, video_->guided.guidance.mesh));
    view_->show_overlay(picture_of(hand_outlines_));
  } else {
    const GuidedFrame* here = answered(frame());
    view_->show_overlay(here != nullptr ? picture_of(here->overlay.outlines) : OverlayPicture{});
  }
  update_text();
}

void GuidePage::show_in_space() {
  if (!has_video()) return;
  const GuidedFrame* here = answered(frame());
  std::optional<guidance::ElasticPlacement> placement;
  const bool is_marking = panel_->lines().is_on();
  if (is_marking) {  // on the liver at rest
    const bool is_placed = here != nullptr && here->placement.converged;
    placement = guidance::rigid_placement(is_placed ? here->placement.pose
                                          : hand_   ? hand_->pose
                                                    : Eigen::Isometry3d::Identity(),
                                          video_->guided.guidance.mesh);
  } else if (panel_->by_hand() && hand_) {
    placement = guidance::rigid_placement(hand_->pose, video_->guided.guidance.mesh);
  } else if (here != nullptr && here->placement.converged) {
    placement = here->placement;
  }
  space_->setVisible(placement.has_value());
  if (!placement) return;
  pictures_->setStretchFactor(space_, is_marking ? 4 : 2);
  const scene::Scene shown =
      is_marking ? marking_scene(video_->guided, lines_, panel_->lines().line())
                 : placed_scene(video_->guided, *placement, video_->guided.guidance.frames[frame()].points_mm);
  liver_in_space_ = shown.surfaces.front().surface;
  space_->show_scene(shown);
  const bool is_nowhere = is_marking && !hand_ && (here == nullptr || !here->placement.converged);
  if (is_nowhere && !looked_in_space_) return space_->look_from(scene::PatientView::anterior);
  if (looked_in_space_ || !video_->sequence.camera) return;
  looked_in_space_ = true;
  space_->follow(laparoscope_camera(video_->guided, *placement, *video_->sequence.camera, size_px_.width(),
                                    1.0 * space_->width() / std::max(1, space_->height())));
}

// ---- Words ----

OverlayPicture GuidePage::picture_of(const std::vector<guidance::PlacedOutline>& outlines) const {
  OverlayPicture picture;
  for (const guidance::PlacedOutline& outline : outlines) {
    const auto& [red, green, blue] = video_->guided.structures[outline.structure].colour;
    picture.lines.push_back({outline, QColor(red, green, blue), label_of(outline)});
  }
  // What is looked for lies over the vessels that run before it.
  std::stable_partition(picture.lines.begin(), picture.lines.end(),
                        [](const OverlayPicture::Line& line) { return line.label.isEmpty(); });
  const bool is_fitted = !outlines.empty() && std::isfinite(outlines.front().sd_mm);
  if (is_fitted) picture.mistrust = tr("do not trust here");
  return picture;
}

// The liver is plain to see, and names along vessels would hide more than they say.
QString GuidePage::label_of(const guidance::PlacedOutline& outline) const {
  const std::string& name = video_->guided.structures[outline.structure].name;
  if (outline.structure == 0 || casefile::is_vessel(name) || name == "segments") return {};
  const QString label = structure_label(name);
  if (!std::isfinite(outline.sd_mm)) return label;
  const double within_mm = ninety_percent_in_sd * outline.sd_mm;
  if (!is_trusted(outline.sd_mm, panel_->look().tolerance_mm)) {
    return tr("%1: do not trust, \u00b1%2 mm").arg(label, number(within_mm));
  }
  return outline.deep_mm ? tr("%1 \u00b1%2 mm, %3 mm deep").arg(label, number(within_mm), number(*outline.deep_mm, 0))
                         : tr("%1 \u00b1%2 mm").arg(label, number(within_mm));
}

QString GuidePage::remark() const {
  if (!video_->sequence.camera) {
    return tr("The sequence names no camera, so that nothing can be drawn over the video.");
  }
  if (panel_->lines().is_on()) {
    return tr("Click along a line here, and along the same line on the model beside it.");
  }
  if (panel_->by_hand()) {
    return tr("By hand: nothing is known of the error yet. When it lies about right, press \"Refine\".");
  }
  const GuidedFrame* here = answered(frame());
  if (here == nullptr) {
    return task_ == Task::placing ? tr("Not placed yet: it is being computed.")
                                  : tr("Not placed yet: press \"Place the liver\".");
  }
  if (here->placement.converged) return {};
  const QString why = why_not(here->placement, frame());
  // No hand mends a cloud that is empty or of another scale: nothing was tried on it.
  const bool was_tried = !here->placement.displacement_mm.empty() || !here->placement.why_not.arguments.empty();
  return was_tried ? why + " " + tr("Place it by hand, then press \"Refine\".") : why;
}

QString GuidePage::reading() const {
  const GuidedFrame* here = answered(frame());
  if (panel_->by_hand() || here == nullptr || !here->placement.converged) return {};
  const double tolerance_mm = panel_->look().tolerance_mm;
  QStringList doubtful;
  for (const guidance::PlacedOutline& outline : here->overlay.outlines) {
    if (is_trusted(outline.sd_mm, tolerance_mm)) continue;
    doubtful.prepend(structure_label(video_->guided.structures[outline.structure].name));
  }
  const QString trust =
      doubtful.isEmpty() ? tr("All outlines lie within %1 mm of the truth, 90 times of 100.").arg(tolerance_mm)
      : static_cast<std::size_t>(doubtful.size()) == here->overlay.outlines.size()
          ? tr("Trust no outline of this frame to %1 mm.").arg(tolerance_mm)
          : tr("Not to be trusted everywhere to %1 mm: %2.").arg(tolerance_mm).arg(doubtful.join(", "));
  return trust + " " +
         tr("%1 % of the liver's surface is seen; it is deformed by %2 mm.")
             .arg(number(100 * here->placement.visible_share, 0), number(here->placement.elastic_rms_mm));
}

void GuidePage::update_text() {
  const QString said = said_ ? said_() : QString();
  welcome_->say(task_ == Task::opening ? tr("One moment...") : said);
  using Work = GuidePanel::Work;
  const bool any = std::any_of(answers_.begin(), answers_.end(),
                               [](const auto& one) { return one != nullptr && one->placement.converged; });
  panel_->show_state({task_ == Task::placing   ? Work::placing
                      : task_ == Task::filming ? Work::filming
                                               : Work::none,
                      hand_.has_value(), has_video() && video_->sequence.camera.has_value(), any});
  if (!has_video()) return;
  const auto placed = std::count_if(answers_.begin(), answers_.end(),
                                    [](const auto& one) { return one != nullptr && one->placement.converged; });
  const QString name = text_of(video_->file.parent_path().filename());
  file_->setText(placed == 0 ? tr("%1: %2 frames").arg(name).arg(answers_.size())
                             : tr("%1: placed in %2 of %3 frames").arg(name).arg(placed).arg(answers_.size()));
  show_text(origin_, translated(video_->sequence.simulated));
  show_text(reading_, said.isEmpty() ? reading() : said);
  view_->setAccessibleName(tr("Frame %1 with outlines").arg(timeline_->frame() + 1));
  view_->say(remark());
  const GuidedFrame* here = answered(frame());
  const bool by_hand = panel_->by_hand();
  panel_->targets().show_structures(video_->guided.structures,
                                    by_hand           ? hand_outlines_
                                    : here != nullptr ? here->overlay.outlines
                                                      : std::vector<guidance::PlacedOutline>{},
                                    panel_->look().tolerance_mm);
}

}  // namespace glisson::widgets
