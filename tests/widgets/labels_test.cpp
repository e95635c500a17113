// Images with the label maps of other programs, as a person takes them in by the window: Glisson's own proposal, a map
// that is dropped, one that says nothing and is asked about; what is of somebody else is not taken without a word. Then
// the case goes out by File, Export, and is closed.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QtTest>

#include "base/files.h"
#include "casefile/case.h"
#include "imaging/volume_file.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "segmentation/structures.h"
#include "shown.h"
#include "support/data.h"
#include "widgets/main_window.h"
#include "widgets/panels/export_menu.h"
#include "widgets/study/study_page.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 120000;

class LabelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!fs::exists(data())) QSKIP("no real data: set GLISSON_SHARED_DATA to the folder that holds it");
    fs::create_directories(study());
    for (const char* name : {"example_ct_sm.nii.gz", "example_seg.nii.gz"}) fs::copy(data() / name, study() / name);
    window_ = shown_window();
  }

  void makes_a_case_of_a_ct_and_its_labels_by_its_own_proposal() {
    open(study());
    auto* series = window_->findChild<QTreeWidget*>("series");
    QCOMPARE(series->topLevelItemCount(), 2);
    QCOMPARE(role(0)->currentText(), QString("Anatomy"));
    QCOMPARE(role(1)->currentText(), QString("Segmentation"));
    // The label map's thumbnail is in colours.
    QTRY_VERIFY_WITH_TIMEOUT(coloured(series->topLevelItem(1)->icon(0).pixmap(92, 92).toImage()) > 200, patience_ms);
    QVERIFY(window_->grab().save(glisson::test::kept_pictures() + "/labels_study.png"));
    keep_as(patient());
    QTest::mouseClick(child_of<QPushButton>(*window_, "make_case"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(fs::exists(patient() / "labels" / "liver.nrrd") && !window_->work().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QTreeWidget*>("structures")->topLevelItemCount() > 5, patience_ms);
    const auto liver = imaging::read_mask_file(patient() / "labels" / "liver.nrrd");
    QCOMPARE(segmentation::voxel_count(liver->mask), std::size_t(38634));  // counted in the file by other means
    const QString said = window_->findChild<QLabel*>("notice_text")->text();
    QVERIFY2(said.contains("table") && said.contains("Left out"), qPrintable(said));
  }

  void a_label_map_that_is_dropped_goes_into_the_open_case() {
    window_->open_path(data() / "example_seg_fast" / "liver.nii.gz");
    QTRY_COMPARE_WITH_TIMEOUT(voxels("liver"), std::size_t(39350), patience_ms);
    settle();
    window_->undo().undo_action()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(voxels("liver"), std::size_t(38634), patience_ms);
    settle();
  }

  void what_says_nothing_is_asked_about() {
    imaging::LabelMap map = imaging::read_labels_file(data() / "example_seg_fast" / "liver.nii.gz").value();
    for (std::uint16_t& value : map.values) value = value == 1 ? 3 : 0;
    const fs::path strange = folder_.path() / "drawn_by_somebody.nrrd";
    QVERIFY(
        bool(imaging::write_mask_file(strange, {map.grid, {map.values.begin(), map.values.end()}}, {"Segment_3", 3})));
    QTimer::singleShot(0, this, [this] { answer_names(); });
    window_->findChild<StudyPage*>()->add_labels(strange);
    QTRY_COMPARE_WITH_TIMEOUT(voxels("tumour"), std::size_t(39350), patience_ms);
    QVERIFY(names_asked_);
    settle();
  }

  void another_patients_ct_is_not_taken_without_a_word() {
    const std::string before = read_text_file(patient() / "case.json").value();
    open(data() / "example_ct_dicom");
    const auto press_add = [this](const char* answer) {
      asked_.clear();
      answer_question(answer);
      QTest::mouseClick(child_of<QPushButton>(*window_, "add_to_case"), Qt::LeftButton);
      QTRY_VERIFY_WITH_TIMEOUT(!asked_.isEmpty(), patience_ms);
      settle();
    };
    press_add(nullptr);
    QVERIFY2(asked_.contains("replace it") && asked_.contains("elsewhere"), qPrintable(asked_));
    QCOMPARE(read_text_file(patient() / "case.json").value(), before);
    press_add("belonging_go");
    QTRY_VERIFY_WITH_TIMEOUT(read_text_file(patient() / "case.json").value() != before, patience_ms);
    settle();
    QCOMPARE(casefile::Case::open(patient())->volume("volumes/anatomy")->grid.size[2], 20);
    QVERIFY(casefile::Case::open(patient())->freshness("labels/liver") == casefile::Freshness::stale);
    window_->undo().undo_action()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(casefile::Case::open(patient())->volume("volumes/anatomy")->grid.size[2], 30,
                              patience_ms);
    settle();
  }

  void goes_out_by_the_menu() {
    auto* menu = window_->findChild<ExportMenu*>();
    QVERIFY(menu->isEnabled());
    QVERIFY(window_->findChild<QAction*>("export_stl") != nullptr);
    menu->write(casefile::ExportFormat::dicom_seg, folder_.path() / "out.dcm");
    QTRY_VERIFY_WITH_TIMEOUT(fs::exists(folder_.path() / "out.dcm") && !window_->work().busy(), patience_ms);
    menu->write(casefile::ExportFormat::nifti, folder_.path() / "nifti");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    const auto back = imaging::read_labels_file(folder_.path() / "nifti" / "liver.nii.gz");
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QCOMPARE(std::count_if(back->values.begin(), back->values.end(), [](auto v) { return v != 0; }), 38634);
  }

  void the_case_is_closed_and_the_window_stays() {
    auto* close = child_of<QAction>(*window_, "close_case");
    QVERIFY(close->isEnabled());
    close->trigger();
    QCOMPARE(window_->windowTitle(), QString("Glisson"));
    QVERIFY(!close->isEnabled());
    QCOMPARE(window_->findChild<QTreeWidget*>("structures")->topLevelItemCount(), 0);
    for (const char* workspace : {"study", "segment", "model", "rehearse", "resect", "evidence", "studies", "report"}) {
      window_->go_to(workspace);
      QTest::qWait(50);
    }
    window_->open_path(patient());
    QTRY_VERIFY_WITH_TIMEOUT(close->isEnabled(), patience_ms);
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  static fs::path data() { return glisson::test::shared_data() / "totalseg_abdomen_mr_ct"; }
  [[nodiscard]] fs::path study() const { return folder_.path() / "study"; }
  [[nodiscard]] fs::path patient() const { return folder_.path() / "hers.glisson"; }
  QComboBox* role(int k) { return child_of<QComboBox>(*window_, qPrintable(QString("role_%1").arg(k))); }
  void settle() { QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms); }
  std::size_t voxels(const std::string& structure) {
    const auto mask = imaging::read_mask_file(patient() / "labels" / (structure + ".nrrd"));
    return mask ? segmentation::voxel_count(mask->mask) : 0;
  }

  void open(const fs::path& path) {
    QSignalSpy listed(window_->findChild<StudyPage*>(), &StudyPage::listed);
    window_->open_path(path);
    QVERIFY(listed.wait(patience_ms));
  }

  void keep_as(const fs::path& folder) {
    auto* line = child_of<QLineEdit>(*window_, "keep_as");
    line->selectAll();
    QTest::keyClicks(line, QString::fromStdString(folder.string()));
  }

  static int coloured(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += QColor(picture.pixel(x, y)).saturation() > 60 ? 1 : 0;
    }
    return count;
  }

  // As soon as it appears: the tumour for value 3.
  void answer_names() {
    auto* dialog = QApplication::activeModalWidget();
    auto* choice = dialog != nullptr ? dialog->findChild<QComboBox*>("label_3") : nullptr;
    if (choice == nullptr) {
      QTimer::singleShot(100, this, [this] { answer_names(); });
      return;
    }
    names_asked_ = true;
    auto* take = dialog->findChild<QPushButton*>("take_labels");
    QVERIFY(!take->isEnabled());
    choice->setCurrentText("Tumour");
    QVERIFY(dialog->grab().save(glisson::test::kept_pictures() + "/labels_dialog.png"));
    QTest::mouseClick(take, Qt::LeftButton);
  }

  void answer_question(const char* answer) {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) {
      QTimer::singleShot(100, this, [this, answer] { answer_question(answer); });
      return;
    }
    asked_ = question->text();
    auto* go = answer == nullptr ? nullptr : question->findChild<QPushButton*>(answer);
    go != nullptr ? QTest::mouseClick(go, Qt::LeftButton) : QTest::keyClick(question, Qt::Key_Escape);
  }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
  QString asked_;
  bool names_asked_ = false;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::LabelsTest>(argc, argv); }

#include "labels_test.moc"
