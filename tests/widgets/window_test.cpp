// The window, driven as a person drives it: a tool is placed by a click, pulled by slider and keys; the table flags.
//
// The body is a block of 120 x 80 x 80 mm that is held at its left end, with a "tumour" in its free end. The patient is
// softer than the reference body (the atlas), so that the two part.

#include <QAccessible>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include "block_patient.h"
#include "run_test.h"
#include "shown.h"
#include "support/shapes.h"
#include "widgets/hardware/platform_view.h"
#include "widgets/main_window.h"
#include "widgets/words/named.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 20000;  // for one solve on a machine that does other work too

imaging::Volume slope() {
  imaging::Volume volume;
  volume.grid.size = {40, 32, 32};
  volume.grid.spacing_mm = {4, 4, 4};
  volume.grid.origin_mm = {-20, -24, -24};
  volume.values.resize(volume.grid.voxels());
  for (std::size_t k = 0; k < volume.values.size(); ++k) volume.values[k] = static_cast<float>(k % 40);
  return volume;
}

Patient simulated_block() {
  Patient patient = block_patient(
      {6, 4, 4}, {{"tumour-1", {100, 40, 40}}, {"hilum", {8, 40, 40}}},
      {{"tumour-1", std::make_shared<geometry::Surface>(test::sphere_surface(10, 2, {100, 40, 40})), 4.2}});
  patient.origin = "SIMULATED: a block";
  patient.anatomy = std::make_shared<imaging::Volume>(slope());
  return patient;
}

