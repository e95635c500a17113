// What is done in a workspace and changes nothing in the case is copied as commands too: rigid tools, large
// deformations, a cut led on under a tool, a cut in the making. Without the window they answer as it did, to the bit.

#include <QClipboard>
#include <QProcess>
#include <QPushButton>
#include <QtTest>

#include "base/files.h"
#include "base/json.h"
#include "casefile/resection_folder.h"
#include "modelled_case.h"
#include "planning/plan_file.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/diary/case_diary.h"
#include "widgets/main_window.h"
#include "widgets/rehearse/planned_course.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/session/load_patient.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 60000;

class MacroViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::modelled_case(temporary_.path());
    keep_a_cut();
    before_ = temporary_.path() / "before.glisson";
    fs::copy(folder_, before_, fs::copy_options::recursive);
    window_ = shown_window({1500, 1000});
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
  }

  void rigid_tools_and_a_cut_under_them() {
    window_->go_to("rehearse");
    rehearsal().set_touch(Touch::rigid);
    rest("Another way of touching");
    rehearsal().hold(probe({0, -1, 0}, 0.05));
    rest("Place the tool");
    rehearsal().keep_tool();
    rehearsal().hold(probe({1, 0, 0}, 0.05));
    rest("Place another tool");
    rehearsal().set_force_N(0.08);
    rest("Change the force");
    window_->undo().undo();
    rest("Place another tool");
    const auto patient = load_patient(folder_, {});
    QVERIFY(patient.has_value());
    const auto course = planned_course(*patient).course;
    QVERIFY(course.has_value());
    rehearsal().advance_cut(course->strip(0, 5));
    rest("Cut along the plan");
    QCOMPARE(rehearsal().cut_steps(), 1);
    rehearsal().advance_cut(course->strip(5, 10));
    rest("Cut along the plan");
    QCOMPARE(rehearsal().cut_steps(), 2);
    keep_digests();
  }

  void large_deformations() {
    rehearsal().set_deformations(Deformations::large);
    rest("Small or large deformations");
    rehearsal().set_force_N(0.06);
    rest("Change the force");
    keep_digests();
  }

  void a_cut_in_the_making() {
    window_->go_to("resect");
    auto* panel = window_->findChild<ResectPanel*>();
    window_->views().set_crosshair(test::small_middle_mm());
    panel->findChild<QPushButton*>("cut_through_crosshair")->click();
    const LivePlan& live = panel->by_anatomy().live();
    QTRY_VERIFY_WITH_TIMEOUT(live.result() != nullptr, patience_ms);
    settle();
    planned_ = planning::answer_json(live.result()->answer, live.anatomy()->planner.trees());
  }

  void run_from_a_shell_as_in_the_window() {
    const QString text = copied("copy_command_line");
    QVERIFY2(text.contains("glisson-cli session \"$CASE\" --live --material linear"), qPrintable(text));
    QVERIFY2(text.contains("glisson-cli session \"$CASE\" --live --material neo-hookean"), qPrintable(text));
    QVERIFY2(text.contains("(in the session of step "), qPrintable(text));
    const fs::path again = copy_of_before("by-shell");
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QCoreApplication::applicationDirPath() + ":" + environment.value("PATH"));
    environment.remove("DISPLAY");
    run(shell, environment, "/bin/sh", again, QString(text).replace("CASE=before.glisson", "CASE=" + of(again)));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError() + "\n" + text.toUtf8().left(3000));
    QStringList found;
    for (const QString& name : QDir(of(again.parent_path())).entryList({"rehearsal-*"})) {
      QString digests;
      const Json session = read(again.parent_path() / name.toStdString() / "session.json");
      for (const Json& command : session.at("commands")) {
        digests += QString::fromStdString(command.at("digest")) + " ";
      }
      found << digests;
    }
    is_what_the_window_did(found);
    const QStringList plans = QDir(of(again.parent_path())).entryList({"plan-*"}, QDir::Dirs);
    QCOMPARE(plans.size(), 1);
    const Json answer = read(again.parent_path() / plans.front().toStdString() / "answer.json");
    for (const auto& [key, value] : planned_.items()) QVERIFY2(answer.at(key) == value, key.c_str());
  }

  void run_in_python_as_in_the_window() {
    const QString package = QCoreApplication::applicationDirPath() + "/../python";
    if (!QFileInfo::exists(package + "/glisson/__init__.py")) QSKIP("the package for Python is not built");
    const fs::path again = copy_of_before("by-python");
    QProcess python;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PYTHONPATH", package);
    const QString digests =
        "\nfor name in sorted(n for n in globals() if n.startswith('rehearsal_')):\n"
        "    commands = globals()[name].recording()['commands']\n"
        "    print(*(command['digest'] for command in commands), end=' \\n')\n";
    run(python, environment, "/usr/bin/python3", again,
        copied("copy_python").replace("\"before.glisson\"", "\"" + of(again) + "\"") + digests);
    const QByteArray said = python.readAllStandardError();
    if (said.contains("No module named 'numpy'")) QSKIP("numpy is not there");
    QVERIFY2(python.exitCode() == 0, said);
    is_what_the_window_did(QString(python.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts));
  }

  // Also where a tool has moved since, which closes the way back that Rehearse itself has.
  void undo_takes_a_cut_back_and_leads_it_on_again() {
    window_->go_to("rehearse");
    const auto patient = load_patient(folder_, {});
    const auto course = planned_course(*patient).course;
    rehearsal().set_deformations(Deformations::small);
    rest("Small or large deformations");
    const std::vector<PlacedTool> tools = rehearsal().tools();
    rehearsal().advance_cut(course->strip(0, 5));
    rest("Cut along the plan");
    rehearsal().set_force_N(0.05);
    rest("Change the force");
    window_->undo().undo();
    rest("Cut along the plan");
    QVERIFY(!rehearsal().can_take_cut_back());
    window_->undo().undo();
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), 0, patience_ms);
    rest("Small or large deformations");
    QVERIFY(rehearsal().tools() == tools);
    window_->undo().redo();
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), 1, patience_ms);
    rest("Cut along the plan");
    QVERIFY(rehearsal().tools() == tools);
    window_->undo().undo();
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().cut_steps(), 0, patience_ms);
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }
  static QString of(const fs::path& path) { return QString::fromStdString(path.string()); }
  static Json read(const fs::path& file) {
    const auto document = read_json_file(file);
    if (!document) qFatal("%s", document.error().message().c_str());
    return *document;
  }
  static PlacedTool probe(const Eigen::Vector3d& outward, double force_N) {
    return {"palpation-probe", test::small_middle_mm() + 12 * outward, outward, 4, -outward, force_N};
  }
  void keep_digests() {
    QString digests;
    for (const auto& [command, digest] : rehearsal().recording()) digests += QString::fromStdString(digest) + " ";
    digests_ << digests;
  }
  // After the last step the window may have brought the liver nearer to rest.
  void is_what_the_window_did(const QStringList& found) {
    QCOMPARE(found.size(), digests_.size());
    for (int k = 0; k < found.size(); ++k) {
      QVERIFY2(found[k].count(' ') > 2 && digests_[k].startsWith(found[k]), qPrintable(found[k] + "\n" + digests_[k]));
    }
  }
  // Across the liver's middle, kept as Resect keeps it.
  void keep_a_cut() {
    casefile::PlannedCut cut;
    cut.point_mm = test::small_middle_mm();
    cut.normal = {0, 0, 1};
    const auto opened = casefile::Case::open(folder_);
    const auto model = casefile::read_model(*opened);
    const auto plan = casefile::plan_resection(model->mesh, cut, {});
    if (!plan || !casefile::write_resection(folder_ / "results" / "resection", cut, *plan)) qFatal("no cut");
  }
  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
  }
  // Until a rest has made a step of it.
  void rest(const char* step) {
    const auto is_there = [&] {
      return rehearsal().solving() != Solving::solving && rehearsal().solving() != Solving::settling &&
             window_->undo().undo_action()->text() == QString("&Undo: ") + step;
    };
    QVERIFY2(QTest::qWaitFor(is_there, patience_ms), qPrintable(window_->undo().undo_action()->text()));
    QTest::qWait(600);
    settle();
  }
  fs::path copy_of_before(const char* name) const {
    fs::path folder = temporary_.path() / name / "small.glisson";
    fs::create_directories(folder.parent_path());
    fs::copy(before_, folder, fs::copy_options::recursive);
    return folder;
  }
  QString copied(const char* button) {
    window_->findChild<QAction*>("show_case_diary")->trigger();
    auto* diary = window_->findChild<CaseDiary*>("case_diary");
    QApplication::clipboard()->clear();
    diary->findChild<QPushButton*>(button)->click();
    const QString text = QApplication::clipboard()->text();
    delete diary;
    return text;
  }
  static void run(QProcess& process, const QProcessEnvironment& environment, const QString& program,
                  const fs::path& beside, const QString& text) {
    const fs::path file = beside.parent_path() / "work.macro";
    if (!write_text_file(file, text.toStdString())) qFatal("no file for the program");
    process.setWorkingDirectory(of(beside.parent_path()));
    process.setProcessEnvironment(environment);
    process.start(program, {of(file)});
    process.waitForFinished(240000);
  }

  TemporaryFolder temporary_;
  fs::path folder_, before_;
  std::unique_ptr<MainWindow> window_;
  QStringList digests_;  // of each session in the window, state by state
  Json planned_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::MacroViewsTest>(argc, argv); }

#include "macro_views_test.moc"
