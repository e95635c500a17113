// Report, as a person uses it: the page of a case read in the window, with and without the name, saved and printed.

#include <QCheckBox>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QtTest>

#include "base/files.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/report/report_view.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 20000;

class ReportViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window();
    view_ = window_->findChild<ReportView*>();
  }

  void says_that_it_needs_a_case() {
    window_->go_to("report");
    QVERIFY(child<QLabel>("report_state")->text().contains("Open a case"));
    QVERIFY(!child<QPushButton>("report_html")->isEnabled());
  }

  void collects_the_page_of_the_case() {
    const fs::path folder = test::modelled_case(fs::path(temporary_.path().toStdString()));
    window_->go_to("rehearse");
    window_->open_path(folder);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr, patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    window_->go_to("report");
    QTRY_VERIFY2_WITH_TIMEOUT(child<QPushButton>("report_html")->isEnabled(),
                              qPrintable(window_->findChild<QLabel*>("notice_text")->text()), patience_ms);
    const QString page = text();
    QVERIFY(page.contains("6.00 kPa on average"));
    QVERIFY(page.contains("Tumour 1"));
    QVERIFY(page.contains("No resection was saved."));
    QVERIFY(page.contains("nothing is being rehearsed"));
    QVERIFY(page.contains("Not a medical device"));
  }

  void withholds_the_name_until_it_is_asked_for() {
    QVERIFY(text().contains("name withheld"));
    QVERIFY(!text().contains("small"));
    QTest::mouseClick(child<QCheckBox>("report_name"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY_WITH_TIMEOUT(text().startsWith("Not a medical device.\nsmall"), patience_ms);
    QTest::mouseClick(child<QCheckBox>("report_name"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY_WITH_TIMEOUT(!text().contains("small"), patience_ms);
  }

  void tells_what_is_being_rehearsed_when_it_is_looked_at() {
    window_->go_to("rehearse");
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    const auto& surface = window_->rehearsal().body()->surface();
    window_->rehearsal().hold({"palpation-probe", surface.points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 1.5});
    QVERIFY(placed.wait(patience_ms));
    window_->go_to("report");
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("Palpation probe with 1.5 N"), patience_ms);
  }

  // An answer that may not be used leaves no figure on the page, and what can be worn stands there only if asked for.
  void says_what_the_answer_is_worth() {
    const double within_N = *window_->rehearsal().force_within_the_model_N(2);
    QVERIFY2(within_N > 0, qPrintable(QString::number(within_N)));
    window_->rehearsal().set_force_N(1.5 * within_N);
    QTest::mouseClick(child<QPushButton>("report_refresh"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("Outside of the model: strains reach"), patience_ms);
    window_->rehearsal().set_force_N(60 * within_N);
    QVERIFY(!window_->rehearsal().state()->validity.usable());
    QTest::mouseClick(child<QPushButton>("report_refresh"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("Not to be used: cells turned inside out"), patience_ms);
    QVERIFY(!text().contains("moves by up to"));
    QVERIFY(text().contains("The stiffness is assumed"));
    QVERIFY(!text().contains("What can be worn"));
    QTest::mouseClick(child<QCheckBox>("report_boards"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("What can be worn"), patience_ms);
    QTest::mouseClick(child<QCheckBox>("report_boards"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY_WITH_TIMEOUT(!text().contains("What can be worn"), patience_ms);
  }

  void saves_a_web_page_and_prints_a_pdf() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    const QString html = temporary_.filePath("report.html"), pdf = temporary_.filePath("report.pdf");
    QVERIFY(bool(view_->save_html(html.toStdString())));
    const auto bytes = read_text_file(html.toStdString(), 1 << 26);
    QVERIFY(bytes && bytes->find("6.00 kPa on average") != std::string::npos);
    QVERIFY(bytes->find(">small<") == std::string::npos);
    QVERIFY(bool(view_->print_pdf(pdf.toStdString())));
    QVERIFY(!view_->print_pdf("/proc/nowhere/report.pdf"));
    QFile file(pdf);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-");
    QVERIFY(file.size() > 10000);
  }

  // Headings, sentences and names; what is saved is what is read.
  void speaks_the_language_of_the_window() {
    choose_language("de");
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("Geplante Resektion"), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    for (const char* said : {"Kein Medizinprodukt.", "Geprobte Retraktion", "Palpationssonde mit", "Landmarke",
                             "im Mittel 6.00 kPa", "Elastizitätsmodul", "Leber", "umrissen", "Woher es kommt"}) {
      QVERIFY2(text().contains(said), qPrintable(QString("\"%1\" is not in: %2").arg(said, text())));
    }
    for (const char* left : {"Planned", "Rehearsed", "The stiffness", "Liver", "outlined", "Where", "The patient"}) {
      QVERIFY2(!text().contains(left), qPrintable(QString("\"%1\" is in: %2").arg(left, text())));
    }
    const QString html = temporary_.filePath("bericht.html");
    QVERIFY(bool(view_->save_html(html.toStdString())));
    QVERIFY(read_text_file(html.toStdString(), 1 << 26)->find("<html lang=\"de\">") != std::string::npos);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("report_de.png")));
    choose_language("en");
    QTRY_VERIFY_WITH_TIMEOUT(text().contains("Planned resection"), patience_ms);
  }

  void leaves_a_picture_to_look_at() {
    QTest::qWait(100);
    QVERIFY(window_->grab().save(glisson::test::kept_picture("report.png")));
    QFile::remove(glisson::test::kept_picture("report.pdf"));
    QVERIFY(QFile::copy(temporary_.filePath("report.pdf"), glisson::test::kept_picture("report.pdf")));
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*view_, name);
  }
  QString text() { return child<QTextBrowser>("paper")->toPlainText(); }

  std::unique_ptr<MainWindow> window_;
  ReportView* view_ = nullptr;
  QTemporaryDir temporary_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ReportViewTest>(argc, argv); }

#include "report_view_test.moc"
