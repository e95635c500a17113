// What the window keeps between runs and of a run: settings, recent cases, the diary, and where one was when it ended
// without saying so.

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <QComboBox>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTableWidget>
#include <QtTest>
#include <set>

#include "base/files.h"
#include "run_test.h"
#include "widgets/diary/diary_window.h"
#include "widgets/diary/stall_watch.h"
#include "widgets/help/shortcuts_window.h"
#include "widgets/main_window.h"
#include "widgets/session/open_work.h"
#include "widgets/settings/settings.h"
#include "widgets/settings/settings_window.h"
#include "widgets/theme.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

fs::path empty_case(const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream(folder / "case.json") << "{}";
  return folder;
}

// In another process, so that it can end like one that crashed.
void keep_and_be_killed(const fs::path& folder, const OpenWork& work) {
  const pid_t child = fork();
  if (child == 0) {
    OpenWorkFile file(folder);
    if (!file.keep(work)) _exit(1);
    raise(SIGKILL);
  }
  int status = 0;
  QCOMPARE(waitpid(child, &status, 0), child);
  QVERIFY(WIFSIGNALED(status));
}

class KeepingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lists_the_last_eight_cases_that_are_still_there() {
    for (int k = 0; k < 10; ++k) remember_case(empty_case(folder_.path() / ("case" + std::to_string(k) + ".glisson")));
    remember_case(folder_.path() / "case5.glisson");  // again
    fs::remove_all(folder_.path() / "case8.glisson");
    const auto cases = recent_cases();
    QCOMPARE(cases.size(), std::size_t{7});
    QCOMPARE(cases[0].filename().string(), std::string("case5.glisson"));
    QCOMPARE(cases[1].filename().string(), std::string("case9.glisson"));
    QCOMPARE(cases[2].filename().string(), std::string("case7.glisson"));
    forget_recent_cases();
    QVERIFY(recent_cases().empty());
  }

  void a_case_is_listed_once_whatever_way_led_to_it() {
    const fs::path folder = empty_case(folder_.path() / "one.glisson");
    fs::create_directory_symlink(folder_.path(), folder_.path() / "link");
    remember_case(folder);
    remember_case(folder_.path() / "link" / "one.glisson");
    remember_case(folder_.path() / "." / "one.glisson");
    QCOMPARE(recent_cases().size(), std::size_t{1});
    forget_recent_cases();
  }

  void settings_hold_at_once() {
    SettingsWindow window;
    window.show();
    auto* theme = window.findChild<QComboBox*>("theme");
    const QColor dark = QApplication::palette().color(QPalette::Window);
    theme->setFocus();
    QTest::keyClick(theme, Qt::Key_Down);
    QVERIFY(kept_theme() == Theme::light);
    QVERIFY(QApplication::palette().color(QPalette::Window).lightness() > dark.lightness() + 100);
    QTest::keyClick(theme, Qt::Key_Up);
    QVERIFY(kept_theme() == Theme::dark);
    QVERIFY(!names_shown_outside());
  }

  void the_diary_holds_no_value_of_an_error() {
    Diary diary;
    diary.note(Error{"mesh-empty",
                     "The structure {0} of {1} holds no voxels.",
                     {"liver", "Jane Doe"},
                     "Ask {1}.",
                     "/home/jane/doe.glisson"});
    diary.note_stall(240);
    const QString report = problem_report(diary, "llvmpipe");
    QVERIFY(report.contains("mesh-empty: The structure {0} of {1} holds no voxels."));
    QVERIFY(report.contains("The window stood still. 240 ms"));
    QVERIFY(!report.contains("Jane") && !report.contains("jane") && !report.contains("liver"));
  }

  void the_diary_forgets_the_oldest_and_its_file_stays_small() {
    const fs::path file = folder_.path() / "diary.log";
    Diary diary(QString::fromStdString(file.string()), nullptr, 10);
    for (int k = 0; k < 30'000; ++k) diary.note("A sentence that says that something has happened.");
    QCOMPARE(diary.entries().size(), std::size_t{10});
    QVERIFY(fs::file_size(file) > 1000);
    QVERIFY(fs::file_size(file) <= (1U << 20) + 200);
  }

  void shows_the_diary_as_it_grows() {
    Diary diary;
    DiaryWindow window(diary, "llvmpipe");
    window.show();
    diary.note("Something happened.");
    QVERIFY(window.findChild<QPlainTextEdit*>("diary_lines")->toPlainText().contains("Something happened."));
  }

  void notices_that_the_window_stood_still() {
    StallWatch watch;
    watch.forget();
    QSignalSpy stood(&watch, &StallWatch::stood_still);
    QTest::qSleep(300);
    QVERIFY(stood.wait());
    QVERIFY(stood.first().first().toDouble() > 250);
    QVERIFY(watch.longest_ms() > 250);
    QVERIFY(watch.longest_computing_ms() < 250);  // it slept
  }

  void finds_again_what_stood_open_in_a_window_that_was_killed() {
    const fs::path open = folder_.path() / "open";
    OpenWork work{.case_folder = empty_case(folder_.path() / "killed.glisson"), .workspace = "rehearse", .tool = {}};
    work.tool = {{1.5, -2, 3}, 10, 2.25, {0, 0, -1}};
    keep_and_be_killed(open, work);
    OpenWorkFile file(open);
    const auto lost = file.take_lost();
    QVERIFY(lost.has_value());
    QVERIFY(lost->case_folder == work.case_folder);
    QCOMPARE(lost->workspace, work.workspace);
    QVERIFY(lost->tool->center_mm == work.tool->center_mm && lost->tool->direction == work.tool->direction);
    QCOMPARE(lost->tool->force_N, 2.25);
    QVERIFY(!file.take_lost());  // handed out once
  }

  // Started by a program that does not look after what it started.
  void finds_it_though_nobody_asked_after_the_window_that_was_killed() {
    const fs::path open = folder_.path() / "open3";
    const OpenWork work{
        .case_folder = empty_case(folder_.path() / "unasked.glisson"), .workspace = "evidence", .tool = {}};
    const pid_t child = fork();
    if (child == 0) {
      OpenWorkFile file(open);
      if (!file.keep(work)) _exit(1);
      raise(SIGKILL);
    }
    siginfo_t ended{};
    QCOMPARE(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
    OpenWorkFile file(open);
    const auto lost = file.take_lost();
    QVERIFY(lost && lost->workspace == "evidence");
    QCOMPARE(waitpid(child, nullptr, 0), child);
  }

  void takes_nothing_from_a_window_that_runs_or_ended_well_or_whose_case_is_gone() {
    const fs::path open = folder_.path() / "open2";
    const OpenWork work{
        .case_folder = empty_case(folder_.path() / "mine.glisson"), .workspace = "rehearse", .tool = {}};
    OpenWorkFile mine(open);
    QVERIFY(mine.keep(work));
    QVERIFY(!mine.take_lost());  // it runs
    {
      OpenWorkFile ends_well(open);
      QVERIFY(ends_well.keep(work));
    }
    QVERIFY(fs::is_empty(open));
    keep_and_be_killed(open, {.case_folder = folder_.path() / "gone.glisson", .workspace = "model", .tool = {}});
    QVERIFY(!mine.take_lost());
    std::ofstream(open / "999999999.json") << "{\"case\": 7}";  // no process has this number
    QVERIFY(!mine.take_lost());
    QVERIFY(fs::is_empty(open));
  }

  void offers_what_was_lost_on_the_first_page() {
    const fs::path own(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString());
    keep_and_be_killed(
        own / "open",
        {.case_folder = empty_case(folder_.path() / "Smith.glisson"), .workspace = "platform", .tool = {}});
    MainWindow window;
    window.show();
    auto* offer = window.findChild<QPushButton*>("open_lost");
    QVERIFY(offer->isVisible());
    QVERIFY(offer->text().contains("Smith"));
    QTest::mouseClick(offer, Qt::LeftButton);  // what stands there is no case: said so, nothing lost
    QTRY_VERIFY(window.findChild<QWidget*>("notice")->isVisible());
  }

  void lists_every_key_of_the_menus() {
    MainWindow window;
    window.show();
    window.findChild<QAction*>("keys")->trigger();
    const auto* table = window.findChild<QTableWidget*>("shortcuts");
    QVERIFY(table != nullptr);
    QStringList listed;
    for (int row = 0; row < table->rowCount(); ++row) listed << table->item(row, 1)->text();
    int actions = 0;
    for (const QAction* action : window.findChildren<QAction*>()) {
      if (action->shortcut().isEmpty()) continue;
      ++actions;
      QVERIFY2(listed.contains(action->shortcut().toString(QKeySequence::NativeText)), qPrintable(action->text()));
    }
    QVERIFY(actions > 8);
  }

  // What /proc/net lists of this process; the X server and D-Bus are reached by sockets in the file system.
  void opens_no_network_socket() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    std::set<std::string> mine;
    for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
      std::error_code gone;
      const std::string target = fs::read_symlink(entry.path(), gone).string();
      if (target.rfind("socket:[", 0) == 0) mine.insert(target.substr(8, target.size() - 9));
    }
    QVERIFY(!mine.empty());  // the X server's
    for (const char* table : {"tcp", "tcp6", "udp", "udp6", "raw", "raw6"}) {
      std::ifstream lines(std::string("/proc/self/net/") + table);
      std::string word;
      while (lines >> word) QVERIFY2(mine.count(word) == 0, table);
    }
  }

  void no_key_does_two_things() {
    MainWindow window;
    QStringList keys;
    for (const QAction* action : window.findChildren<QAction*>()) {
      if (!action->shortcut().isEmpty()) keys << action->shortcut().toString();
    }
    QCOMPARE(QSet<QString>(keys.begin(), keys.end()).size(), keys.size());
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::KeepingTest>(argc, argv); }

#include "keeping_test.moc"
