// Every way out of the window, with a patient whose name must not take it. These are pictures of the views, movies and
// tables of a rehearsal, the log and the report of a problem, the report as a page and in print. The name is in the
// folder's name, as a person would have it. In the window itself it is shown.

#include <QCheckBox>
#include <QSet>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QtTest>
#include <set>

#include "base/files.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/landmark_table.h"
#include "widgets/report/report_view.h"
#include "widgets/settings/program_settings.h"
#include "widgets/settings/settings.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 20000;
constexpr const char* surname = "Meierhoff";

class PrivacyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    named_ = temporary_.path() / "Meierhoff-Anna.glisson";
    fs::rename(test::modelled_case(temporary_.path()), named_);
    fs::copy(named_, temporary_.path() / "other.glisson", fs::copy_options::recursive);
    window_ = shown_window();
    open(named_);
    QVERIFY(window_->windowTitle().contains(surname));
  }

  // The same case under another name gives the same pictures to the bit.
  void pictures_do_not_show_it() {
    const std::vector<QImage> with_name = pictures();
    open(temporary_.path() / "other.glisson");
    const std::vector<QImage> without = pictures();
    for (std::size_t k = 0; k < without.size(); ++k)
      QVERIFY2(with_name[k] == without[k], qPrintable(QString::number(k)));
    open(named_);
  }

  void tables_of_a_rehearsal_do_not_hold_it() {
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    const auto& surface = window_->rehearsal().body()->surface();
    window_->rehearsal().hold({"palpation-probe", surface.points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 1.5});
    QVERIFY(placed.wait(patience_ms));
    QVERIFY(!mentions(landmark_csv(*window_->rehearsal().state())));
    QVERIFY(!mentions(window_->rehearsal().track().csv({"tumour-1"})));
  }

  // As pictures they are the same to the bit under either name; as a video they hold none.
  void movies_do_not_show_it_nor_hold_it() {
    open(temporary_.path() / "other.glisson");
    const std::vector<QImage> without = film("unnamed");
    open(named_);
    const std::vector<QImage> with_name = film("named");
    QVERIFY(!with_name.empty());
    QCOMPARE(with_name.size(), without.size());
    for (std::size_t k = 0; k < without.size(); ++k)
      QVERIFY2(with_name[k] == without[k], qPrintable(QString::number(k)));
  }

  void log_and_report_of_a_problem_do_not_hold_it() {
    // An error that names the file, and so the patient, where the person sees it.
    const fs::path broken = temporary_.path() / "Meierhoff-broken.glisson";
    fs::create_directories(broken);
    QVERIFY(bool(write_text_file(broken / "case.json", "{")));
    window_->open_path(broken);
    QTRY_VERIFY_WITH_TIMEOUT(child_of<QLabel>(*window_, "notice_text")->text().contains(surname), patience_ms);
    QVERIFY(window_->diary().entries().size() > 2);
    QVERIFY(!mentions(problem_report(window_->diary(), "llvmpipe").toStdString()));
    const auto log = read_text_file(own_folder() / "glisson.log");
    QVERIFY(log && log->size() > 100);
    QVERIFY(!mentions(*log));
  }

  // The record, the history of what was done, and all that stands beside them.
  void the_cases_own_files_do_not_hold_it() {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(named_)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      const std::string name = entry.path().filename().string();
      QVERIFY2(!mentions(name) && !mentions(read_text_file(entry.path()).value_or(surname)), name.c_str());
    }
    QVERIFY(files > 4);
  }

  void reports_hold_it_only_when_asked() {
    window_->go_to("report");
    auto* view = window_->findChild<ReportView*>();
    auto* paper = child_of<QTextBrowser>(*view, "paper");
    QTRY_VERIFY_WITH_TIMEOUT(paper->toPlainText().contains("name withheld"), patience_ms);
    QVERIFY(!mentions(paper->toPlainText().toStdString()));
    QVERIFY(!mentions(web_page(*view)));
    QVERIFY(!mentions(print(*view)));
    QTest::mouseClick(child_of<QCheckBox>(*view, "report_name"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY_WITH_TIMEOUT(paper->toPlainText().contains(surname), patience_ms);
    QVERIFY(mentions(web_page(*view)));
  }

  // The ways to cases are listed for the person at this computer, under their folders' names, until they are forgotten.
  void settings_hold_it_in_the_ways_to_cases_alone() {
    const QStringList ways{"recent_cases", "grey_windows", "last_folder"};
    keep_window(named_, {60, 160});
    program_settings().setValue("last_folder", QString::fromStdString((temporary_.path() / "Meierhoff").string()));
    const QStringList held = keys_with_it();
    for (const QString& key : held) QVERIFY2(ways.contains(key), qPrintable(key));
    QCOMPARE(QSet<QString>(held.begin(), held.end()), QSet<QString>(ways.begin(), ways.end()));
    forget_recent_cases();
    QVERIFY2(keys_with_it().isEmpty(), qPrintable(keys_with_it().join(' ')));
    // What stood open, for the window that begins after this one was killed, goes with its end.
    for (const auto& entry : fs::recursive_directory_iterator(own_folder())) {
      if (!entry.is_regular_file() || entry.path().parent_path() == own_folder() / "open") continue;
      QVERIFY2(!mentions(read_text_file(entry.path(), 1 << 26).value_or(surname)), entry.path().c_str());
    }
    window_.reset();
    QVERIFY(fs::is_empty(own_folder() / "open"));
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  void open(const fs::path& folder) {
    window_->open_path(folder);
    const QString name = QString::fromStdString(folder.stem().string());
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().startsWith(name) && !window_->work().busy(), patience_ms);
    QTest::qWait(100);
  }

  std::vector<QImage> pictures() {
    std::vector<QImage> all{window_->views().space().picture()};
    for (SliceView* slice : window_->views().slices()) {
      // With the pointer over it a slice shows the crosshair's knobs; which window of the X server the pointer is over
      // is not this test's to say.
      QEvent leave(QEvent::Leave);
      QCoreApplication::sendEvent(slice, &leave);
      all.push_back(slice->picture());
    }
    return all;
  }

  // Of a tool that rests: its pictures. As a video too.
  std::vector<QImage> film(const std::string& name) {
    LiveRehearsal& rehearsal = window_->rehearsal();
    const PlacedTool probe{
        "palpation-probe", rehearsal.body()->surface().points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 1.5};
    // The second time alone is filmed: whether there was a tool before must not tell the two apart.
    for (int time = 0; time < 2; ++time) {
      rehearsal.hold_all({});
      rehearsal.clear_track();
      rehearsal.hold(probe);
      if (!QTest::qWaitFor([&] { return rehearsal.solving() == Solving::solved; }, patience_ms)) return {};
      (void)window_->views().space().picture();
    }
    TrackControls& track = window_->findChild<RehearsePanel*>()->track();
    QSignalSpy written(track.findChild<MovieMaker*>(), &MovieMaker::written);
    for (const char* ending : {".mp4", ""}) {
      track.make_movie(temporary_.path() / (name + ending));
      if (!written.wait(patience_ms)) return {};
    }
    if (mentions(read_text_file(temporary_.path() / (name + ".mp4"), 1 << 26).value_or(surname))) return {};
    std::set<fs::path> pictures;
    for (const auto& entry : fs::directory_iterator(temporary_.path() / name)) pictures.insert(entry.path());
    std::vector<QImage> film;
    for (const fs::path& picture : pictures) film.emplace_back(QString::fromStdString(picture.string()));
    return film;
  }

  std::string web_page(const ReportView& view) {
    const fs::path file = temporary_.path() / "report.html";
    if (!view.save_html(file)) return surname;
    return read_text_file(file, 1 << 26).value_or(surname);
  }

  std::string print(const ReportView& view) {
    const fs::path file = temporary_.path() / "report.pdf";
    if (!view.print_pdf(file)) return surname;
    return read_text_file(file, 1 << 26).value_or(surname);
  }

  static QStringList keys_with_it() {
    const QSettings settings = program_settings();
    QStringList keys = settings.allKeys();
    keys.removeIf([&](const QString& key) { return !settings.value(key).toStringList().join('\n').contains(surname); });
    return keys;
  }

  // As letters of 8 or 16 bits, which is how the properties of a PDF are written.
  static bool mentions(const std::string& text) {
    const std::string name(surname);
    std::string wide;
    for (const char letter : name) wide += std::string{'\0', letter};
    return text.find(name) != std::string::npos || text.find(wide) != std::string::npos;
  }

  TemporaryFolder temporary_;
  fs::path named_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::PrivacyTest>(argc, argv); }

#include "privacy_test.moc"
