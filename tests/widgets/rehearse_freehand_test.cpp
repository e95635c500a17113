// A cut drawn by the mouse over the liver in Rehearse's 3D view, while a grasper holds it.

#include <QCheckBox>
#include <QPushButton>
#include <QtTest>

#include "drag_in_view.h"
#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

class RehearseFreehandTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }

  // The block's front, drawn towards the surgeon at its free end.
  void init() {
    patient_ = block_patient(
        {14, 9, 9}, {{"tumour-1", {100, 40, 40}}},
        {{"tumour-1", std::make_shared<geometry::Surface>(test::sphere_surface(8, 2, {78, 12, 52})), 2.1}});
    window_->show_patient(patient_);
    window_->go_to("rehearse");
    space().look_from(scene::PatientView::surgeon);
    QVERIFY(!child<QPushButton>("knife")->isVisible());  // nothing holds the liver
    rehearsal().set_touch(Touch::rigid);
    rehearsal().hold({"grasper", {105, 0, 45}, {0, -1, 0}, 12, Vector3d(0.8, -1, 0).normalized(), 0.15});
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(child<QPushButton>("knife")->isVisible());
    child<NumberBox>("knife_depth")->setValue(depth_mm);
  }

  void parts_the_liver_behind_the_pointer_and_closes_it_again() {
    take_the_knife();
    const scene::Camera before = space().view().camera();
    press(curve(0));
    draw(0, 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().cut_steps() > 0, patience_ms);  // while the button is held
    QVERIFY(rehearsal().state()->cut->largest_opening_mm > 0);
    QTest::qWait(100);
    window_->grab().save(test::kept_picture("rehearse-freehand-under-way.png"));
    draw(0.6, 1);
    release(curve(1));
    const double opened_mm2 = wait_until_cut();
    QVERIFY2(rehearsal().solving() == Solving::solved, qPrintable(child<QLabel>("solving_trouble")->text()));
    // A ribbon as long as the line and as deep as was chosen, along the line of sight.
    double expected_mm2 = 0;
    for (double share = 0; share < 1; share += 0.01) {
      expected_mm2 += depth_mm * (curve(share + 0.01) - curve(share)).cross(before.sight).norm();
    }
    QVERIFY2(std::abs(opened_mm2 - expected_mm2) < 0.1 * expected_mm2, qPrintable(QString::number(opened_mm2)));
    QVERIFY(rehearsal().state()->cut->largest_opening_mm > 0.2);
    const QString said = child<QLabel>("cut_state")->text();
    QVERIFY2(said.contains(QString::number(1e-2 * opened_mm2, 'f', 1)) && said.contains("cm²"), qPrintable(said));
    QVERIFY2(said.contains("Crossed"), qPrintable(said));
    QVERIFY(space().view().camera().sight == before.sight);
    QTest::qWait(100);
    window_->grab().save(test::kept_picture("rehearse-freehand.png"));

    replays_to_the_bit();
    auto* back = child<QPushButton>("take_cut_back");
    const int steps = rehearsal().cut_steps();
    QVERIFY(steps >= 5);
    QTest::mouseClick(back, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), steps - 1, patience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(rehearsal().state()->cut->open_mm2 < opened_mm2 - 20);
    replays_to_the_bit();
  }

  // Where it was lifted it goes on, and where it would cross itself it says so and keeps what is cut.
  void goes_on_from_its_end_and_says_why_it_stops() {
    take_the_knife();
    press(curve(0));
    draw(0, 0.5);
    release(curve(0.5));
    const double half_mm2 = wait_until_cut();
    press(curve(0.5));
    draw(0.5, 1);
    release(curve(1));
    QVERIFY(wait_until_cut() > 1.7 * half_mm2);
    const auto strips = rehearsal().cut_along();
    QVERIFY(strips.back().surface.goes_on(strips.front().surface));

    const int steps = rehearsal().cut_steps();
    press({40, 0, 40});
    for (double x = 42; x < 100; x += 2) move({x, 0, 40});
    release({100, 0, 40});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().refusal().has_value(), patience_ms);
    QVERIFY(child<QLabel>("solving_trouble")->text().contains("crosses an earlier one"));
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().answered(), patience_ms);
    QVERIFY(rehearsal().cut_steps() >= steps);
    QVERIFY(rehearsal().state()->cut->open_mm2 > 1.7 * half_mm2);
    QTest::qWait(200);
    window_->grab().save(test::kept_picture("rehearse-freehand-refused.png"));
  }

  void beside_the_liver_the_button_turns_the_view_and_a_click_cuts_nothing() {
    take_the_knife();
    press({60, 0, 40});
    release({60, 0, 40});
    QTest::qWait(100);
    QCOMPARE(rehearsal().cut_steps(), 0);
    QVERIFY(!rehearsal().state()->cut);
    const scene::Camera before = space().view().camera();
    const QPoint corner(8, 8);
    QTest::mousePress(&space(), Qt::LeftButton, Qt::NoModifier, corner);
    for (int step = 1; step <= 5; ++step) QTest::mouseMove(&space(), corner + QPoint(10 * step, 0));
    QTest::mouseRelease(&space(), Qt::LeftButton, Qt::NoModifier, corner + QPoint(50, 0));
    QVERIFY(space().view().camera().sight != before.sight);
    space().look_from(scene::PatientView::surgeon);
    // Off the liver the line ends, and what was drawn is cut.
    press({70, 0, 20});
    for (double z = 18; z > -20; z -= 2) move({70, 0, z});
    const QPoint end = pixel_in(space(), {70, 0, -20});
    QTest::mouseRelease(&space(), Qt::LeftButton, Qt::NoModifier, end);
    QVERIFY(wait_until_cut() > 15 * depth_mm);
    // Put away, the button turns the view again.
    QTest::mouseClick(child<QPushButton>("knife"), Qt::LeftButton);
    const int steps = rehearsal().cut_steps();
    drag_in(space(), {30, 0, 60}, {30, 0, 20});
    QTest::qWait(100);
    QCOMPARE(rehearsal().cut_steps(), steps);
  }

  void meshfree_nodes_are_cut_when_the_line_is_drawn() {
    rehearsal().set_deformations(Deformations::meshfree);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    take_the_knife();
    press(curve(0));
    draw(0, 1);
    QCOMPARE(rehearsal().cut_steps(), 0);
    release(curve(1));
    const double opened_mm2 = wait_until_cut();
    QVERIFY2(opened_mm2 > 30 * depth_mm, qPrintable(QString::number(opened_mm2)));
    QVERIFY(rehearsal().state()->cut->largest_opening_mm > 0.1);
    QVERIFY(rehearsal().contact()->beside_elements->largest_opening_mm.has_value());
  }

  void at_large_strain_it_opens_too() {
    rehearsal().set_deformations(Deformations::large);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    take_the_knife();
    press(curve(0));
    draw(0, 0.6);
    release(curve(0.6));
    QVERIFY(wait_until_cut() > 20 * depth_mm);
    QVERIFY(rehearsal().state()->cut->largest_opening_mm > 0.1);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  static constexpr double depth_mm = 20;
  static Vector3d curve(double share) { return {74 + 5 * std::sin(3.1 * share), 0, 65 - 45 * share}; }

  LiveRehearsal& rehearsal() { return window_->rehearsal(); }
  SpaceView& space() { return window_->views().space(); }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  void take_the_knife() {
    auto* knife = child<QPushButton>("knife");
    if (!knife->isChecked()) QTest::mouseClick(knife, Qt::LeftButton);
    QVERIFY(knife->isChecked());
  }
  void press(const Vector3d& at_mm) {
    QTest::mousePress(&space(), Qt::LeftButton, Qt::NoModifier, pixel_in(space(), at_mm));
  }
  // At 60 mm/s.
  void move(const Vector3d& to_mm) {
    QTest::mouseMove(&space(), pixel_in(space(), to_mm));
    QTest::qWait(30);
  }
  void release(const Vector3d& at_mm) {
    QTest::mouseRelease(&space(), Qt::LeftButton, Qt::NoModifier, pixel_in(space(), at_mm));
  }
  void draw(double from_share, double to_share) {
    for (double share = from_share; share < to_share - 1e-9; share += 0.04)
      move(curve(std::min(to_share, share + 0.04)));
  }

  // Of the cut (mm2), once nothing is on the way; 0 where nothing came.
  double wait_until_cut() {
    int calm = 0;
    const bool done = QTest::qWaitFor(
        [&] {
          calm = rehearsal().answered() && rehearsal().solving() != Solving::solving ? calm + 1 : 0;
          return calm > 20;
        },
        patience_ms);
    return done && rehearsal().state()->cut ? rehearsal().state()->cut->open_mm2 : 0.0;
  }

  void replays_to_the_bit() {
    const rehearsal::Recording recorded = rehearsal().recording();
    const auto read = rehearsal::parse_recording(rehearsal::recording_text(recorded)).value();
    auto engine =
        rehearsal::SessionEngine::create(*patient_.rehearsal_setup, {}, rehearsal::reference_in(read)).value();
    QVERIFY(!rehearsal::replay(engine, read).has_value());
    QVERIFY(engine.state().cut != nullptr);
    QCOMPARE(engine.state().cut->open_mm2, rehearsal().state()->cut->open_mm2);
  }

  std::unique_ptr<MainWindow> window_;
  Patient patient_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) {
  return glisson::widgets::run_test<glisson::widgets::RehearseFreehandTest>(argc, argv);
}

#include "rehearse_freehand_test.moc"
