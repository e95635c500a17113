// The Studies workspace, driven by mouse and keys: a study is started, watched, stopped, taken up again and its page
// opened; a folder that another process fills is followed.

#include <algorithm>
#include <fstream>
#include <QDesktopServices>
#include <QProcess>
#include <QtTest>

#include "base/files.h"
#include "kept_pictures.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/studies/studies_page.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

class StudiesTest : public QObject {
  Q_OBJECT

 public:
  Q_INVOKABLE void keep_url(const QUrl& url) { opened_ = url; }

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    page_.reset(StudiesPage::workspace().widget);
    page_->resize(1400, 900);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
  }
  void cleanup() { page_.reset(); }

  void a_study_is_run_and_its_page_opened() {
    const fs::path out = folder_->path() / "cohort";
    begin("cohort", 3, out);
    QVERIFY(child<QPushButton>("stop_study")->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(rows()->rowCount(), 3, 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(!studies().run().running(), 60'000);
    QCOMPARE(child<QLabel>("study_stage")->text(), QString("Done."));
    // What the window shows is what the study wrote.
    std::ifstream csv(out / "cohort.csv");
    std::string header, first;
    std::getline(csv, header);
    std::getline(csv, first);
    const QString patient = QString::fromStdString(first).section(',', 0, 0);
    const double mean_kPa = QString::fromStdString(first).section(',', 2, 2).toDouble();
    const int column = column_of("mean_kPa");
    QVERIFY(column > 0 && header.find("mean_kPa") != std::string::npos);
    bool found = false;
    for (int row = 0; row < 3; ++row) {
      if (rows()->item(row, column_of("patient"))->text() != patient) continue;
      found = std::abs(rows()->item(row, column)->text().toDouble() / mean_kPa - 1) < 1e-3;
    }
    QVERIFY(found && mean_kPa > 0);
    QDesktopServices::setUrlHandler("file", this, "keep_url");
    QTest::mouseClick(child<QPushButton>("open_study_page"), Qt::LeftButton);
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(path_of(opened_.toLocalFile()), out / "report.html");
    page_->grab().save(glisson::test::kept_picture("studies.png"));
  }

  void what_was_stopped_goes_on() {
    const fs::path out = folder_->path() / "landmarks";
    begin("landmarks", 12, out);
    QTRY_VERIFY_WITH_TIMEOUT(rows()->done() >= 1, 120'000);
    QTest::mouseClick(child<QPushButton>("stop_study"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!studies().run().running(), 150'000);
    QCOMPARE(child<QLabel>("study_stage")->text(), QString("Stopped. Started again, it goes on from there."));
    const int done = rows()->done();
    QVERIFY(done >= 1 && done < 12);
    const fs::path first = out / "patients" / (rows()->item(0, 0)->text().toStdString() + ".json");
    const auto written = fs::last_write_time(first);
    QTest::mouseClick(child<QPushButton>("primary"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(rows()->done() > done, 120'000);
    QCOMPARE(fs::last_write_time(first), written);  // not computed again
    page_.reset();                                  // closing the window stops it too
  }

  void a_folder_that_others_fill_is_followed() {
    const fs::path out = folder_->path() / "shared";
    fs::create_directories(out);
    studies().follow(out);
    QCOMPARE(rows()->rowCount(), 0);
    for (const char* patient : {"simulated-001-stiffness", "simulated-002-stiffness"}) {
      QProcess job;  // one of a cluster's
      job.start(QCoreApplication::applicationDirPath() + "/glisson-cli",
                {"study", "cohort", "--simulated", "2", "--patient", patient, "--out", text_of(out), "--quiet"});
      QVERIFY(job.waitForFinished(60'000));
      QCOMPARE(job.exitCode(), 0);
    }
    QTRY_COMPARE_WITH_TIMEOUT(rows()->rowCount(), 2, 5'000);
    // One that is half written, or no row at all, is left out and harms nothing.
    std::ofstream(out / "patients/half.json") << "{\"patient\": \"half\", \"val";
    std::ofstream(out / "patients/other.json") << "[1, 2]";
    QTest::qWait(1500);
    QCOMPARE(rows()->rowCount(), 2);
  }

  void what_cannot_be_done_is_said() {
    const fs::path file = folder_->path() / "file";
    std::ofstream(file) << "no folder";
    begin("cohort", 3, file / "within");
    QTRY_VERIFY_WITH_TIMEOUT(!studies().run().running(), 60'000);
    const QString told = child<QLabel>("study_stage")->text();
    QVERIFY2(told.contains("file"), qPrintable(told));
    QCOMPARE(rows()->rowCount(), 0);
  }

  void a_study_of_one_liver_takes_the_open_case() {
    choose("beams");
    QVERIFY(!child<QPushButton>("primary")->isEnabled());
    studies().show_case(folder_->path() / "hers.glisson");
    QVERIFY(child<QPushButton>("primary")->isEnabled());
    QVERIFY(child<QLabel>("study_input")->text().endsWith("hers.glisson"));
    choose("cohort");  // a case is no cohort
    QVERIFY(child<QWidget>("study_simulated")->isVisible());
  }

 private:
  StudiesPage& studies() { return *qobject_cast<StudiesPage*>(page_.get()); }
  StudyRows* rows() { return child<StudyRows>("study_rows"); }
  int column_of(const QString& name) {
    for (int column = 0; column < rows()->columnCount(); ++column) {
      if (rows()->horizontalHeaderItem(column)->text() == name) return column;
    }
    return -1;
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*page_, name);
  }
  // By the keyboard, as the first letters or the arrow keys would.
  void choose(const char* id) {
    const std::map<QString, int> places{{"landmarks", 0}, {"cohort", 1}, {"beams", 2}};
    auto* kinds = child<QComboBox>("study_kind");
    QTest::keyClick(kinds, Qt::Key_Home);
    for (int n = 0; n < places.at(id); ++n) QTest::keyClick(kinds, Qt::Key_Down);
  }
  void begin(const char* id, int patients, const fs::path& out) {
    choose(id);
    QApplication::setActiveWindow(page_.get());
    auto* count = child<NumberBox>("study_simulated");
    count->setFocus();
    count->selectAll();
    QTest::keyClicks(count, QString::number(patients));
    QTest::keyClick(count, Qt::Key_Return);
    QCOMPARE(count->value(), double(patients));
    auto* results = child<QLineEdit>("study_results");
    results->selectAll();
    QTest::keyClicks(results, text_of(out));
    QTest::mouseClick(child<QPushButton>("primary"), Qt::LeftButton);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<QWidget> page_;
  QUrl opened_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::StudiesTest>(argc, argv); }

#include "studies_test.moc"
