// Resect, driven as a person drives it: a plane put through the crosshair, dragged in a slice, typed, set by clicks in
// space; a surface through points; numbers that can be worked out by hand.
//
// The liver is a block of 120 x 80 x 80 mm (768 ml) from the origin, its tumour a ball of 10 mm about (100, 40, 40).

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QTemporaryDir>
#include <QtTest>

#include "block_patient.h"
#include "drag_in_view.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "support/shapes.h"
#include "widgets/main_window.h"
#include "widgets/resect/resect_panel.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 20000;

Patient block_with_tumour() {
  Patient patient = block_patient(
      {6, 4, 4}, {},
      {{"tumour-1", std::make_shared<geometry::Surface>(test::sphere_surface(10, 3, {100, 40, 40})), 4.2}});
  imaging::Volume volume;
  volume.grid.size = {40, 32, 32};
  volume.grid.spacing_mm = {4, 4, 4};
  volume.grid.origin_mm = {-20, -24, -24};
  volume.values.resize(volume.grid.voxels());
  for (std::size_t k = 0; k < volume.values.size(); ++k) volume.values[k] = static_cast<float>(k % 40);
  patient.anatomy = std::make_shared<imaging::Volume>(std::move(volume));
  return patient;
}

class ResectTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window();
    window_->show_patient(block_with_tumour());
    window_->go_to("resect");
    panel_ = window_->findChild<ResectPanel*>();
    QVERIFY(panel_->isVisible());
    QTest::qWait(300);
  }

  void says_what_to_do_before_there_is_a_cut() {
    QVERIFY(child<QLabel>("resection_why")->text().contains("crosshair"));
    QVERIFY(!child<QLabel>("specimen_volume")->isVisible());
    QVERIFY(!child<QPushButton>("other_part")->isEnabled());
  }

  // The eye stays where it is, and what is drawn of the plane is little more than the liver.
  void a_cut_never_moves_the_camera() {
    SpaceView& space = window_->views().space();
    space.frame_all();
    const QSize size = space.size();
    const scene::Camera before = space.view().camera();
    window_->views().set_crosshair({85, 40, 40});
    QTest::mouseClick(child<QPushButton>("cut_through_crosshair"), Qt::LeftButton);
    await_specimen_ml(224);
    for (const char* shift_mm : {"10", "200", "0"}) {
      type("cut_shift", shift_mm);
      QTest::qWait(150);
    }
    await_specimen_ml(384);
    QCOMPARE(space.size(), size);
    QVERIFY(same(space.view().camera(), before));
    // Nor does the plane count when a larger window shows everything again.
    window_->resize(window_->size() + QSize(60, 40));
    QTRY_VERIFY(space.size() != size);
    window_->resize(window_->size() - QSize(60, 40));
    QTRY_COMPARE(space.size(), size);
    QVERIFY(same(space.view().camera(), before));
    space.look_from(scene::PatientView::surgeon);
    QVERIFY(same(space.view().camera(), before));
    QTest::mouseClick(child<QPushButton>("no_cut"), Qt::LeftButton);
  }

  void the_plane_is_drawn_within_its_box() {
    const geometry::Box box{{-10, -10, -10}, {130, 90, 90}};
    CutPlane plane{{60, 40, 40}, 0, 0, 0};
    for (const auto& normal : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0, 0.2, -1)}) {
      plane.put({70, 40, 45}, normal);
      const geometry::Surface part = part_within(plane, box);
      QVERIFY(geometry::check_surface(part).has_value());
      for (const Eigen::Vector3d& point : part.points_mm) {
        QVERIFY(std::abs((point - plane.point_mm()).dot(plane.normal())) < 1e-6);
        QVERIFY(((point - box.min_mm).array() > -1e-6).all() && ((box.max_mm - point).array() > -1e-6).all());
      }
      QVERIFY(geometry::area_mm2(part) > 9000);  // the box's smallest section through there is 100 x 100 mm
    }
    plane.put({600, 40, 40}, {1, 0, 0});  // it passes the box by
    QVERIFY(geometry::area_mm2(part_within(plane, box)) < 1000);
  }

  // A probe pushes the free end: the tumour goes with it, and its margin is that on the liver as it lies then. What was
  // worked out at rest is there again when the box is cleared.
  void plans_on_the_liver_as_the_tool_holds_it() {
    auto* as_held = child<QCheckBox>("as_held");
    QVERIFY(!as_held->isEnabled());
    QVERIFY(as_held->toolTip().contains("Rehearse"));
    LiveRehearsal& rehearsal = window_->rehearsal();
    rehearsal.hold({"palpation-probe", {120, 40, 40}, {1, 0, 0}, 25, {-1, 0, 0}, 2.0});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal.solving() == Solving::solved && rehearsal.state(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(as_held->isEnabled(), patience_ms);
    window_->views().set_crosshair({80, 40, 40});
    child<QComboBox>("cut_across")->setCurrentIndex(0);
    QTest::mouseClick(child<QPushButton>("cut_through_crosshair"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() != nullptr, patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(margin_mm() - 10) < 0.2, patience_ms);  // from x = 80 to the ball at 90
    QVERIFY(!child<QLabel>("retraction_told")->isVisible());

    as_held->click();
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() && panel_->live().result()->plan.retraction, patience_ms);
    const auto& tumour = panel_->live().result()->plan.tumours.front();
    QVERIFY2(tumour.shift_mm > 0.3, qPrintable(QString::number(tumour.shift_mm)));
    // It goes towards the cut along x, which is where the probe pushes.
    QVERIFY2(std::abs(10 - tumour.margin_mm - tumour.shift_mm) < 0.2 + 0.2 * tumour.shift_mm,
             qPrintable(QString("%1, moved by %2").arg(tumour.margin_mm).arg(tumour.shift_mm)));
    const QString told = child<QLabel>("retraction_told")->text();
    QVERIFY2(told.contains("goes by " + QString::number(tumour.shift_mm, 'f', 1)), qPrintable(told));
    QCOMPARE(panel_->live().result()->cut.liver, casefile::PlannedCut::Liver::held_aside);

    // Another force, another answer.
    rehearsal.set_force_N(1.0);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() && panel_->live().result()->plan.retraction &&
                                 panel_->live().result()->plan.tumours.front().shift_mm < 0.7 * tumour_shift(told),
                             patience_ms);
    as_held->click();
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() && !panel_->live().result()->plan.retraction, patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(margin_mm() - 10) < 0.2, patience_ms);
    rehearsal.take_tool_away();
    QTRY_VERIFY_WITH_TIMEOUT(!as_held->isEnabled(), patience_ms);
    QTest::mouseClick(child<QPushButton>("no_cut"), Qt::LeftButton);
  }

  void puts_a_plane_through_the_crosshair() {
    window_->views().set_crosshair({85, 40, 40});
    child<QComboBox>("cut_across")->setCurrentIndex(0);
    QTest::mouseClick(child<QPushButton>("cut_through_crosshair"), Qt::LeftButton);
    // Of 120 mm, 35 go: 224 ml. The tumour reaches to x = 90, 5 mm from the cut (its facets a little less far).
    await_specimen_ml(224);
    const auto& tumour = panel_->live().result()->plan.tumours.front();
    QCOMPARE(tumour.side, rehearsal::ResectionSide::specimen);
    QVERIFY(std::abs(tumour.margin_mm - 5) < 0.1);
    QVERIFY(child<QLabel>("specimen_volume")->text().contains("224 ml"));
    QVERIFY(child<QLabel>("remnant_volume")->text().contains("70.8 %"));
  }

  void dragging_the_line_in_a_slice_shifts_the_plane() {
    SliceView& coronal = window_->views().slice(SliceDirection::coronal);
    const double before_mm = panel_->plane()->point_mm().x();
    const Eigen::Vector3d from_mm(85, 40, 60), to_mm(88, 40, 60);
    drag_in(coronal, from_mm, to_mm);
    QVERIFY(std::abs(panel_->plane()->point_mm().x() - before_mm - 3) < 0.5);
    // Nor has the crosshair moved: the hand held the line.
    QVERIFY((coronal.crosshair_mm() - Eigen::Vector3d(85, 40, 40)).norm() < 1e-9);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(margin_mm() - 2) < 0.6, patience_ms);
    QCOMPARE(flag(), "● Under 5 mm");
  }

  void typed_numbers_move_the_plane_and_a_narrow_margin_is_called_r1() {
    type("cut_shift", "29.5");  // from the middle at x = 60: half a millimetre before the tumour
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(margin_mm() - 0.5) < 0.1, patience_ms);
    QCOMPARE(flag(), "▲ R1: under 1 mm");
    type("cut_shift", "35");  // x = 95, through it
    QTRY_COMPARE_WITH_TIMEOUT(flag(), "▲ R1: cut through", patience_ms);
  }

  void the_other_part_can_be_the_one_that_goes() {
    QTest::mouseClick(child<QPushButton>("other_part"), Qt::LeftButton);
    await_specimen_ml(608);  // 95 of 120 mm
    QTest::mouseClick(child<QPushButton>("other_part"), Qt::LeftButton);
    await_specimen_ml(160);
  }

  void dragging_a_lines_end_tilts_the_plane_about_its_middle() {
    type("cut_shift", "0");
    await_specimen_ml(384);
    SliceView& transverse = window_->views().slice(SliceDirection::transverse);
    window_->views().set_crosshair({60, 40, 40});
    QTest::qWait(50);
    // The line runs along y through (60, 40); its ends stand 45 mm off.
    const LineInSlice line = line_in_slice(*panel_->plane(), {60, 40, 40}, transverse.view().camera().sight);
    const Eigen::Vector3d end_mm = line.at_mm + 45 * line.along;
    const double aside_mm = 15;
    drag_in(transverse, end_mm, end_mm + Eigen::Vector3d(aside_mm, 0, 0));
    const double expected_deg = std::atan2(aside_mm, 45) * 180 / M_PI;
    const double turned_deg = std::acos(std::abs(panel_->plane()->normal().x())) * 180 / M_PI;
    QVERIFY2(std::abs(turned_deg - expected_deg) < 1.5, qPrintable(QString::number(turned_deg)));
    QVERIFY(std::abs(panel_->plane()->shift_mm) < 0.5);  // still through the middle
    await_specimen_ml(384);                              // a plane through the middle of a block halves it
  }

  void three_clicks_in_space_make_a_plane() {
    QTest::mouseClick(child<QPushButton>("no_cut"), Qt::LeftButton);
    QVERIFY(!panel_->plane());
    window_->views().space().look_from(scene::PatientView::anterior);
    QTest::mouseClick(child<QPushButton>("cut_by_clicks"), Qt::LeftButton);
    // On the front face (y = 0), two above each other at x = 30, and a third by the slice: the plane x = 30.
    click(window_->views().space(), {30, 0, 20});
    click(window_->views().space(), {30, 0, 60});
    window_->views().set_crosshair({60, 40, 40});
    click(window_->views().slice(SliceDirection::transverse), {30, 60, 40});
    QVERIFY(panel_->plane());
    QVERIFY(!child<QPushButton>("cut_by_clicks")->isChecked());
    QVERIFY(std::abs(panel_->plane()->normal().x()) > 0.995);
    QTRY_VERIFY_WITH_TIMEOUT(specimen_ml() > 185 && specimen_ml() < 199, patience_ms);  // 192 ml, to a pixel
    QTRY_COMPARE_WITH_TIMEOUT(flag(), "▲ Stays in the patient", patience_ms);
  }

  void a_surface_goes_through_points_set_in_slices() {
    auto* kind = child<QComboBox>("cut_kind");
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Down);
    Q_EMIT kind->activated(kind->currentIndex());  // what a choice by mouse does
    QVERIFY(child<QPushButton>("cut_draw")->isChecked());
    SliceView& transverse = window_->views().slice(SliceDirection::transverse);
    for (const Eigen::Vector3d& at_mm : {Eigen::Vector3d(80, 5, 40), {70, 40, 40}, {80, 75, 40}})
      click(transverse, at_mm);
    window_->views().set_crosshair({60, 40, 10});
    click(transverse, {80, 40, 10});
    window_->views().set_crosshair({60, 40, 70});
    click(transverse, {80, 40, 70});
    QCOMPARE(panel_->points_mm().size(), std::size_t{5});
    QVERIFY((panel_->points_mm()[1] - Eigen::Vector3d(70, 40, 40)).norm() < 0.5);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() != nullptr, patience_ms);
    // Bent towards the foot of the x axis: more goes than a plane at x = 80 would take.
    QTRY_VERIFY_WITH_TIMEOUT(specimen_ml() > 256, patience_ms);
    const double before_ml = specimen_ml();
    QTest::mouseClick(child<QPushButton>("cut_draw"), Qt::LeftButton);
    window_->views().set_crosshair({60, 40, 40});
    drag_in(transverse, {70, 40, 40}, {60, 40, 40});
    QVERIFY(std::abs(panel_->points_mm()[1].x() - 60) < 1);
    QTRY_VERIFY_WITH_TIMEOUT(specimen_ml() > before_ml + 5, patience_ms);
    QTest::mouseClick(child<QPushButton>("cut_drop_last"), Qt::LeftButton);
    QCOMPARE(panel_->points_mm().size(), std::size_t{4});
  }

  // From above the block to below it, 80 mm along its front face: what goes lies beside all that the eye sees there.
  void a_line_drawn_in_space_is_cut_under() {
    QTest::mouseClick(child<QPushButton>("no_cut"), Qt::LeftButton);
    SpaceView& space = window_->views().space();
    space.look_from(scene::PatientView::anterior);
    auto* freehand = child<QPushButton>("cut_freehand");
    scroll_to(freehand);
    QTest::mouseClick(freehand, Qt::LeftButton);
    QVERIFY(freehand->isChecked());
    drag_in(space, {150, 0, -10}, {150, 0, 90});  // beside the block: said, and to be drawn again
    QVERIFY(panel_->points_mm().empty() && freehand->isChecked());
    const scene::Camera before = space.view().camera();
    drag_in(space, {80, 0, -12}, {80, 0, 92});
    QVERIFY(!freehand->isChecked());
    QVERIFY(same(space.view().camera(), before));  // the hand drew, it did not turn the block
    QVERIFY(panel_->points_mm().size() >= 8);
    const Eigen::Vector2d seen = space.view().pixel_of({80, 0, 40});
    const double back_x_mm = space.view().position_beside({80, 80, 40}, seen.x(), seen.y()).x();
    const double wanted_ml = 0.5 * ((120 - 80) + (120 - back_x_mm)) * 80 * 80 / 1000;
    QVERIFY(back_x_mm > 81);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(specimen_ml() - wanted_ml) < 5, patience_ms);  // to a pixel
    // Its points are those of a sheet: the front one in the middle can be dragged.
    QTest::mouseClick(freehand, Qt::LeftButton);
    QTest::mouseClick(child<QPushButton>("cut_draw"), Qt::LeftButton);
    QVERIFY(!freehand->isChecked() && child<QPushButton>("cut_draw")->isChecked());
    QTest::mouseClick(child<QPushButton>("cut_draw"), Qt::LeftButton);
  }

  void the_parts_come_apart_in_the_picture() {
    const QImage together = window_->views().space().picture();
    child<QSlider>("apart")->setValue(60);
    QTest::qWait(100);
    const QImage apart = window_->views().space().picture();
    QVERIFY(together != apart);
  }

  void leaving_gives_the_views_back() {
    window_->go_to("rehearse");
    SliceView& transverse = window_->views().slice(SliceDirection::transverse);
    window_->views().set_crosshair({60, 40, 40});
    click(transverse, {70, 40, 40});
    QVERIFY((transverse.crosshair_mm() - Eigen::Vector3d(70, 40, 40)).norm() < 1);
    window_->go_to("resect");
  }

  void keeps_the_plan_in_the_case_and_takes_it_up_again() {
    const QTemporaryDir folder;
    Patient kept = block_with_tumour();
    kept.folder = folder.path().toStdString();
    window_->show_patient(kept);
    QVERIFY(!panel_->plane());
    window_->views().set_crosshair({30, 40, 40});
    QTest::mouseClick(child<QPushButton>("cut_through_crosshair"), Qt::LeftButton);
    await_specimen_ml(192);
    auto* keep = child<QPushButton>("keep_plan");
    QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), patience_ms);
    scroll_to(keep);
    QTest::mouseClick(keep, Qt::LeftButton);
    const auto written = kept.folder / "results" / "resection" / "resection.json";
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(written), patience_ms);
    window_->show_patient(block_with_tumour());
    QVERIFY(!panel_->plane());
    QVERIFY(!keep->isEnabled());
    QVERIFY(keep->toolTip().contains("not kept in a case folder"));
    window_->show_patient(kept);
    QVERIFY(panel_->plane());
    await_specimen_ml(192);
  }

  void says_that_a_cut_passes_the_liver_by() {
    type("cut_shift", "-300");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("resection_why")->text().contains("passes the liver by"), patience_ms);
    QVERIFY(!child<QLabel>("specimen_volume")->isVisible());
  }

  void leaves_a_picture_to_look_at() {
    type("cut_shift", "28");
    QTRY_VERIFY_WITH_TIMEOUT(specimen_ml() > 0, patience_ms);
    child<QSlider>("apart")->setValue(25);
    QTest::qWait(200);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("resect.png")));
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  // The first number with a dot in a sentence.
  static double tumour_shift(const QString& told) {
    return QRegularExpression("(\\d+\\.\\d)").match(told).captured(1).toDouble();
  }
  static bool same(const scene::Camera& a, const scene::Camera& b) {
    return (a.focus_mm - b.focus_mm).norm() < 1e-6 && (a.sight - b.sight).norm() < 1e-9 &&
           std::abs(a.visible_height_mm - b.visible_height_mm) < 1e-6;
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*panel_, name);
  }
  void scroll_to(QWidget* widget) {
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(widget);
    QTest::qWait(50);
  }
  static void click(RenderWidget& view, const Eigen::Vector3d& position_mm) {
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, pixel_in(view, position_mm));
  }
  void type(const char* name, const QString& number) {
    auto* box = child<QDoubleSpinBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    QTest::keyClick(box, Qt::Key_Return);
  }
  double specimen_ml() const { return panel_->live().result() ? panel_->live().result()->plan.specimen_ml : 0; }
  double margin_mm() const {
    return panel_->live().result() ? panel_->live().result()->plan.tumours.front().margin_mm : -1;
  }
  QString flag() {
    const auto* item = child<QTableWidget>("margins")->item(0, ResectionResults::flag_column);
    return item != nullptr ? item->text() : QString();
  }
  void await_specimen_ml(double wanted_ml) {
    QTRY_VERIFY2_WITH_TIMEOUT(std::abs(specimen_ml() - wanted_ml) < 1, qPrintable(QString::number(specimen_ml())),
                              patience_ms);
  }

  std::unique_ptr<MainWindow> window_;
  ResectPanel* panel_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ResectTest>(argc, argv); }

#include "resect_test.moc"
