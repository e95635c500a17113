#pragma once
// A cut drawn over the liver in space while rigid tools hold it: the left button presses on the liver, draws, and the
// parts open behind it. The stroke itself is rehearsal/stroke.h; here it meets the mouse, the views and the session.
//
// One advance is under way at a time, so that what a hand does meanwhile goes into the next. Meshfree nodes reach ahead
// of a cut: there the stroke is drawn first and cut when the button is let go.

#include <optional>
#include <QMouseEvent>
#include <QObject>
#include <QTimer>

#include "rehearsal/stroke.h"
#include "widgets/session/live_rehearsal.h"
#include "widgets/views/patient_views.h"

namespace glisson::widgets {

class FreehandKnife : public QObject {
  Q_OBJECT

 public:
  FreehandKnife(LinkedViews& views, PatientViews& patient_views, LiveRehearsal& rehearsal, QObject* parent = nullptr);

  // In hand, the left button cuts where it presses on the liver; elsewhere it turns the view as always.
  void take_in_hand(bool in_hand);
  void set_depth_mm(double depth_mm) { depth_mm_ = depth_mm; }
  // A stroke is being drawn, or what was drawn is not cut yet.
  [[nodiscard]] bool at_work() const { return stroke_.has_value(); }

 Q_SIGNALS:
  void said(const QString& what);  // why a stroke ended, or did not begin

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool begin(const SpaceView& space, const QMouseEvent& event);
  void draw(const SpaceView& space, const QPointF& position);
  void lift();
  void advance();
  void end();
  void show_line();
  [[nodiscard]] std::array<SpaceView*, 2> spaces() const;

  LinkedViews& views_;
  PatientViews& patient_views_;
  LiveRehearsal& rehearsal_;
  bool in_hand_ = false;
  double depth_mm_ = 15;
  std::optional<rehearsal::Stroke> stroke_;
  bool pressed_ = false;  // on the liver, and not let go: the view does not turn
  bool drawing_ = false;
  bool asked_ = false;                     // an advance of this stroke is on its way
  std::vector<Eigen::Vector3d> ahead_mm_;  // where the hand went, as it lay, and is not cut
  QTimer timer_;
};

}  // namespace glisson::widgets
