// Resect with what is known of a liver's anatomy: segments found, taken by a click, the margin around a tumour, the
// true remnant told while a plane is dragged, plans kept, compared, undone.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>

#include "base/files.h"
#include "drag_in_view.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "vascular_case.h"
#include "widgets/main_window.h"
#include "widgets/rehearse/planned_course.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/session/load_patient.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 60000;

class PlanByAnatomyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::vascular_case(std::filesystem::path(parent_.path().toStdString()));
    window_ = shown_window({1500, 1000});
    auto patient = load_patient(folder_, {});
    QVERIFY(patient.has_value());
    patient_ = std::move(*patient);
    liver_ = geometry::bounding_box(patient_.structures.front().surface->points_mm);
    window_->show_patient(patient_);
    window_->go_to("resect");
    panel_ = window_->findChild<ResectPanel*>();
    QVERIFY(panel_->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(live().anatomy() != nullptr, patience_ms);
  }

  // Nobody asks for it: its veins, of a voxel or two towards their ends, are tubes in space as soon as these are found,
  // and go where their outlines go.
  void draws_thin_vessels_as_tubes() {
    const auto* views = window_->findChild<PatientViews*>();
    const VesselTubes& tubes = views->vessel_tubes();
    QTRY_VERIFY_WITH_TIMEOUT(tubes.of("portal-vein") != nullptr && tubes.of("hepatic-vein") != nullptr, patience_ms);
    QVERIFY(tubes.of("liver") == nullptr && tubes.of("tumour-1") == nullptr);
    const VesselTubes::Vessel& vein = *tubes.of("portal-vein");
    QCOMPARE(vein.follows.size(), vein.drawn->points_mm.size());
    std::vector<Eigen::Vector3d> outline_now_mm = vein.outline->points_mm;
    for (Eigen::Vector3d& point : outline_now_mm) point += Eigen::Vector3d(1, -2, 3);
    const auto now_mm = VesselTubes::moved(vein, outline_now_mm);
    for (std::size_t p = 0; p < now_mm.size(); ++p) {
      QVERIFY((now_mm[p] - vein.drawn->points_mm[p] - Eigen::Vector3d(1, -2, 3)).norm() < 1e-9);
      const auto nearest = static_cast<std::size_t>(vein.follows[p]);
      QVERIFY((vein.outline->points_mm[nearest] - vein.drawn->points_mm[p]).norm() < 12);
    }
    QVERIFY(!window_->views().space().picture().isNull());
    QVERIFY(window_->grab().save(glisson::test::kept_picture("vessels-as-tubes-in-window.png")));
  }

  void finds_segments_at_a_click() {
    QVERIFY(!child<QTableWidget>("segments")->isVisible());
    auto* find = child<QPushButton>("find_segments");
    QVERIFY(find->isVisibleTo(panel_));
    find->click();
    QTRY_VERIFY_WITH_TIMEOUT(live().anatomy() && live().anatomy()->has_segments, patience_ms);
    QVERIFY(live().anatomy()->has_trees);
    const auto* segments = child<QTableWidget>("segments");
    QTRY_VERIFY(segments->isVisibleTo(panel_) && segments->rowCount() > 4);
    double all_ml = 0;
    for (int row = 0; row < segments->rowCount(); ++row) {
      all_ml += segments->item(row, PlanByAnatomy::whole_column)->text().toDouble();
    }
    QVERIFY(std::abs(all_ml - live().anatomy()->planner.segments()[0].ml) < 8);
    child<QCheckBox>("show_segments")->click();
    QTest::qWait(600);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-segments.png")));
    child<QCheckBox>("show_segments")->click();
  }

  // The vessel along the border that is most in doubt is offered first; told where it lies, the trees keep that.
  void finds_segments_again_by_a_vessel_that_is_told() {
    const auto* offered = child<QComboBox>("vessel_at_crosshair");
    QVERIFY(offered->isVisibleTo(panel_));
    const vasculature::VesselTrees& trees = live().anatomy()->planner.trees();
    QCOMPARE(offered->count(), 6);
    QCOMPARE(offered->currentData().toInt(), static_cast<int>(trees.border_doubts.front().vessel));
    QVERIFY(offered->currentText().contains(" ml in doubt"));
    const vasculature::System system = vasculature::system_of(trees.border_doubts.front().vessel);
    const auto branch = std::find_if(trees.branches.begin(), trees.branches.end(),
                                     [&](const auto& one) { return one.system == system; });
    QVERIFY(branch != trees.branches.end());
    window_->views().set_crosshair(branch->points[branch->points.size() / 2].position_mm);
    child<QPushButton>("tell_vessel")->click();
    const auto told = [&] {
      return live().anatomy() && live().anatomy()->has_segments && live().anatomy()->planner.trees().clicks.size() == 1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(told(), patience_ms);
    QTest::qWait(300);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-vessel-told.png")));
  }

  // The border nearest to the crosshair is offered first; it passes where a hand sets it, is undone, and forgotten.
  void finds_segments_again_by_a_border_that_a_hand_set() {
    const auto borders = live().anatomy()->borders;
    const auto& places_mm = borders.at({5, 8});
    const Eigen::Vector3d place_mm = places_mm[places_mm.size() / 2];
    const Eigen::Vector3d set_mm = place_mm + Eigen::Vector3d(0, 0, 7);
    window_->views().set_crosshair(place_mm);
    auto* offered = child<QComboBox>("border_at_crosshair");
    QVERIFY(offered->isVisibleTo(panel_));
    QCOMPARE(offered->count(), static_cast<int>(borders.size()));
    QCOMPARE(offered->currentData().toString(), "V-VIII");
    window_->views().set_crosshair(set_mm);
    offered->setCurrentIndex(offered->findData("V-VIII"));
    QVERIFY(!child<QPushButton>("drop_border")->isVisibleTo(panel_));
    child<QPushButton>("tell_border")->click();
    const auto told = [&](std::size_t count) {
      return live().anatomy() && live().anatomy()->has_segments && live().anatomy()->told.borders.size() == count;
    };
    QTRY_VERIFY_WITH_TIMEOUT(told(1), patience_ms);
    QCOMPARE(live().anatomy()->told.clicks.size(), std::size_t{1});
    double nearest_mm = 100;
    for (const Eigen::Vector3d& place : live().anatomy()->borders.at({5, 8})) {
      nearest_mm = std::min(nearest_mm, (place - set_mm).norm());
    }
    QVERIFY2(nearest_mm < 3, qPrintable(QString::number(nearest_mm)));  // voxels, a part of the places of the border
    child<QCheckBox>("show_segments")->click();
    QTest::qWait(600);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-border-by-hand.png")));
    child<QCheckBox>("show_segments")->click();
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy() && told(0), patience_ms);
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy() && told(1), patience_ms);
    QTRY_VERIFY(child<QPushButton>("drop_border")->isVisibleTo(panel_));
    child<QPushButton>("drop_border")->click();
    QTRY_VERIFY_WITH_TIMEOUT(told(0), patience_ms);
  }

  // What was told is marked in the slices and in space, and dragged there: a step of undo. Delete takes it away. What
  // is refused stands where it was.
  void places_told_by_hand_are_dragged() {
    const auto told = [&] { return live().anatomy() ? live().anatomy()->told : vasculature::Told(); };
    const auto settled = [&] {
      return !window_->undo().busy() && !live().opening() && live().anatomy() && live().anatomy()->has_segments;
    };
    const auto& places_mm = live().anatomy()->borders.at({5, 8});
    const Eigen::Vector3d set_mm = places_mm[places_mm.size() / 2] + Eigen::Vector3d(0, 0, 4);
    window_->views().set_crosshair(set_mm);
    auto* offered = child<QComboBox>("border_at_crosshair");
    offered->setCurrentIndex(offered->findData("V-VIII"));
    child<QPushButton>("tell_border")->click();
    QTRY_VERIFY_WITH_TIMEOUT(told().borders.size() == 1 && settled(), patience_ms);
    const auto* handles = panel_->findChild<CutHandles*>();
    const auto marked_mm = [&]() -> std::optional<Eigen::Vector3d> {
      for (const scene::LandmarkItem& mark : handles->marks_in_space()) {
        if (QString::fromStdString(mark.label).startsWith("V")) return mark.position_mm;
      }
      return std::nullopt;
    };
    QCOMPARE(handles->marks_in_space().size(), std::size_t{2});  // the vessel that was told before, and the border
    QVERIFY(marked_mm() && (*marked_mm() - set_mm).norm() < 1e-3);
    QVERIFY((window_->views().crosshair_mm() - set_mm).norm() < 1e-9);  // the slices still show it

    SliceView& coronal = window_->views().slice(SliceDirection::coronal);
    const Eigen::Vector3d wanted_mm = set_mm + Eigen::Vector3d(3, 0, 6);
    drag_in(coronal, set_mm, wanted_mm);
    QVERIFY2((*marked_mm() - wanted_mm).norm() < 1.5, qPrintable(QString::number((*marked_mm() - set_mm).norm())));
    QTRY_VERIFY_WITH_TIMEOUT((told().borders.at(0).position_mm - wanted_mm).norm() < 1.5 && settled(), patience_ms);
    const Eigen::Vector3d dragged_mm = told().borders.at(0).position_mm;
    double nearest_mm = 100;
    for (const Eigen::Vector3d& place : live().anatomy()->borders.at({5, 8})) {
      nearest_mm = std::min(nearest_mm, (place - dragged_mm).norm());
    }
    QVERIFY2(nearest_mm < 3, qPrintable(QString::number(nearest_mm)));  // voxels, a part of the places of the border
    child<QCheckBox>("show_segments")->click();
    QTest::qWait(600);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-border-dragged.png")));
    child<QCheckBox>("show_segments")->click();
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled() && (told().borders.at(0).position_mm - set_mm).norm() < 1e-2, patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT((*marked_mm() - set_mm).norm() < 1e-2, patience_ms);
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled() && (told().borders.at(0).position_mm - dragged_mm).norm() < 1e-2, patience_ms);

    // In space across the line of sight.
    SpaceView& space = window_->views().space();
    const scene::Camera camera = space.view().camera();
    const Eigen::Vector3d aside_mm = dragged_mm - 4 * camera.up;
    drag_in(space, dragged_mm, aside_mm);
    QTRY_VERIFY_WITH_TIMEOUT((told().borders.at(0).position_mm - aside_mm).norm() < 2 && settled(), patience_ms);
    const Eigen::Vector3d now_mm = told().borders.at(0).position_mm;
    QVERIFY(std::abs((now_mm - dragged_mm).dot(camera.sight)) < 0.1);

    // Out of the liver: it is refused, and stands where it was.
    window_->views().set_crosshair(now_mm);
    QTest::qWait(100);
    drag_in(coronal, now_mm, Eigen::Vector3d(now_mm.x(), now_mm.y(), liver_.max_mm.z() + 8));
    QTRY_VERIFY_WITH_TIMEOUT(settled() && marked_mm() && (*marked_mm() - now_mm).norm() < 1e-2, patience_ms);
    QCOMPARE(told().borders.size(), std::size_t{1});

    QTest::mouseClick(&coronal, Qt::LeftButton, Qt::NoModifier, pixel_in(coronal, now_mm));
    QTest::keyClick(&coronal, Qt::Key_Delete);
    QTRY_VERIFY_WITH_TIMEOUT(settled() && told().borders.empty(), patience_ms);
    QCOMPARE(told().clicks.size(), std::size_t{1});
    QTRY_VERIFY_WITH_TIMEOUT(!marked_mm(), patience_ms);
  }

  // While it is dragged the answers follow, and a branch that is cut is named.
  void tells_what_lives_as_a_plane_moves() {
    window_->views().set_crosshair(liver_.center_mm());
    child<QPushButton>("cut_through_crosshair")->click();
    QTRY_VERIFY_WITH_TIMEOUT(live().result() != nullptr, patience_ms);
    const auto& answer = live().result()->answer;
    QVERIFY(answer.living_ml && *answer.living_ml > 0 && *answer.living_ml <= answer.remnant_ml);
    QVERIFY(child<QLabel>("alive_told")->text().contains("stay alive"));
    const auto* branches = child<QTableWidget>("branches_cut");
    QVERIFY(branches->rowCount() > 0);
    QVERIFY(branches->item(0, PlanByAnatomy::branch_column)->text().contains(" vein"));
    // Arteries below them, by their own length, each in its own colour.
    const QTableWidgetItem* artery = branches->item(branches->rowCount() - 1, PlanByAnatomy::branch_column);
    QVERIFY2(artery->text().startsWith("Hepatic artery"), qPrintable(artery->text()));
    QVERIFY(branches->item(artery->row(), PlanByAnatomy::beyond_column)->text().endsWith("mm"));
    QVERIFY(branches->item(0, PlanByAnatomy::beyond_column)->text().endsWith("ml"));
    QVERIFY(!artery->icon().isNull());
    const double before_ml = answer.remnant_ml;
    auto* shift = child<QDoubleSpinBox>("cut_shift");
    shift->setValue(shift->value() + 12);
    QTRY_VERIFY_WITH_TIMEOUT(live().result() && std::abs(live().result()->answer.remnant_ml - before_ml) > 5,
                             patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() != nullptr, patience_ms);
    // Voxels and mesh agree on how much stays.
    const auto apart_percent = [&] {
      const auto& now = live().result()->answer;
      return std::abs(100 * now.remnant_ml / now.liver_ml - panel_->live().result()->plan.remnant_percent());
    };
    QTRY_VERIFY_WITH_TIMEOUT(apart_percent() < 3, patience_ms);  // each answers at its own pace
    QTest::qWait(500);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-plane.png")));
    QVERIFY(!planned_course(patient_).course);
    keep("By a plane");
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{1}, patience_ms);
    // One click for the table and for whatever follows the plan: Rehearse's cut, Guide, the report.
    QVERIFY(live().kept().front().followed);
    const auto followed = planned_course(patient_);
    QVERIFY(followed.course);
    QVERIFY(std::abs(followed.course->surface.normal().dot(panel_->plane()->normal())) > 1 - 1e-9);
    QVERIFY(child<QTableWidget>("plans")->item(0, PlanList::name_column)->font().bold());
    child<QPushButton>("no_cut")->click();
    QTRY_VERIFY(!live().result());
  }

  void takes_segments_and_what_is_around_a_tumour() {
    auto* segments = child<QTableWidget>("segments");
    auto* take = child<QPushButton>("take_segments");
    QVERIFY(!take->isEnabled());
    const double first_ml = segments->item(0, PlanByAnatomy::whole_column)->text().toDouble();
    segments->item(0, PlanByAnatomy::segment_column)->setCheckState(Qt::Checked);
    QVERIFY(take->isEnabled());
    take->click();
    QTRY_VERIFY_WITH_TIMEOUT(live().result() && live().result()->removed, patience_ms);
    QVERIFY(std::abs(live().result()->answer.removed_ml - live().result()->answer.tumours_ml - first_ml) <
            1 + live().result()->answer.tumours_ml);
    QCOMPARE(segments->item(0, PlanByAnatomy::stays_column)->text(), QString("0"));
    const double segment_alone_ml = live().result()->answer.removed_ml;
    child<QPushButton>("take_around")->click();
    QTRY_VERIFY_WITH_TIMEOUT(live().result() && live().result()->cuts.size() == 2, patience_ms);
    QVERIFY(live().result()->answer.removed_ml > segment_alone_ml);
    QVERIFY(live().result()->answer.margin_mm.value_or(0) > 8);
    QVERIFY(panel_->live().result() == nullptr);  // the mesh is divided by planes and sheets alone
    QTest::qWait(500);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-segments-and-margin.png")));
    keep("Segment and margin");
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{2}, patience_ms);
    QVERIFY(live().kept().front().followed && !live().kept().back().followed);  // a plan without a plane leads no cut
  }

  void compares_plans_and_takes_one_up_again() {
    auto* plans = child<QTableWidget>("plans");
    QTRY_COMPARE(plans->rowCount(), 2);
    for (int row = 0; row < 2; ++row) {
      QVERIFY(plans->item(row, PlanList::stays_percent_column)->text().endsWith("%"));
      QVERIFY(plans->item(row, PlanList::alive_column)->text().endsWith("%"));
    }
    QTest::qWait(300);
    Q_EMIT plans->cellClicked(0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->plane().has_value() && panel_->by_anatomy().taken().empty(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(live().result() && live().result()->cuts.size() == 1, patience_ms);
    Q_EMIT plans->cellClicked(1, 0);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->by_anatomy().taken().size() == 2, patience_ms);
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(child<QPushButton>("keep_plan"));
    QTest::qWait(300);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("plan-compared.png")));
    // Undone and done again like anything else: each plan that was chosen, whole, and the one that was kept.
    const auto go = [&](Qt::KeyboardModifiers keys) {
      QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
      press_key(*window_, Qt::Key_Z, keys);
      QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    };
    const Qt::KeyboardModifiers back = Qt::ControlModifier, forth = Qt::ControlModifier | Qt::ShiftModifier;
    go(back);
    QVERIFY(panel_->plane().has_value() && panel_->by_anatomy().taken().empty());
    go(back);
    QVERIFY(!panel_->plane() && panel_->by_anatomy().taken().size() == 2);  // as it was before either was chosen
    go(back);
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{1}, patience_ms);
    go(forth);
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{2}, patience_ms);
    go(forth);
    QVERIFY(panel_->plane().has_value() && panel_->by_anatomy().taken().empty());
    go(forth);
    QVERIFY(!panel_->plane() && panel_->by_anatomy().taken().size() == 2);
    QTRY_COMPARE(plans->rowCount(), 2);
    plans->selectRow(0);
    child<QPushButton>("drop_plan")->click();
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{1}, patience_ms);
    QVERIFY(!planned_course(patient_).course);  // a plan that was dropped is followed by nobody
    QVERIFY(!std::filesystem::exists(folder_ / "results" / "resection"));
  }

  // What is followed goes back and forth with the step that kept it: bold in the list, led by Rehearse, drawn by Guide.
  void what_is_followed_is_undone_and_redone_with_the_plan() {
    const std::filesystem::path followed = folder_ / "results" / "resection" / "resection.json";
    const std::size_t before = live().kept().size();
    auto* no_cut = child<QPushButton>("no_cut");
    const auto keep_plane = [&](const char* name, int across) {
      if (no_cut->isEnabled()) no_cut->click();
      child<QComboBox>("cut_across")->setCurrentIndex(across);
      child<QPushButton>("cut_through_crosshair")->click();
      QTRY_VERIFY_WITH_TIMEOUT(panel_->live().result() != nullptr, patience_ms);
      keep(name);
      QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    };
    const auto go = [&](Qt::KeyboardModifiers keys) {
      press_key(*window_, Qt::Key_Z, keys);
      QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
      QTest::qWait(50);
    };
    const auto normal = [&] { return planned_course(patient_).course->surface.normal(); };
    keep_plane("First plane", 0);
    const std::string first = read_text_file(followed).value();
    const Eigen::Vector3d first_normal = normal();
    keep_plane("Second plane", 1);
    const std::string second = read_text_file(followed).value();
    QVERIFY(second != first && std::abs(normal().dot(first_normal)) < 0.9);
    go(Qt::ControlModifier);
    QCOMPARE(read_text_file(followed).value(), first);
    QVERIFY(std::abs(normal().dot(first_normal)) > 1 - 1e-9);
    QTRY_VERIFY_WITH_TIMEOUT(live().kept().back().followed, patience_ms);
    // Between the two, the first plane was taken away and the second set.
    go(Qt::ControlModifier);
    QVERIFY(!panel_->plane());
    go(Qt::ControlModifier);
    QVERIFY(std::abs(panel_->plane()->normal().dot(first_normal)) > 1 - 1e-9);
    go(Qt::ControlModifier);
    QVERIFY(!planned_course(patient_).course && !std::filesystem::exists(followed.parent_path()));
    go(Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(read_text_file(followed).value(), first);
    for (int step = 0; step < 3; ++step) go(Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(read_text_file(followed).value(), second);
    // A plan that is dropped is followed again once that is undone.
    auto* plans = child<QTableWidget>("plans");
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), before + 2, patience_ms);  // the list follows at its own pace
    QTRY_COMPARE_WITH_TIMEOUT(plans->rowCount(), int(before + 2), patience_ms);
    QVERIFY(live().kept().back().followed);
    plans->selectRow(plans->rowCount() - 1);
    child<QPushButton>("drop_plan")->click();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy() && !planned_course(patient_).course, patience_ms);
    go(Qt::ControlModifier);
    QCOMPARE(read_text_file(followed).value(), second);
  }

  // However far it goes; and so is a number, however many digits are typed.
  void a_drag_of_the_plane_is_a_step_of_undo() {
    if (child<QPushButton>("no_cut")->isEnabled()) child<QPushButton>("no_cut")->click();
    const Eigen::Vector3d middle_mm = liver_.center_mm();
    window_->views().set_crosshair(middle_mm);
    child<QComboBox>("cut_across")->setCurrentIndex(0);
    child<QPushButton>("cut_through_crosshair")->click();
    const double set_mm = panel_->plane()->shift_mm;
    SliceView& coronal = window_->views().slice(SliceDirection::coronal);
    drag_in(coronal, middle_mm + Eigen::Vector3d(0, 0, 15), middle_mm + Eigen::Vector3d(12, 0, 15));
    const double dragged_mm = panel_->plane()->shift_mm;
    QVERIFY2(std::abs(dragged_mm - set_mm - 12) < 1.5, qPrintable(QString::number(dragged_mm - set_mm)));
    auto* shift = child<QDoubleSpinBox>("cut_shift");
    shift->setFocus();
    shift->selectAll();
    QTest::keyClicks(shift, "-17");
    QTest::keyClick(shift, Qt::Key_Return);
    QCOMPARE(panel_->plane()->shift_mm, -17.0);
    panel_->setFocus();
    const auto go_and_find_mm = [&](Qt::KeyboardModifiers keys) {
      (void)QTest::qWaitFor([&] { return !window_->undo().busy(); }, patience_ms);
      press_key(*window_, Qt::Key_Z, keys);
      (void)QTest::qWaitFor([&] { return !window_->undo().busy(); }, patience_ms);
      return panel_->plane() ? panel_->plane()->shift_mm : 1000.0;
    };
    const Qt::KeyboardModifiers back = Qt::ControlModifier, forth = Qt::ControlModifier | Qt::ShiftModifier;
    QVERIFY(std::abs(go_and_find_mm(back) - dragged_mm) < 1e-6);
    QVERIFY(std::abs(go_and_find_mm(back) - set_mm) < 1e-6);
    QCOMPARE(go_and_find_mm(back), 1000.0);
    QVERIFY(std::abs(go_and_find_mm(forth) - set_mm) < 1e-6);
    QVERIFY(std::abs(go_and_find_mm(forth) - dragged_mm) < 1e-6);
    QVERIFY(std::abs(go_and_find_mm(forth) + 17) < 1e-6);
    QVERIFY(std::abs(shift->value() + 17) < 0.05);
  }

  void names_branches_in_words() {
    QCOMPARE(branch_label("portal/right/posterior/VI/2"), QString("Portal vein, right, posterior, VI, 2"));
    QCOMPARE(branch_label("hepatic/middle"), QString("Hepatic vein, middle"));
  }

  void shuts_down_cleanly() {
    patient_ = {};
    window_.reset();
  }

 private:
  [[nodiscard]] const LivePlan& live() const { return panel_->by_anatomy().live(); }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*panel_, name);
  }
  void keep(const char* name) {
    child<QLineEdit>("plan_name")->setText(name);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("keep_plan")->isEnabled(), patience_ms);
    child<QPushButton>("keep_plan")->click();
  }

  QTemporaryDir parent_;
  std::filesystem::path folder_;
  Patient patient_;
  geometry::Box liver_;
  std::unique_ptr<MainWindow> window_;
  ResectPanel* panel_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::PlanByAnatomyTest>(argc, argv); }

#include "plan_by_anatomy_test.moc"
