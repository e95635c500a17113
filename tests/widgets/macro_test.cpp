// What is done in the window is copied as a program; run without the window, on the case as it was before, it makes the
// same files, byte for byte: from a shell and from Python.

#include <QClipboard>
#include <QJsonArray>
#include <QJsonObject>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <QtTest>

#include "base/files.h"
#include "casefile/model_upkeep.h"
#include "casefile/placed_landmarks.h"
#include "run_test.h"
#include "segment_workspace.h"
#include "widgets/diary/case_diary.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  const auto opened = casefile::Case::open(folder);
  if (!opened) qFatal("%s", opened.error().message().c_str());
  for (const casefile::Entry& entry : opened->entries()) {
    all[entry.id] = sha256_of_file(folder / entry.file).value_or("missing");
  }
  return all;
}

QString named(const std::map<std::string, std::string>& all) {
  QStringList lines;
  for (const auto& [id, content] : all) lines << QString::fromStdString(id + " " + content.substr(0, 12));
  return lines.join("\n");
}

class MacroTest : public SegmentWorkspace {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    open();
    before_ = temporary_.path() / "before.glisson";
    fs::copy(folder_, before_, fs::copy_options::recursive);
    fs::remove_all(before_ / "history");
    fs::remove(before_ / ".window.lock");
  }
  void cleanupTestCase() { close(); }

  void a_morning_of_work() {
    key(Qt::Key_B);
    stroke({-14, 0}, {14, 0});
    key(Qt::Key_G);
    press({0, 0});
    release({0, 0});
    settle();
    child<QPushButton>("grow")->click();
    settle();
    panel_->editor().add("tumour-1");
    settle();
    key(Qt::Key_B);
    stroke({0, -2}, {0, 2});
    key(Qt::Key_N);
    // What the button of the workspace Model does, with few cells.
    window_->undo().change({"Building the model", {}}, {}, [folder = folder_] {
      return casefile::Case::open(folder).and_then([](casefile::Case patient) {
        return casefile::bring_model_up_to_date(patient, {1500, casefile::Uniform{6.1}});
      });
    });
    settle();
    // As Rehearse keeps a tool that presses on a patch of the surface.
    const Eigen::Vector3d touched_mm = test::small_middle_mm() + Eigen::Vector3d(0, -15, 0);
    const QJsonObject tool{{"center_mm", QJsonArray{touched_mm.x(), touched_mm.y(), touched_mm.z()}},
                           {"radius_mm", 8.0},
                           {"force_N", 0.02},
                           {"direction", QJsonArray{0, 1, 0}}};
    window_->undo().value_changed({"Place the tool", {}}, "rehearse/tool", QJsonValue::Null,
                                  QJsonObject{{"touch", "patch"}, {"tools", QJsonArray{tool}}});
    window_->undo().change({"Landmarks", {}}, {"landmarks/placed"}, [folder = folder_] {
      return casefile::Case::open(folder).and_then([](casefile::Case patient) {
        return casefile::keep_landmarks(patient, {{"hilum", test::small_middle_mm() + Eigen::Vector3d(2, 1, 0)}});
      });
    });
    settle();
    QVERIFY(contents(folder_) != contents(before_));
  }

  void runs_from_a_shell_and_makes_the_same() {
    const QString text = copied("copy_command_line");
    QVERIFY2(text.contains("glisson-cli segment \"$CASE\" --structure liver --seed "), qPrintable(text));
    QVERIFY2(text.contains("glisson-cli mesh \"$CASE\" --target-cells "), qPrintable(text));
    QVERIFY2(text.contains("glisson-cli simulate \"$CASE\""), qPrintable(text));
    QVERIFY2(text.contains("Place the tool"), qPrintable(text));
    const fs::path again = copy_of_before("by-shell");
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QCoreApplication::applicationDirPath() + ":" + environment.value("PATH"));
    environment.remove("DISPLAY");
    run(shell, environment, "/bin/sh", again, QString(text).replace("CASE=before.glisson", "CASE=" + of(again)));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError());
    QVERIFY2(contents(again) == contents(folder_),
             qPrintable(named(contents(again)) + "\n\n" + named(contents(folder_))));
    const QStringList simulated = QDir(of(again.parent_path())).entryList({"rehearsal-*"});
    QCOMPARE(simulated.size(), 1);
    QVERIFY(fs::exists(again.parent_path() / simulated.front().toStdString() / "result.vtu"));
  }

  void runs_in_python_and_makes_the_same() {
    const QString package = QCoreApplication::applicationDirPath() + "/../python";
    if (!QFileInfo::exists(package + "/glisson/__init__.py")) QSKIP("the package for Python is not built");
    const QString text = copied("copy_python");
    const fs::path again = copy_of_before("by-python");
    QProcess python;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PYTHONPATH", package);
    run(python, environment, "/usr/bin/python3", again,
        QString(text).replace("\"before.glisson\"", "\"" + of(again) + "\""));
    const QByteArray said = python.readAllStandardError();
    if (said.contains("No module named 'numpy'")) QSKIP("numpy is not there");
    QVERIFY2(python.exitCode() == 0, said);
    QVERIFY2(contents(again) == contents(folder_),
             qPrintable(named(contents(again)) + "\n\n" + named(contents(folder_))));
  }

  void on_the_case_as_it_is_now_nothing_is_done_twice() {
    const auto now = contents(folder_);
    const fs::path again = temporary_.path() / "now.glisson";
    fs::copy(folder_, again, fs::copy_options::recursive);
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QCoreApplication::applicationDirPath() + ":" + environment.value("PATH"));
    run(shell, environment, "/bin/sh", again,
        copied("copy_command_line").replace("CASE=before.glisson", "CASE=" + of(again)));
    QVERIFY(shell.exitCode() != 0);
    QVERIFY(shell.readAllStandardError().contains("began with another labels/liver"));
    QVERIFY(contents(again) == now);
  }

 private:
  static QString of(const fs::path& path) { return QString::fromStdString(path.string()); }
  fs::path copy_of_before(const char* name) {
    const fs::path folder = temporary_.path() / name / "small.glisson";
    fs::create_directories(folder.parent_path());
    fs::copy(before_, folder, fs::copy_options::recursive);
    return folder;
  }
  // By the window's menu and the button.
  QString copied(const char* button) {
    window_->findChild<QAction*>("show_case_diary")->trigger();
    auto* diary = child<CaseDiary>("case_diary");
    if (diary->findChild<QListWidget*>("case_steps")->count() < 6) qFatal("the diary lists too few steps");
    QApplication::clipboard()->clear();
    diary->findChild<QPushButton*>(button)->click();
    const QString text = QApplication::clipboard()->text();
    delete diary;
    return text;
  }
  static void run(QProcess& process, const QProcessEnvironment& environment, const QString& program,
                  const fs::path& beside, const QString& text) {
    const fs::path file = beside.parent_path() / (beside.stem().string() + ".macro");
    if (!write_text_file(file, text.toStdString())) qFatal("no file for the program");
    process.setWorkingDirectory(of(beside.parent_path()));
    process.setProcessEnvironment(environment);
    process.start(program, {of(file)});
    process.waitForFinished(240000);
  }

  fs::path before_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::MacroTest>(argc, argv); }

#include "macro_test.moc"
