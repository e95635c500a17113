// The liver laid over a frame by hand: moved by the mouse, kept in the case, undone like everything else.

#include "guidance/hand_pose.h"
#include "widgets/guide/guide_page.h"

namespace glisson::widgets {

namespace {

constexpr const char* pose_key = "guide/pose";

}  // namespace

void GuidePage::connect_hand() {
  connect(panel_, &GuidePanel::by_hand_changed, this, &GuidePage::set_by_hand);
  connect(view_, &OverlayView::shifted, this, [this](const QPointF& by_px) {
    move_by_hand(guidance::shifted(hand_->pose, middle_mm(), *video_->sequence.camera, {by_px.x(), by_px.y()}));
  });
  connect(view_, &OverlayView::turned, this, [this](double right_deg, double down_deg) {
    move_by_hand(guidance::turned(hand_->pose, middle_mm(), right_deg, down_deg));
  });
  connect(view_, &OverlayView::rolled, this,
          [this](double clockwise_deg) { move_by_hand(guidance::rolled(hand_->pose, middle_mm(), clockwise_deg)); });
  connect(view_, &OverlayView::moved_in_depth, this,
          [this](double factor) { move_by_hand(guidance::moved_in_depth(hand_->pose, middle_mm(), factor)); });
  connect(view_, &OverlayView::let_go, this, [this] {
    keep_hand_pose();
    show_in_space();
  });
  connect(&hand_due_, &QTimer::timeout, this, &GuidePage::show_overlay);
  context_.undo.keep(pose_key, [this](const QJsonValue& kept) {
    take_kept_pose(kept);
    if (!has_video()) return;
    panel_->set_by_hand(hand_.has_value());  // shows what was undone
    show_overlay();
    show_in_space();
  });
}

void GuidePage::set_by_hand(bool by_hand) {
  if (by_hand && !(has_video() && video_->sequence.camera && !size_px_.isEmpty())) return panel_->set_by_hand(false);
  if (by_hand && !hand_) {
    const GuidedFrame* here = answered(frame());
    const bool is_placed = here != nullptr && here->placement.converged;
    hand_ =
        HandPose{video_->content, frame(),
                 is_placed ? here->placement.pose
                           : guidance::pose_before_camera(*video_->sequence.camera, size_px_.width(), size_px_.height(),
                                                          video_->guided.structures.front().at_rest)};
  }
  if (by_hand) panel_->lines().set_on(false);
  view_->set_by_hand(by_hand);
  if (by_hand) view_->setFocus();
  show_overlay();
  show_in_space();
}

Eigen::Vector3d GuidePage::middle_mm() const {
  return geometry::bounding_box(video_->guided.structures.front().at_rest.points_mm).center_mm();
}

void GuidePage::move_by_hand(const Eigen::Isometry3d& pose) {
  hand_->pose = pose;
  hand_->frame = frame();
  hand_due_.start();
}

void GuidePage::keep_hand_pose() {
  const QJsonValue now = json_of(hand_);
  if (hand_) hand_ = hand_pose_of(now);  // what is kept is what a refinement begins from, to the bit
  context_.undo.value_changed({GLISSON_TEXT("Place the liver by hand"), {}}, pose_key, kept_, now);
  kept_ = now;
  update_text();
}

void GuidePage::read_kept_pose() {
  const QJsonValue kept = context_.undo.value(pose_key);
  take_kept_pose(kept.isUndefined() ? QJsonValue::Null : kept);
}

void GuidePage::take_kept_pose(const QJsonValue& kept) {
  kept_ = kept;
  hand_ = hand_pose_of(kept);
  const bool is_of_this = hand_ && has_video() && hand_->sequence == video_->content && hand_->frame < answers_.size();
  if (!is_of_this) hand_.reset();
  update_text();
}

}  // namespace glisson::widgets
