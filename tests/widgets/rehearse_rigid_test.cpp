// Rigid tools in contact in the Rehearse workspace: pushing, several at once, and a planned cut led on under them.

#include <QCheckBox>
#include <QPushButton>
#include <QtTest>

#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/rehearse_panel.h"

namespace glisson::widgets {
namespace {

class RehearseRigidTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }
  void init() { show_probe_on_block(*window_); }

  void a_rigid_probe_pushes_and_cannot_pull() {
    auto* rigid = child<QCheckBox>("rigid");
    QTest::mouseClick(rigid, Qt::LeftButton, Qt::NoModifier, QPoint(8, rigid->height() / 2));
    QCOMPARE(rehearsal().touch(), Touch::rigid);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    // At balance the body pushes back with what the tool pushes, within the contact's tolerance.
    QVERIFY(std::abs(rehearsal().state()->force_N.norm() - 1.0) < 0.05);
    QVERIFY(rehearsal().state()->patient.max_displacement_mm > 0.5);
    // It is solved when the reference body lies under it too; what was shown of the patient before is the same moment.
    QVERIFY(rehearsal().state()->reference.has_value());
    QCOMPARE(rehearsal().track().moments().size(), std::size_t{1});
    QCOMPARE(rehearsal().solids().size(), std::size_t{1});
    const auto shape = rehearsal().state()->patient.surface_mm;
    rehearsal().set_direction({1, 0, 0});
    QCOMPARE(rehearsal().solving(), Solving::refused);
    QVERIFY(child<QLabel>("solving_trouble")->text().contains("cannot pull"));
    QVERIFY(rehearsal().state()->patient.surface_mm == shape);
  }

  void several_rigid_tools_are_held_at_once() {
    rehearsal().set_touch(Touch::rigid);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QTest::mouseClick(child<QPushButton>("keep"), Qt::LeftButton);
    rehearsal().hold({"grasper", {90, 0, 40}, {0, -1, 0}, 12, {0, -1, 0}, 0.5});
    QCOMPARE(rehearsal().tools().size(), std::size_t{2});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().solving() == Solving::solved && rehearsal().solids().size() == 2, patience_ms);
    QTest::mouseClick(child<QPushButton>("release"), Qt::LeftButton);
    QCOMPARE(rehearsal().tools().size(), std::size_t{1});
    QCOMPARE(rehearsal().tools().front().preset, std::string("palpation-probe"));
  }

  // A grasper draws the free end to the left; the planned cut, before the tumour, is led on under it.
  void the_planned_cut_opens_step_by_step_while_a_tool_holds_the_liver() {
    auto* advance = child<QPushButton>("advance_cut");
    auto* back = child<QPushButton>("take_cut_back");
    auto* state = child<QLabel>("cut_state");
    QVERIFY(!advance->isEnabled());
    QVERIFY(state->text().contains("Resect"));
    const auto plane = geometry::CutSurface::plane({63, 0, 0}, {1, 0, 0}).value();
    window_->findChild<RehearsePanel*>()->show_plan(
        rehearsal::course_of(test::box_of_tetrahedra({6, 4, 4}, {120, 80, 80}), plane).value(), {},
        {"liver", "tumour-1"});
    QVERIFY(state->text().contains("rigid"));
    rehearsal().hold({"grasper", {120, 40, 40}, {1, 0, 0}, 15, {1, 0, 0}, 1.0});
    rehearsal().set_touch(Touch::rigid);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(!rehearsal().state()->cut);
    double opening_mm = 0;
    for (int step = 1; step <= 12; ++step) {
      QTRY_VERIFY_WITH_TIMEOUT(advance->isEnabled(), patience_ms);
      QTest::mouseClick(advance, Qt::LeftButton);
      QTRY_VERIFY_WITH_TIMEOUT(rehearsal().solving() != Solving::solving && rehearsal().cut_steps() == step,
                               patience_ms);
      QVERIFY2(rehearsal().solving() == Solving::solved, qPrintable(child<QLabel>("solving_trouble")->text()));
      QVERIFY(rehearsal().state()->cut->largest_opening_mm > opening_mm);
      opening_mm = rehearsal().state()->cut->largest_opening_mm;
    }
    // The front has passed the middle of the section, which is a square seen along a corner.
    const double share = rehearsal().state()->cut->open_share();
    QVERIFY(share > 0.45 && share < 0.65);
    QVERIFY(state->text().contains(QString("%1 %").arg(100 * share, 0, 'f', 0)));
    window_->views().space().look_from(scene::PatientView::surgeon);
    QTest::qWait(100);
    window_->grab().save(test::kept_picture("rehearse-cut.png"));
    QTest::mouseClick(back, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), 11, patience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(rehearsal().state()->cut->largest_opening_mm < opening_mm);
    // A tool that moves closes the way back.
    rehearsal().set_force_N(0.8);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(!back->isEnabled());
    QCOMPARE(rehearsal().cut_steps(), 11);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }

  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::RehearseRigidTest>(argc, argv); }

#include "rehearse_rigid_test.moc"
