// From a folder of DICOM that is dropped on the window to a liver that moves, as a person does it: the dialogs are
// answered, the two next steps are taken.
//
// The study is simulated: two series of an ellipsoid of 290 ml in a body, one of them dark.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QTreeWidget>
#include <QtTest>
#include <random>

#include "base/files.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "imaging/internal/dicom_text.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/study/study_page.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 120000;  // for the longest step on a machine that does other work too
const Eigen::Vector3d liver_mm(-20, 5, 0);

imaging::Volume ellipsoid_in_a_body(double brightness) {
  imaging::Volume volume;
  volume.grid.size = {44, 40, 30};
  volume.grid.spacing_mm = {4, 4, 5};
  volume.grid.origin_mm = {-106, -73, -72};
  volume.values.resize(volume.grid.voxels());
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 4);
  for (int k = 0; k < 30; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 44; ++i) {
        const Eigen::Vector3d away =
            (volume.grid.position_mm(i, j, k) - liver_mm).cwiseQuotient(Eigen::Vector3d(48, 40, 36));
        volume.at(i, j, k) = static_cast<float>(away.norm() < 1 ? brightness : 0.4 * brightness) + noise(random);
      }
    }
  }
  return volume;
}

void write_series(const fs::path& folder, const std::string& name, int number, const imaging::Volume& volume) {
  imaging::SeriesDescription description;
  description.patient_name = "NOBODY^SIMULATED";
  description.study_uid = imaging::uid_from_name("dropped study");
  description.series_uid = imaging::uid_from_name(name);
  description.frame_of_reference_uid = imaging::uid_from_name("dropped frame");
  description.series_description = name;
  description.series_number = number;
  const auto written = imaging::write_dicom_series(folder / name, volume, description);
  if (!written) qFatal("%s", written.error().message().c_str());
}

class StudyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    write_series(study(), "T1 dark", 1, ellipsoid_in_a_body(40));
    write_series(study(), "T1 bright", 2, ellipsoid_in_a_body(150));
    window_ = shown_window();
  }

  void offers_no_case_where_there_are_no_images() {
    window_->go_to("study");
    QVERIFY(!make()->isVisible());
  }

  void takes_only_one_folder_or_file_that_is_dropped() {
    QVERIFY(drag({QUrl::fromLocalFile(QString::fromStdString(study().string()))}));
    QVERIFY(!drag({QUrl("https://example.org/study")}));
    QVERIFY(!drag({QUrl::fromLocalFile("/a"), QUrl::fromLocalFile("/b")}));
  }

  void lists_what_was_dropped_with_pictures_and_proposes_roles() {
    auto* page = window_->findChild<StudyPage*>();
    QSignalSpy listed(page, &StudyPage::listed);
    drop_study();
    QVERIFY(listed.wait(patience_ms));
    QCOMPARE(window_->workspace(), "study");
    auto* series = window_->findChild<SeriesTable*>("series");
    QCOMPARE(series->topLevelItemCount(), 2);
    QCOMPARE(series->chosen(), 1);  // two could be the anatomy: one is proposed
    bright_ = series->topLevelItem(0)->text(0).contains("bright") ? 0 : 1;
    QVERIFY(series->topLevelItem(bright_)->text(1).contains("44"));
    // The middle of the ellipsoid is bright in the picture that comes.
    QTRY_VERIFY_WITH_TIMEOUT(qGray(series->topLevelItem(bright_)->icon(0).pixmap(92, 92).toImage().pixel(40, 46)) > 120,
                             patience_ms);
    QVERIFY(!fs::exists(case_folder()));
  }

  // Thumbnails that are wider than tall came in, and no row changed its height.
  void use_as_stays_in_its_row_when_pictures_come() {
    auto* series = window_->findChild<QTreeWidget*>("series");
    for (const int k : {0, 1}) {
      const QRect row = series->visualItemRect(series->topLevelItem(k));
      const QPoint middle = choice(k)->mapTo(series->viewport(), choice(k)->rect().center());
      QVERIFY2(std::abs(middle.y() - row.center().y()) <= 2,
               qPrintable(QString("%1 in %2 to %3").arg(middle.y()).arg(row.top()).arg(row.bottom())));
      QCOMPARE(row.height(), series->visualItemRect(series->topLevelItem(0)).height());
      QVERIFY(row.height() >= 92);
    }
  }

  void says_why_nothing_can_be_made_of_it_yet() {
    for (const int k : {0, 1}) choice(k)->setCurrentIndex(choice(k)->count() - 1);
    QVERIFY(!make()->isEnabled());
    QVERIFY(make()->toolTip().contains("role"));
    QVERIFY(!is_bright(*make()));
  }

  void imports_the_series_that_the_person_chooses() {
    choice(bright_)->setFocus();
    QTest::keyClick(choice(bright_), Qt::Key_Home);  // the anatomy
    auto* keep_as = window_->findChild<QLineEdit*>("keep_as");
    keep_as->selectAll();
    QTest::keyClicks(keep_as, QString::fromStdString(case_folder().string()));
    QVERIFY(make()->isEnabled());
    QVERIFY(is_bright(*make()));
    QTest::mouseClick(make(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace() == "segment" && next_step()->isVisible(), patience_ms);
    QVERIFY(fs::exists(case_folder() / "case.json"));
    const imaging::Volume bright = ellipsoid_in_a_body(150);
    const SliceView& slice = window_->views().slice(SliceDirection::transverse);
    QVERIFY((slice.crosshair_mm() - bright.grid.position_mm(22, 20, 15)).norm() < 30);
    QVERIFY(next_step()->text().contains("Outline"));
    window_->go_to("rehearse");
  }

  void outlines_the_liver_from_the_crosshair() {
    window_->views().set_crosshair(liver_mm);
    QTest::mouseClick(next_step(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(next_step()->text().contains("Build"), patience_ms);
    // The ellipsoid's volume is 289.5 ml.
    auto* structures = window_->findChild<QTreeWidget*>("structures");
    QCOMPARE(structures->topLevelItemCount(), 1);
    const double volume_ml = QLocale().toDouble(structures->topLevelItem(0)->text(1));
    QVERIFY(window_->findChild<QLabel*>("notice_text")->isVisible());  // adults' livers are larger
    QVERIFY2(std::abs(volume_ml - 289.5) < 15, qPrintable(QString::number(volume_ml)));
  }

  void builds_the_model_and_rehearses() {
    QTest::mouseClick(next_step(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!next_step()->isVisible() && !window_->work().busy(), patience_ms);
    auto* hoist = window_->findChild<QPushButton*>("hoist");
    QTRY_VERIFY_WITH_TIMEOUT(hoist->isEnabled(), patience_ms);
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    QTest::mouseClick(hoist, Qt::LeftButton);
    QVERIFY(placed.wait(patience_ms));
    QVERIFY(window_->rehearsal().state()->patient.max_displacement_mm > 0.5);
  }

  void opens_the_kept_case_again() {
    window_ = std::make_unique<MainWindow>();
    window_->show();
    window_->open_path(case_folder() / "case.json");
    auto* name = window_->findChild<StudyPanel*>()->findChild<QLabel*>("patient_name");
    QTRY_VERIFY_WITH_TIMEOUT(name->text().contains("dropped"), patience_ms);
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  QComboBox* choice(int series) { return window_->findChild<QComboBox*>(QString("role_%1").arg(series)); }
  QPushButton* make() { return window_->findChild<StudyPage*>()->findChild<QPushButton*>("make_case"); }
  [[nodiscard]] fs::path study() const { return folder_.path() / "study"; }
  [[nodiscard]] fs::path case_folder() const { return folder_.path() / "dropped.glisson"; }
  QPushButton* next_step() { return window_->findChild<QWidget*>("next_step")->findChild<QPushButton*>(); }

  static bool is_bright(QWidget& button) {
    return button.grab().toImage().pixelColor(6, button.height() / 2).saturation() > 120;
  }

  bool drag(const QList<QUrl>& urls) {
    QMimeData dragged;
    dragged.setUrls(urls);
    QDragEnterEvent enters(QPoint(200, 200), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    enters.ignore();
    QCoreApplication::sendEvent(window_.get(), &enters);
    return enters.isAccepted();
  }

  void drop_study() {
    const QList<QUrl> urls{QUrl::fromLocalFile(QString::fromStdString(study().string()))};
    drag(urls);  // Qt gives a drop only to what has accepted it
    QMimeData dragged;
    dragged.setUrls(urls);
    QDropEvent drops(QPointF(200, 200), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &drops);
  }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
  int bright_ = 0;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::StudyTest>(argc, argv); }

#include "study_test.moc"
