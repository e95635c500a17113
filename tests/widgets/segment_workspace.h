#pragma once
// The window in the workspace Segment, with the case of small_case.h, and the hand that works in it.

#include <memory>
#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "shown.h"
#include "small_case.h"
#include "widgets/main_window.h"
#include "widgets/segment/segment_panel.h"

namespace glisson::widgets {

class SegmentWorkspace : public QObject {
 protected:
  void open() {
    folder_ = test::small_case(temporary_.path());
    window_ = shown_window({1600, 1000});
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy() && !window_->findChild<QWidget*>("tool_brush")->isVisible(),
                             patience_ms);
    window_->go_to("segment");
    panel_ = window_->findChild<SegmentPanel*>();
    settle();
    QCOMPARE(panel_->editor().structures().size(), std::size_t(1));
    start_ = test::voxels_of(folder_, "liver");
  }
  void close() { window_.reset(); }

  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }
  SliceView& transverse() { return window_->views().slice(SliceDirection::transverse); }
  // A place of the transverse slice, mm to the patient's left and to the back of the ball's middle, in the widget.
  QPointF at(const QPointF& place_mm) {
    SliceView& view = transverse();
    const Eigen::Vector3d wanted = test::small_middle_mm() + Eigen::Vector3d(place_mm.x(), place_mm.y(), 0);
    const QPointF a(0, 0), b(100, 0), c(0, 100);
    const Eigen::Vector3d origin = view.place_at(a), x = view.place_at(b) - origin, y = view.place_at(c) - origin;
    return {100 * (wanted - origin).dot(x) / x.squaredNorm(), 100 * (wanted - origin).dot(y) / y.squaredNorm()};
  }
  void press(const QPointF& place_mm) {
    QTest::mousePress(&transverse(), Qt::LeftButton, Qt::NoModifier, at(place_mm).toPoint());
  }
  void move(const QPointF& place_mm) {
    const QPointF here = at(place_mm);
    QMouseEvent moved(QEvent::MouseMove, here, transverse().mapToGlobal(here), Qt::NoButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&transverse(), &moved);
  }
  void release(const QPointF& place_mm) {
    QTest::mouseRelease(&transverse(), Qt::LeftButton, Qt::NoModifier, at(place_mm).toPoint());
  }
  void stroke(const QPointF& from_mm, const QPointF& to_mm) {
    press(from_mm);
    move(0.5 * (from_mm + to_mm));
    move(to_mm);
    release(to_mm);
    settle();
  }
  // A button lets its key be seen pressed before it acts.
  void key(Qt::Key which) {
    for (QAbstractButton* button : panel_->findChildren<QAbstractButton*>()) {
      if (button->shortcut() != QKeySequence(which)) continue;
      QSignalSpy clicked(button, &QAbstractButton::clicked);
      press_key(*window_, which);
      QVERIFY(clicked.wait(patience_ms));
      return;
    }
    QFAIL("no such key");
  }
  void undo() {
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    settle();
  }
  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    if (panel_ != nullptr && panel_->isVisible()) QTRY_VERIFY_WITH_TIMEOUT(panel_->editor().can_edit(), patience_ms);
  }

  static constexpr int patience_ms = 20000;

  TemporaryFolder temporary_;
  std::filesystem::path folder_;
  std::size_t start_ = 0;
  std::unique_ptr<MainWindow> window_;
  SegmentPanel* panel_ = nullptr;
};

}  // namespace glisson::widgets