class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window();
    window_->show_patient(simulated_block());
    QTest::qWait(300);
  }

  void opens_no_larger_than_the_screen() {
    const MainWindow opened;
    const QSize screen = opened.screen()->availableSize();
    QVERIFY(opened.width() <= screen.width() && opened.height() <= screen.height());
  }

  void shows_the_origin_of_a_patient_that_is_not_real() {
    const auto* origin = window_->findChild<QLabel*>("origin");
    QVERIFY(origin->isVisible());
    QVERIFY(origin->text().contains("SIMULATED"));
  }

  // Once on the screen; a picture that leaves it says it itself.
  void says_once_that_it_is_simulated() {
    SpaceView& space = window_->views().space();
    QVERIFY(space.picture().height() > space.height() * space.devicePixelRatioF());
    Patient real = simulated_block();
    real.origin.clear();
    window_->show_patient(real);
    QVERIFY(std::abs(space.picture().height() - space.height() * space.devicePixelRatioF()) < 1);
    window_->show_patient(simulated_block());
    const auto* origin = window_->findChild<QLabel*>("origin");
    window_->go_to("register");
    QVERIFY(!origin->isVisible());
    window_->go_to("rehearse");
    QVERIFY(origin->isVisible());
  }

  void goes_to_a_workspace_by_mouse_and_by_key() {
    QCOMPARE(window_->workspace(), "rehearse");
    QTest::mouseClick(child<QToolButton>("workspace_platform"), Qt::LeftButton);
    QCOMPARE(window_->workspace(), "platform");
    QVERIFY(window_->findChild<PlatformView*>()->isVisible());
    QVERIFY(!child<QPushButton>("place")->isVisible());
    // Ctrl and its number in the row.
    const auto row = window_->findChild<WorkspaceBar*>()->findChildren<QToolButton*>();
    const auto number = row.indexOf(child<QToolButton>("workspace_rehearse"));
    press_key(*window_, static_cast<Qt::Key>(Qt::Key_1 + number), Qt::ControlModifier);
    QCOMPARE(window_->workspace(), "rehearse");
    QVERIFY(child<QPushButton>("place")->isVisible());
  }

  // From the study to the report nothing stands between that a surgeon does not need.
  void research_stands_apart_behind_the_report() {
    QStringList names;
    for (const QToolButton* button : window_->findChild<WorkspaceBar*>()->findChildren<QToolButton*>())
      names << button->objectName().section('_', 1);
    QCOMPARE(names.join(' '),
             QString("study segment model rehearse resect report guide register platform evidence studies"));
    const auto* group = child<QLabel>("research_group");
    QVERIFY(child<QToolButton>("workspace_report")->geometry().right() < group->x());
    QVERIFY(group->geometry().right() < child<QToolButton>("workspace_register")->x() + 1);
  }

  void a_workspace_that_is_not_ready_says_what_it_needs() {
    Patient bare = simulated_block();
    bare.rehearsal = nullptr;
    window_->show_patient(bare);
    const auto* button = child<QToolButton>("workspace_rehearse");
    QVERIFY(button->toolTip().contains("Needs a model"));
    window_->show_patient(simulated_block());
    QVERIFY(!button->toolTip().contains("Needs a model"));
  }

  void says_what_evidence_changed_of_the_model() {
    const auto* evidence = window_->findChild<QLabel*>("evidence");
    QVERIFY(!evidence->isVisible());
    Patient changed = simulated_block();
    changed.evidence.effects = {
        {"stiffness-scale", true, {"The whole organ is {0} times as stiff as was declared.", {"2"}}},
        {"force-bias", false, {"The load cell was off.", {}}}};
    window_->show_patient(changed);
    QVERIFY(evidence->isVisible());
    QVERIFY(evidence->text().contains("Changed by evidence: The whole organ is 2 times as stiff"));
    QVERIFY(evidence->text().contains("The load cell was off."));
    window_->show_patient(simulated_block());  // taken back
    QVERIFY(!evidence->isVisible());
  }

  void plans_what_can_be_worn_for_the_patient_shown() {
    auto* view = window_->findChild<PlatformView*>();
    QCOMPARE(view->plan()->request.liver_volume_cm3, 768.0);
    Patient other = simulated_block();
    other.structures.front().volume_ml = 1200;
    other.mean_youngs_kPa = 4;
    window_->show_patient(other);
    QCOMPARE(view->plan()->request.liver_volume_cm3, 1200.0);
    QCOMPARE(*view->plan()->request.youngs_kPa, 4.0);
    window_->show_patient(simulated_block());
  }

  void places_a_tool_where_the_person_clicks() {
    QTest::mouseClick(child<QPushButton>("place"), Qt::LeftButton);
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    SpaceView& space = window_->views().space();
    space.look_from(scene::PatientView::left);  // at the free end
    QTest::mouseClick(&space, Qt::LeftButton, Qt::NoModifier, space.rect().center());
    QVERIFY(placed.wait(patience_ms));
    QVERIFY(window_->rehearsal().has_tool());
    // The free end is the plane x = 120, and the picture's middle looks at its middle.
    const Eigen::Vector3d at_mm = window_->rehearsal().tool_center_mm();
    QVERIFY(std::abs(at_mm.x() - 120) < 0.5);
    QVERIFY((at_mm.tail<2>() - Eigen::Vector2d(40, 40)).norm() < 5);
    QVERIFY(!child<QPushButton>("place")->isChecked());
  }

  void moves_twice_as_far_under_twice_the_force() {
    // Linear elasticity: displacement is proportional to force.
    auto* force = child<QDoubleSpinBox>("force");
    type_force("1.5");
    const double once_mm = window_->rehearsal().state()->patient.max_displacement_mm;
    type_force("3.0");
    const double twice_mm = window_->rehearsal().state()->patient.max_displacement_mm;
    QCOMPARE(force->value(), 3.0);
    QVERIFY(once_mm > 0);
    QVERIFY(std::abs(twice_mm - 2 * once_mm) < 1e-6 * twice_mm);
  }

  void keeps_slider_and_number_together() {
    auto* slider = child<QSlider>("force_slider");
    auto* force = child<QDoubleSpinBox>("force");
    slider->setFocus();
    const int before = slider->value();
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(slider->value(), before + 1);
    QVERIFY(std::abs(force->value() - 0.1 * slider->value()) < 1e-9);
    QVERIFY(std::abs(window_->rehearsal().force_N() - force->value()) < 1e-9);
  }

  void flags_in_words_from_5_mm_on() {
    auto* table = window_->findChild<LandmarkTable*>();
    QCOMPARE(table->rowCount(), 2);
    type_force("0");
    QCOMPARE(table->item(0, LandmarkTable::flag_column)->text(), QString());
    // Enough that the tumour, in the free end, passes 5 mm; the hilum, 8 mm from the held end, stays.
    const double force_N = force_for_displacement_mm(8);
    type_force(QString::number(force_N, 'f', 1));
    QVERIFY(!table->item(0, LandmarkTable::flag_column)->text().isEmpty());
    QCOMPARE(table->item(1, LandmarkTable::flag_column)->text(), QString());
  }

  void drags_turn_the_patient_and_do_not_place_anything() {
    SpaceView& space = window_->views().space();
    const Eigen::Vector3d before = space.view().camera().sight;
    const QPoint middle = space.rect().center();
    QTest::mousePress(&space, Qt::LeftButton, Qt::NoModifier, middle);
    QTest::mouseMove(&space, middle + QPoint(30, 5));
    QTest::mouseMove(&space, middle + QPoint(60, 10));
    QTest::mouseRelease(&space, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 10));
    QVERIFY((space.view().camera().sight - before).norm() > 0.05);
  }

  void links_the_slices_by_their_crosshair() {
    SliceView& transverse = window_->views().slice(SliceDirection::transverse);
    SliceView& coronal = window_->views().slice(SliceDirection::coronal);
    SliceView& sagittal = window_->views().slice(SliceDirection::sagittal);
    QTest::mouseClick(&transverse, Qt::LeftButton, Qt::NoModifier, transverse.rect().center() + QPoint(40, 25));
    const Eigen::Vector3d at_mm = transverse.crosshair_mm();
    QVERIFY((coronal.crosshair_mm() - at_mm).norm() < 1e-9);
    QVERIFY((sagittal.crosshair_mm() - at_mm).norm() < 1e-9);
    // The wheel steps by one slice of the volume, 4 mm along the body.
    QWheelEvent up(QPointF(50, 50), transverse.mapToGlobal(QPointF(50, 50)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                   Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&transverse, &up);
    QVERIFY(std::abs(transverse.crosshair_mm().z() - at_mm.z() - 4) < 1e-9);
    QVERIFY((sagittal.crosshair_mm() - transverse.crosshair_mm()).norm() < 1e-9);
  }

  void draws_something_in_every_view() {
    QTest::qWait(200);
    for (SliceView* slice : window_->views().slices()) QVERIFY(distinct_colours(*slice) > 20);
    QVERIFY(distinct_colours(window_->views().space()) > 50);
  }

  void takes_the_tool_away() {
    QTest::mouseClick(child<QPushButton>("release"), Qt::LeftButton);
    QVERIFY(!window_->rehearsal().has_tool());
    QCOMPARE(window_->findChild<LandmarkTable*>()->rowCount(), 0);
  }

  void cancels_long_work_and_says_so() {
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    QVERIFY(window_->work().start("Waiting", [](const Progress& progress) -> BackgroundWork::Then {
      while (!progress.cancelled()) QThread::msleep(5);
      return [] {};
    }));
    auto* cancel = child<QPushButton>("cancel");
    QVERIFY(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(finished.wait(patience_ms));
    QVERIFY(!cancel->isVisible());
  }

  void steps_through_slices_by_keys() {
    SliceView& coronal = window_->views().slice(SliceDirection::coronal);
    const double before_mm = coronal.crosshair_mm().y();
    coronal.setFocus();
    QTest::keyClick(&coronal, Qt::Key_Up);
    QVERIFY(std::abs(coronal.crosshair_mm().y() - before_mm - 4) < 1e-9);
    QTest::keyClick(&coronal, Qt::Key_Down);
    QVERIFY(std::abs(coronal.crosshair_mm().y() - before_mm) < 1e-9);
  }

  void says_in_the_window_that_a_folder_holds_no_images() {
    const QTemporaryDir empty;
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    window_->open_path(empty.path().toStdString());
    QVERIFY(finished.wait(patience_ms));
    const auto* notice = window_->findChild<QLabel*>("notice_text");
    QTRY_VERIFY(notice->isVisible());
    QVERIFY(notice->text().contains(empty.path()));
  }

  // Whoever has the window read aloud hears what each control is.
  void every_control_has_a_name() {
    QTest::qWait(50);
    QStringList unnamed;
    int controls = 0;
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!is_control(*widget) || qobject_cast<TourCard*>(widget->parentWidget()) != nullptr) continue;
      ++controls;
      QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(widget);
      if (heard != nullptr && !heard->text(QAccessible::Name).isEmpty()) continue;
      unnamed << QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
    }
    QVERIFY(controls > 100);
    QVERIFY2(unnamed.isEmpty(), qPrintable(unnamed.join(", ")));
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  void type_force(const QString& newtons) {
    auto* force = child<QDoubleSpinBox>("force");
    force->setFocus();
    force->selectAll();
    QTest::keyClicks(force, force->locale().toString(newtons.toDouble(), 'f', 1));
    QTest::keyClick(force, Qt::Key_Return);
  }

  // The tumour's displacement is proportional to the force.
  double force_for_displacement_mm(double wanted_mm) {
    type_force("1.0");
    return wanted_mm / window_->rehearsal().state()->patient.landmarks[0].displacement_mm;
  }

  static qsizetype distinct_colours(RenderWidget& view) {
    const QImage picture = view.picture();
    QSet<QRgb> colours;
    for (int y = 0; y < picture.height(); y += 2) {
      for (int x = 0; x < picture.width(); x += 2) colours.insert(picture.pixel(x, y));
    }
    return colours.size();
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::WindowTest>(argc, argv); }

#include "window_test.moc"
