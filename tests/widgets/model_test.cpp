// Model, as a person uses it: its facts, another stiffness by one click, a model that went stale and is brought up to
// date, and what the 3D view shows of it.

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

#include "base/write_file.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/model/model_panel.h"
#include "widgets/panels/study_panel.h"
#include "widgets/rehearse/comparison_choice.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 60000;

class ModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window({1400, 950});
    panel_ = window_->findChild<ModelPanel*>();
    window_->go_to("model");
    folder_ = test::modelled_case(fs::path(temporary_.path().toStdString()));
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() != nullptr, patience_ms);
  }

  void tells_what_the_model_is() {
    QVERIFY(panel_->state().current);
    QVERIFY(child<QLabel>("model_state")->text().contains("up to date"));
    QVERIFY(!primary()->isVisible());
    QVERIFY(child<QLabel>("model_cells")->text().startsWith(QString::number(panel_->facts()->cells)));
    QVERIFY(std::abs(panel_->facts()->mesh_ml / panel_->facts()->label_ml - 1) < 0.1);
    QVERIFY(child<QLabel>("model_stiffness")->text().contains("Assumed: 6.0 kPa for all cells"));
    QCOMPARE(panel_->facts()->min_dihedral_deg.size(), panel_->facts()->cells);
  }

  // Two guesses are not compared: there is nothing of the patient in either.
  void an_assumed_stiffness_is_called_so_everywhere_and_not_compared() {
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr, patience_ms);
    QVERIFY(!window_->rehearsal().body()->has_reference());
    window_->go_to("rehearse");
    const auto* said = child_of<QLabel>(*window_, "assumed_stiffness");
    QVERIFY(said->isVisible());
    QVERIFY(said->text().contains("The stiffness is assumed, 6 kPa for all cells, and not measured"));
    for (const QPushButton* button : window_->findChild<ComparisonChoice*>()->findChildren<QPushButton*>()) {
      QCOMPARE(button->isEnabled(), button->text() == "Patient");
      if (!button->isEnabled()) QVERIFY(button->toolTip().contains("No stiffness was measured"));
    }
    bool facts_say_so = false;
    for (const QLabel* label : window_->findChild<StudyPanel*>()->findChildren<QLabel*>()) {
      facts_say_so |= label->text().contains("6.0 kPa (assumed)");
    }
    QVERIFY(facts_say_so);
    window_->go_to("model");
  }

  // One number for the liver: the outline's, wherever its volume stands.
  void the_livers_volume_is_that_of_its_outline() {
    const double outline_ml = panel_->facts()->label_ml;
    QVERIFY(child<QLabel>("model_volume")->text().startsWith(QString::number(outline_ml, 'f', 0) + " ml outlined"));
    const auto* structures = child_of<QTreeWidget>(*window_->findChild<StudyPanel*>(), "structures");
    const double listed_ml = structures->topLevelItem(0)->text(1).toDouble();
    QVERIFY2(std::abs(listed_ml - outline_ml) < 0.06, qPrintable(QString("%1 %2").arg(listed_ml).arg(outline_ml)));
  }

  void a_source_that_the_case_lacks_says_so() {
    choose_source(0);  // MR elastography
    QVERIFY(!child<QPushButton>("model_give")->isEnabled());
    QVERIFY(child<QPushButton>("model_give")->toolTip().contains("no stiffness map"));
    QVERIFY(!child<QPushButton>("model_waves")->isEnabled());
  }

  void gives_another_stiffness_by_one_click_and_keeps_the_cells() {
    const std::size_t cells = panel_->facts()->cells;
    choose_source(1);  // the atlas, 2.1 kPa in shear: 2 (1 + 0.45) times that
    QTest::mouseClick(child<QPushButton>("model_give"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() && std::abs(panel_->facts()->mean_kPa - 6.09) < 0.01, patience_ms);
    QCOMPARE(panel_->facts()->cells, cells);
    QCOMPARE(child<QComboBox>("model_source")->currentIndex(), 1);
  }

  void builds_finer_cells() {
    const std::size_t cells = panel_->facts()->cells;
    auto* target = child<QDoubleSpinBox>("model_target");
    target->setFocus();
    target->selectAll();
    QTest::keyClicks(target, "2400");
    QTest::keyClick(target, Qt::Key_Return);
    QTest::mouseClick(child<QPushButton>("model_build"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() && panel_->facts()->cells > 2 * cells, patience_ms);
    QCOMPARE(panel_->facts()->target_cells, 2400);
    QVERIFY(std::abs(panel_->facts()->mean_kPa - 6.09) < 0.01);  // still the atlas's
  }

  void a_stale_model_says_what_changed_and_is_mended_by_one_click() {
    QVERIFY(bool(test::save_ball(folder_, "liver", 14)));
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() && panel_->state().built && !panel_->state().current, patience_ms);
    QVERIFY(child<QLabel>("model_state")->text().contains("Liver changed"));
    const double before_ml = panel_->facts()->mesh_ml;
    QVERIFY(primary()->isVisible());
    QTest::mouseClick(primary(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() && panel_->state().current, patience_ms);
    QVERIFY(panel_->facts()->mesh_ml > 1.3 * before_ml);  // (14 / 12)^3 = 1.59
    QVERIFY(!primary()->isVisible());
  }

  // A table of a tissue half as stiff as the model: chapter 5's retraction goes farther by it.
  void retracts_the_liver_straight_from_measurements() {
    const fs::path table = fs::path(temporary_.path().toStdString()) / "soft.csv";
    std::string text = "strain,stress_kPa\n";
    for (int i = -20; i <= 20; ++i) text += std::to_string(0.01 * i) + "," + std::to_string(0.03 * i) + "\n";
    QVERIFY(bool(write_text_file(table, text)));
    const auto* told = child<QLabel>("measured_told");
    QVERIFY(!told->isVisible());
    auto* force = child<QDoubleSpinBox>("measured_force");
    force->setFocus();
    force->selectAll();
    QTest::keyClicks(force, "0.1");
    QTest::keyClick(force, Qt::Key_Return);
    QTest::qWait(100);
    const QImage before = window_->views().space().picture();
    panel_->findChild<FromMeasurements*>()->retract_by(table);
    QTRY_VERIFY_WITH_TIMEOUT(told->isVisible(), patience_ms);
    QVERIFY2(told->text().contains("soft.csv: 41 measurements, 0.1 N"), qPrintable(told->text()));
    QVERIFY2(told->text().contains("Lifted by up to"), qPrintable(told->text()));
    auto* see = child<QPushButton>("see_measured");
    QVERIFY(see->isChecked());
    QTest::qWait(100);
    const QImage retracted = window_->views().space().picture();
    QVERIFY(retracted != before);
    panel_->findChild<QScrollArea*>()->ensureWidgetVisible(see);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("model_measurements.png")));
    QTest::mouseClick(see, Qt::LeftButton);
    QTest::qWait(100);
    QVERIFY(window_->views().space().picture() != retracted);
  }

  void a_table_that_is_none_says_so_and_leaves_the_answer() {
    const fs::path table = fs::path(temporary_.path().toStdString()) / "words.csv";
    QVERIFY(bool(write_text_file(table, "strain,stress_kPa\n0.1,soft\n")));
    const QString before = child<QLabel>("measured_told")->text();
    panel_->findChild<FromMeasurements*>()->retract_by(table);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QLabel*>("notice_text")->text().contains("In line 2 no number stands"),
                             patience_ms);
    QCOMPARE(child<QLabel>("measured_told")->text(), before);
  }

  void shows_stiffness_and_supports_in_space() {
    SpaceView& space = window_->views().space();
    QTest::qWait(100);
    const QImage stiffness = space.picture();
    QVERIFY(window_->grab().save(glisson::test::kept_picture("model_stiffness.png")));
    QTest::mouseClick(child<QPushButton>("show_supports"), Qt::LeftButton);
    QTest::qWait(100);
    const QImage supports = space.picture();
    QVERIFY(supports != stiffness);
    QVERIFY(!panel_->facts()->held.triangles.empty());
    QVERIFY(!panel_->facts()->on_springs.triangles.empty());
    QVERIFY(window_->grab().save(glisson::test::kept_picture("model_supports.png")));
    QTest::mouseClick(child<QPushButton>("show_patient"), Qt::LeftButton);
    QTest::qWait(100);
    QVERIFY(space.picture() != supports);
  }

  void a_case_without_a_model_builds_one() {
    const QTemporaryDir other;
    const fs::path bare = test::small_case(fs::path(other.path().toStdString()));
    window_->open_path(bare);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("model_state")->text().contains("no model yet"), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("model_build")->isEnabled(), patience_ms);
    auto* target = child<QDoubleSpinBox>("model_target");
    target->setValue(800);
    QTest::mouseClick(child<QPushButton>("model_build"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(panel_->facts() && panel_->state().current, patience_ms);
    QVERIFY(window_->rehearsal().body() != nullptr);
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*panel_, name);
  }
  QPushButton* primary() { return child<QPushButton>("primary"); }
  void choose_source(int index) {
    auto* source = child<QComboBox>("model_source");
    source->setFocus();
    while (source->currentIndex() > index) QTest::keyClick(source, Qt::Key_Up);
    while (source->currentIndex() < index) QTest::keyClick(source, Qt::Key_Down);
  }

  std::unique_ptr<MainWindow> window_;
  ModelPanel* panel_ = nullptr;
  QTemporaryDir temporary_;
  fs::path folder_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ModelTest>(argc, argv); }

#include "model_test.moc"
