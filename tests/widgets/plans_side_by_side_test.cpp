// Resect as a surgeon uses it to choose between plans. The cut is unrolled flat while it is dragged. A tumour's
// territory and an ablation over it come at a click each. Plans stand in the order that is asked for and as dots; they
// are copied, taken up again, and one of them is written as DICOM SEG.

#include <cmath>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>

#include "imaging/dicom_seg.h"
#include "imaging/segments_file.h"
#include "imaging/volume_file.h"
#include "kept_pictures.h"
#include "planning/ranking.h"
#include "run_test.h"
#include "shown.h"
#include "vascular_case.h"
#include "widgets/main_window.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 20000;

class PlansSideBySideTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::vascular_case(std::filesystem::path(parent_.path().toStdString()));
    window_ = shown_window({1600, 1000});
    auto patient = load_patient(folder_, {});
    QVERIFY(patient.has_value());
    patient_ = std::move(*patient);
    window_->show_patient(patient_);
    window_->go_to("resect");
    panel_ = window_->findChild<ResectPanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(live().anatomy() != nullptr, patience_ms);
    child<QPushButton>("find_segments")->click();
    QTRY_VERIFY_WITH_TIMEOUT(live().anatomy() && live().anatomy()->has_trees && !window_->work().busy(), patience_ms);
    for (const PatientStructure& structure : patient_.structures) {
      if (structure.name == "tumour-1") tumour_ = geometry::bounding_box(structure.surface->points_mm);
    }
  }

  // Each begins with nothing cut.
  void init() {
    auto* no_cut = child<QPushButton>("no_cut");
    if (no_cut->isEnabled()) no_cut->click();
  }

  // A plane 6 mm beside the tumour: the map comes as near to it as the answer says, says so under the
  // pointer, stands upright, shows each vessel that is cut, and follows when the plane moves.
  void unrolls_the_cut_while_it_is_moved() {
    QVERIFY(!view().isVisible());
    window_->views().set_crosshair(tumour_.center_mm() +
                                   Eigen::Vector3d(tumour_.max_mm.x() - tumour_.center_mm().x() + 6, 0, 0));
    press("cut_through_crosshair");
    QTRY_VERIFY_WITH_TIMEOUT(view().isVisible() && live().result() && !live().result()->resectograms.empty(),
                             patience_ms);
    const planning::Resectogram map = view().map();
    const auto nearest = nearest_mm(map);
    QVERIFY(nearest.has_value());
    // A place of the map is a voxel, 2 mm wide; the answer is within half a voxel.
    QVERIFY(std::abs(*nearest - live().result()->answer.tumours.front().margin_mm) < 2);
    const QString told_below = child<QLabel>("unrolled_told")->text();
    QVERIFY2(told_below.contains(QLocale().toString(*nearest, 'f', 1) + " mm from a tumour"), qPrintable(told_below));
    const auto [column, row] = place_of(map, *nearest);
    const QString told = view().told_at(view().drawn_at(column, row));
    QVERIFY2(told.contains("mm from a tumour"), qPrintable(told));
    // The plane faces the patient's left: the head is up, the back to the right.
    const QPointF from = view().drawn_at(0, 0);
    for (const auto& [axis, to] :
         {std::pair{map.along_row, view().drawn_at(10, 0)}, std::pair{map.along_column, view().drawn_at(0, 10)}}) {
      QVERIFY(std::abs(axis.x()) < 1e-9);
      QVERIFY((from.y() - to.y()) * axis.z() >= -1e-9 && (to.x() - from.x()) * axis.y() >= -1e-9);
    }
    QVERIFY(!map.vessels.empty());
    const auto& vessel = map.vessels.front();
    const QString named = view().told_at(view().drawn_at(vessel.column, vessel.row));
    QVERIFY2(named.contains(" vein") && named.contains("mm wide"), qPrintable(named));
    keep_pictures("unrolled", "resectogram");

    auto* shift = child<QDoubleSpinBox>("cut_shift");
    shift->setValue(shift->value() + 40);
    QTRY_VERIFY_WITH_TIMEOUT(!nearest_mm(view().map()) || *nearest_mm(view().map()) > *nearest + 10, patience_ms);
    // Folded away it is not worked out.
    press("unrolled");
    QVERIFY(!view().isVisible());
    shift->setValue(shift->value() - 4);
    QTRY_VERIFY_WITH_TIMEOUT(live().result()->resectograms.empty(), patience_ms);
    press("unrolled");
    QTRY_VERIFY_WITH_TIMEOUT(!live().result()->resectograms.empty() && view().isVisible(), patience_ms);
    press("no_cut");
    QTRY_VERIFY(!live().result() && !view().isVisible());
  }

  // What is proposed holds the whole tumour, and no smaller portal territory does; each click is a step back.
  void cuts_along_the_tumours_territory_and_around_it() {
    const auto* territory = child<QComboBox>("along_territory");
    const std::string proposed = territory->currentData().toString().toStdString();
    const planning::Planner& planner = live().anatomy()->planner;
    const auto takes = [&](const std::string& branch) {
      return planner.answer({planning::TerritoryCut{branch}})->tumours.front().side == planning::Side::removed;
    };
    QVERIFY2(takes(proposed) && proposed.rfind("portal/", 0) == 0, proposed.c_str());
    const auto ml_of = [&](const std::string& branch) {
      for (const NamedTerritory& one : live().anatomy()->territories) {
        if (one.branch == branch) return one.ml;
      }
      return 0.0;
    };
    for (const NamedTerritory& other : live().anatomy()->territories) {
      if (other.branch.rfind("portal/", 0) != 0 || other.ml >= ml_of(proposed)) continue;
      QVERIFY2(!takes(other.branch), other.branch.c_str());
    }
    press("take_territory");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) && answer_of(1)->tumours.front().side == planning::Side::removed,
                             patience_ms);
    QVERIFY(child<QLabel>("taken_told")->text().contains("Portal vein"));
    keep("Territory");
    press("no_cut");
    QTRY_VERIFY(live().result() == nullptr);
    press("take_around");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) && answer_of(1)->margin_mm.value_or(0) > 8, patience_ms);
    keep("Around");
    undo(Qt::ControlModifier);  // the plan that was kept
    undo(Qt::ControlModifier);  // what is around the tumour
    QVERIFY(taken().empty());
    undo(Qt::ControlModifier);  // no cut
    QVERIFY(taken().size() == 1 && std::holds_alternative<planning::TerritoryCut>(taken().front()));
    for (int step = 0; step < 3; ++step) undo(Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(taken().size() == 1 && std::holds_alternative<planning::MarginCut>(taken().front()));
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{2}, patience_ms);
    press("no_cut");
  }

  // The smallest ball that holds the tumour with its margin; its size typed over; a second zone beside it; given back.
  void ablates_a_tumour() {
    press("ablating");
    press("ablate_tumour");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) && answer_of(1)->ablated_ml > 0, patience_ms);
    // The ball is about the outline's surface, the answer about its voxels of 2 mm.
    QVERIFY2(std::abs(*answer_of(1)->margin_mm - 10) < 3, qPrintable(QString::number(*answer_of(1)->margin_mm)));
    QVERIFY(child<QLabel>("alive_told")->text().contains("ablated"));
    keep_pictures("ablation_width", "ablation");
    const double before_ml = answer_of(1)->ablated_ml;
    auto* width = child<QDoubleSpinBox>("ablation_width");
    width->setValue(width->value() + 10);
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) && answer_of(1)->ablated_ml > 1.2 * before_ml, patience_ms);
    const auto& zone = std::get<planning::AblationCut>(taken().front());
    QVERIFY(std::abs(zone.radius_across_mm - zone.radius_along_mm - 5) < 1e-9);
    keep("Ablation");
    window_->views().set_crosshair(tumour_.center_mm() + Eigen::Vector3d(0, 0, 15));
    press("ablate_at_crosshair");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(2) != nullptr, patience_ms);
    Q_EMIT child<QLabel>("taken_told")->linkActivated("0");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) != nullptr, patience_ms);
    undo(Qt::ControlModifier);
    QCOMPARE(taken().size(), std::size_t{2});
    press("no_cut");
  }

  // As planning::two_stages says of the same cut, for the branch that is chosen and the growth that is typed.
  void tells_what_is_left_after_an_embolisation() {
    press("take_around");
    QTRY_VERIFY_WITH_TIMEOUT(answer_of(1) != nullptr, patience_ms);
    QVERIFY(!live().result()->stages);
    press("staging");
    auto* embolised = child<QComboBox>("embolised");
    embolised->setFocus();
    QTest::keyClick(embolised, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(live().result()->stages.has_value(), patience_ms);
    auto* growth = child<QDoubleSpinBox>("growth");
    growth->setValue(50);
    QTRY_VERIFY_WITH_TIMEOUT(
        std::abs(live().result()->stages->grown_ml - 1.5 * live().result()->stages->grows_ml) < 1e-9, patience_ms);
    const auto wanted = planning::two_stages(live().anatomy()->planner,
                                             {embolised->currentData().toString().toStdString()}, taken(), 50);
    QVERIFY(wanted && wanted->embolised_ml > 10);
    QCOMPARE(live().result()->stages->grown_percent, wanted->grown_percent);
    const QString told = child<QLabel>("two_stages_told")->text();
    QVERIFY2(told.contains(QString::number(wanted->grown_ml, 'f', 0) + " ml"), qPrintable(told));
    keep_pictures("growth", "two-stages");
    embolised->setFocus();
    QTest::keyClick(embolised, Qt::Key_Up);
    QTRY_VERIFY_WITH_TIMEOUT(!live().result()->stages, patience_ms);
    press("staging");
    press("no_cut");
  }

  void puts_plans_in_the_order_that_is_asked_for() {
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableWidget>("plans")->rowCount(), 3, patience_ms);
    QCOMPARE(names(), (QStringList{"Territory", "Around", "Ablation"}));
    std::vector<planning::PlanAnswer> answers;
    for (const KeptPlanAnswer& kept : live().kept()) answers.push_back(*kept.answer);
    auto* rank = child<QComboBox>("rank_plans");
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(rank);
    rank->setFocus();
    for (const auto by : {planning::RankBy::margin, planning::RankBy::living, planning::RankBy::branches}) {
      QTest::keyClick(rank, Qt::Key_Down);
      QStringList wanted;
      for (const std::size_t n : planning::ranked(answers, by)) {
        wanted << QString::fromStdString(live().kept()[n].kept.plan.name);
      }
      QCOMPARE(names(), wanted);
    }
    for (int key = 0; key < 3; ++key) QTest::keyClick(rank, Qt::Key_Up);
  }

  // Each plan a dot; those that another beats are said to be so; a click on a dot takes the plan up.
  void draws_plans_by_margin_and_living_tissue() {
    auto* plot = child<PlanPlot>("plan_plot");
    QVERIFY(plot->isVisibleTo(panel_));
    QCOMPARE(plot->plans().size(), std::size_t{3});
    std::vector<planning::PlanAnswer> answers;
    for (const KeptPlanAnswer& kept : live().kept()) answers.push_back(*kept.answer);
    const auto better = planning::beaten_by(answers);
    for (std::size_t n = 0; n < 3; ++n) {
      QCOMPARE(plot->plans()[n].is_beaten, !better[n].empty());
      QCOMPARE(plot->plans()[n].living_ml, *answers[n].living_ml);
      const QString tip = child<QTableWidget>("plans")->item(static_cast<int>(n), 0)->toolTip();
      QCOMPARE(tip.contains("No worse in anything"), !better[n].empty());
    }
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(plot);
    QTest::qWait(400);
    auto* canvas = plot->findChild<QWidget*>();
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->mapFrom(plot, plot->drawn_at(1)).toPoint());
    QTRY_VERIFY_WITH_TIMEOUT(taken().size() == 1 && taken() == live().kept()[1].kept.plan.cuts, patience_ms);
    QCOMPARE(child<QLineEdit>("plan_name")->text(), QString("Around"));
    keep_pictures("plan_plot", "plans");
  }

  // Under a name of its own, to be changed; a step of undo.
  void copies_a_plan() {
    press("copy_plan");
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{4}, patience_ms);
    QCOMPARE(QString::fromStdString(live().kept().back().kept.plan.name), QString("Around (2)"));
    QVERIFY(live().kept().back().kept.plan.cuts == live().kept()[1].kept.plan.cuts);
    QCOMPARE(child<QLineEdit>("plan_name")->text(), QString("Around (2)"));
    undo(Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), std::size_t{3}, patience_ms);
  }

  // Of the earlier study a copy in which V stands with VIII, and is new since.
  void tells_what_grew_since_an_earlier_study() {
    const std::filesystem::path earlier = folder_.parent_path() / "earlier.glisson";
    // The step back before this, and the cut taken away, may still be on their way into the case's history.
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy() && !window_->work().busy(), patience_ms);
    std::filesystem::copy(folder_, earlier, std::filesystem::copy_options::recursive);
    auto before = casefile::Case::open(earlier);
    QVERIFY(before.has_value());
    auto segments = imaging::read_labels_file(before->file_of(casefile::couinaud_id).value()).value();
    for (std::uint16_t& segment : segments.values) segment = segment == 5 ? std::uint16_t{8} : segment;
    const casefile::Provenance made = before->find(casefile::couinaud_id)->made;
    QVERIFY(before->add(casefile::couinaud_id, ".nrrd", made, [&](const std::filesystem::path& file) {
      return imaging::write_segments_file(file, segments, casefile::couinaud_segment_infos());
    }));

    press("growing");
    auto* growth = panel_->findChild<GrowthControls*>();
    QVERIFY(child<QPushButton>("earlier_study")->isVisible() && !child<QTableWidget>("growth_table")->isVisible());
    growth->compare_with(earlier);
    QTRY_VERIFY_WITH_TIMEOUT(growth->result() != nullptr, patience_ms);
    const auto* table = child<QTableWidget>("growth_table");
    QVERIFY(table->isVisible() && !table->isColumnHidden(GrowthControls::stiffness_column));
    QCOMPARE(table->rowCount(), 9);
    const auto shown = [&](int row, int column) { return table->item(row, column)->text(); };
    const auto tissue = live().anatomy()->planner.segments();
    QCOMPARE(shown(4, GrowthControls::before_column), QString("0"));
    QCOMPARE(shown(4, GrowthControls::now_column), QString::number(tissue[5].ml, 'f', 0));
    QCOMPARE(shown(4, GrowthControls::change_column), QString("–"));
    QCOMPARE(shown(7, GrowthControls::before_column), QString::number(tissue[5].ml + tissue[8].ml, 'f', 0));
    QVERIFY(shown(7, GrowthControls::change_column).contains("-"));
    QCOMPARE(shown(8, GrowthControls::change_column), QString("+0 %"));
    const auto told = [&] { return child<QLabel>("growth_told")->text(); };
    QVERIFY2(told().contains("How many days"), qPrintable(told()));
    // With a plan and the days that were typed.
    auto* plan = child<QComboBox>("growth_plan");
    plan->setCurrentIndex(1);
    child<QDoubleSpinBox>("growth_days")->setValue(21);
    QTRY_VERIFY_WITH_TIMEOUT(growth->result() && growth->result()->growth.remnant, patience_ms);
    QCOMPARE(table->rowCount(), 10);
    QVERIFY2(told().contains("a degree of hypertrophy of +0.0") && told().contains("21 days"), qPrintable(told()));
    keep_pictures("growth_told", "growth");
    // What may not be compared is said in its place.
    growth->compare_with(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(told().contains("itself"), patience_ms);
    QVERIFY(!table->isVisible() && !child<QPushButton>("one_patient")->isVisible());
    press("growing");
  }

  // File, Export lists the plans; the file holds the outlines, the segments, and what stays and goes.
  void writes_remnant_and_specimen() {
    auto* listed = window_->findChild<QMenu*>("export_plan");
    Q_EMIT listed->aboutToShow();
    QCOMPARE(listed->actions().size(), 3);
    QCOMPARE(listed->actions().front()->text(), QString("Territory"));
    const std::filesystem::path file = folder_.parent_path() / "plan.dcm";
    window_->findChild<ExportMenu*>()->write(casefile::ExportFormat::dicom_seg, file, {{}, "Around"});
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(file) && !window_->work().busy(), patience_ms);
    const auto read = imaging::read_dicom_seg(file);
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    QStringList segments;
    for (const auto& segment : *read) segments << QString::fromStdString(segment.info.name);
    for (const char* wanted : {"liver", "tumour-1", "remnant", "specimen"}) {
      QVERIFY2(segments.contains(wanted), qPrintable(segments.join(", ")));
    }
  }

  void shuts_down_cleanly() {
    patient_ = {};
    window_.reset();
  }

 private:
  [[nodiscard]] const LivePlan& live() const { return panel_->by_anatomy().live(); }
  [[nodiscard]] const std::vector<planning::Cut>& taken() const { return panel_->by_anatomy().taken(); }
  [[nodiscard]] ResectogramView& view() { return *child<ResectogramView>("resectogram"); }
  // What came of so many cuts, once it has.
  [[nodiscard]] const planning::PlanAnswer* answer_of(std::size_t cuts) const {
    return live().result() && live().result()->cuts.size() == cuts ? &live().result()->answer : nullptr;
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*panel_, name);
  }
  void press(const char* name) {
    auto* button = child<QAbstractButton>(name);
    // Where a fold has just opened, once it is laid out.
    QTRY_VERIFY(button->isVisible() && button->height() >= button->minimumSizeHint().height());
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton, {}, {8, button->height() / 2});
  }
  void keep(const char* name) {
    const std::size_t before = live().kept().size();
    child<QLineEdit>("plan_name")->setText(name);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("keep_plan")->isEnabled(), patience_ms);
    press("keep_plan");
    QTRY_COMPARE_WITH_TIMEOUT(live().kept().size(), before + 1, patience_ms);
  }
  void undo(Qt::KeyboardModifiers keys) {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    press_key(*window_, Qt::Key_Z, keys);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
  }
  QStringList names() {
    QStringList all;
    const auto* plans = child<QTableWidget>("plans");
    for (int row = 0; row < plans->rowCount(); ++row) all << plans->item(row, PlanList::name_column)->text();
    return all;
  }
  static std::pair<int, int> place_of(const planning::Resectogram& map, double margin_mm) {
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) {
        if (map.at(column, row) == margin_mm) return {column, row};
      }
    }
    return {-1, -1};
  }
  // With that child in sight: in English, and in German on a small screen too.
  void keep_pictures(const char* in_sight, const char* name) {
    const QSize before = window_->size();
    for (const char* language : {"en", "de"}) {
      for (const QSize& size : {before, QSize(1280, 720)}) {
        choose_language(language);
        window_->resize(size);
        QTest::qWait(300);
        panel_->findChild<QScrollArea*>()->ensureWidgetVisible(child<QWidget>(in_sight), 0, 200);
        QTest::qWait(600);
        const QString file = QString("plans-%1-%2-%3.png").arg(name, language).arg(size.width());
        QVERIFY(window_->grab().save(glisson::test::kept_picture(qPrintable(file))));
      }
    }
    choose_language("en");
    window_->resize(before);
    QTest::qWait(300);
  }

  QTemporaryDir parent_;
  std::filesystem::path folder_;
  Patient patient_;
  geometry::Box tumour_;
  std::unique_ptr<MainWindow> window_;
  ResectPanel* panel_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) {
  return glisson::widgets::run_test<glisson::widgets::PlansSideBySideTest>(argc, argv);
}

#include "plans_side_by_side_test.moc"
