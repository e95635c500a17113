// The window closed in the midst of long work, of each kind that there is: the program's event loop ends, the work
// gives up, and the case on disk is whole and as it was.

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "casefile/case.h"
#include "imaging/volume_file.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "wave_case.h"
#include "widgets/guide/guide_page.h"
#include "widgets/main_window.h"
#include "widgets/register/register_page.h"
#include "widgets/segment/segment_panel.h"
#include "widgets/settings/settings.h"
#include "widgets/study/study_page.h"
#include "widgets/views/wave_view.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 120000;  // for the longest step on a machine that does other work too

class ClosingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    window_ = shown_window();
  }

  void while_the_demo_patient_is_made() {
    window_->open_demo();
    close_once_work_goes_on();
    QVERIFY(!fs::exists(own_folder() / "demo" / "demo.glisson" / "case.json"));
  }

  void while_a_folder_is_looked_through() {
    write_image(folder_->path() / "t1.nrrd");
    window_->open_path(folder_->path());
    close();
    QCOMPARE(files(), QStringList{"t1.nrrd"});
  }

  void while_images_are_imported() {
    write_image(folder_->path() / "t1.nrrd");
    window_->open_path(folder_->path());
    auto* make = child_of<QPushButton>(*window_, "make_case");
    QTRY_VERIFY_WITH_TIMEOUT(make->isEnabled(), patience_ms);
    const fs::path made = folder_->path() / "made.glisson";
    child_of<QLineEdit>(*window_, "keep_as")->setText(QString::fromStdString(made.string()));
    QTest::mouseClick(make, Qt::LeftButton);
    QVERIFY(window_->work().busy());
    close();
    // Nothing is left of it, or it was done before the window could say a word.
    QVERIFY(!fs::exists(made) || casefile::Case::open(made)->find("volumes/anatomy") != nullptr);
  }

  void while_a_structure_grows() {
    const fs::path folder = open(test::small_case(folder_->path()));
    window_->go_to("segment");
    auto* panel = window_->findChild<SegmentPanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(panel->editor().can_edit(), patience_ms);
    // On the thread that writes the history: the window waits for what is being written, and for that alone.
    panel->editor().apply(GLISSON_TEXT("Margin around {0}"),
                          [](imaging::Mask mask) { return segmentation::with_margin(std::move(mask), 3); });
    QVERIFY(window_->undo().busy());
    close();
    QVERIFY(test::voxels_of(folder, "liver") > 0);
  }

  void while_a_model_is_built() {
    const fs::path folder = open(test::modelled_case(folder_->path()));
    const std::string before = model_of(folder);
    window_->go_to("model");
    auto* build = child_of<QPushButton>(*window_, "model_build");
    QTRY_VERIFY_WITH_TIMEOUT(build->isEnabled() && build->text() == "Build it anew", patience_ms);
    child_of<QDoubleSpinBox>(*window_, "model_target")->setValue(200000);
    QTest::mouseClick(build, Qt::LeftButton);
    close_once_work_goes_on();
    QCOMPARE(model_of(folder), before);
  }

  void while_a_rigid_tool_presses() {
    open(test::modelled_case(folder_->path()));
    LiveRehearsal& rehearsal = window_->rehearsal();
    rehearsal.set_touch(Touch::rigid);
    rehearsal.hold({"palpation-probe", rehearsal.body()->surface().points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 0.05});
    QCOMPARE(rehearsal.solving(), Solving::solving);
    close();
  }

  void while_a_tool_is_placed_and_a_cut_planned() {
    open(test::modelled_case(folder_->path()));
    const auto& points_mm = window_->rehearsal().body()->surface().points_mm;
    window_->rehearsal().hold({"palpation-probe", points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 1.5});
    window_->go_to("resect");
    QTest::mouseClick(child_of<QPushButton>(*window_, "cut_through_crosshair"), Qt::LeftButton);
    close();
  }

  void while_a_movie_is_made() {
    open(test::modelled_case(folder_->path()));
    LiveRehearsal& rehearsal = window_->rehearsal();
    QSignalSpy placed(&rehearsal, &LiveRehearsal::placed);
    rehearsal.hold({"palpation-probe", rehearsal.body()->surface().points_mm.front(), {0, -1, 0}, 6, {0, 1, 0}, 1.0});
    QVERIFY(placed.wait(patience_ms));
    rehearsal.set_force_N(2.0);
    TrackControls& track = window_->findChild<RehearsePanel*>()->track();
    QSignalSpy pictures(track.findChild<MovieMaker*>(), &MovieMaker::progressed);
    track.make_movie(folder_->path() / "movie.mp4");
    QVERIFY(pictures.wait(patience_ms));
    close();
    QCOMPARE(files(), QStringList{"small.glisson"});
  }

  void while_measurements_are_explained() {
    window_->go_to("evidence");
    QTest::mouseClick(child_of<QPushButton>(*window_, "evidence_example"), Qt::LeftButton);
    close_once_work_goes_on();
  }

  void while_an_example_video_is_made() {
    window_->go_to("register");
    window_->findChild<RegisterPage*>()->open_example();
    close_once_work_goes_on();
    QVERIFY(!fs::exists(own_folder() / "example-sequence" / "sequence.json"));
  }

  void while_a_video_is_registered() {
    window_->go_to("register");
    auto* page = window_->findChild<RegisterPage*>();
    page->open_example();
    QTRY_VERIFY_WITH_TIMEOUT(page->has_sequence() && !window_->work().busy(), patience_ms);
    page->compute();
    close_once_work_goes_on();
  }

  void while_a_liver_is_placed_on_a_video() {
    open(test::modelled_case(folder_->path()));
    window_->go_to("guide");
    auto* page = window_->findChild<GuidePage*>();
    page->open_example();
    QTRY_VERIFY_WITH_TIMEOUT(page->has_video() && !window_->work().busy(), patience_ms);
    page->place();
    QVERIFY(window_->work().busy());
    close();
  }

  void while_a_report_is_collected() {
    open(test::modelled_case(folder_->path()));
    window_->go_to("report");
    QVERIFY(window_->work().busy());
    close();
  }

  void while_waves_are_inverted_in_a_window_of_their_own() {
    test::write_wave_case(folder_->path() / "waves.glisson");
    const fs::path folder = open(folder_->path() / "waves.glisson");
    auto* waves = show_waves();
    QTRY_VERIFY_WITH_TIMEOUT(waves->findChild<QProgressBar*>()->value() > 0, patience_ms);
    close();
    QVERIFY(casefile::Case::open(folder)->find("volumes/stiffness") == nullptr);
  }

  // It waits for its own work, and for no other's.
  void a_window_of_its_own_closes_while_other_work_goes_on() {
    test::write_wave_case(folder_->path() / "waves.glisson");
    open(folder_->path() / "waves.glisson");
    QPointer<WaveView> waves = show_waves();
    window_->work().start("Waiting", [](const Progress& progress) -> BackgroundWork::Then {
      while (!progress.cancelled()) QThread::msleep(5);
      return [] {};
    });
    waves->close();
    QTRY_VERIFY_WITH_TIMEOUT(waves.isNull(), patience_ms);
    QVERIFY(window_->work().busy());
    close();
  }

 private:
  fs::path open(const fs::path& folder) {
    QSignalSpy finished(&window_->work(), &BackgroundWork::finished);
    window_->open_path(folder);
    if (finished.empty() && !finished.wait(patience_ms)) qFatal("the case does not open");
    QTest::qWait(0);  // what finished() is followed by: the patient is shown
    return folder;
  }

  WaveView* show_waves() {
    for (QAction* action : window_->findChildren<QAction*>()) {
      if (action->shortcut() == QKeySequence("Ctrl+W")) action->trigger();
    }
    auto* waves = window_->findChild<WaveView*>();
    if (waves == nullptr) qFatal("there is no window of waves");
    return waves;
  }

  void close_once_work_goes_on() {
    QSignalSpy progressed(&window_->work(), &BackgroundWork::progressed);
    QVERIFY(progressed.wait(patience_ms));
    QVERIFY(window_->work().busy());
    close();
  }

  // As main() does: the loop runs until the last window is closed, then the window goes.
  void close() {
    QTimer::singleShot(0, window_.get(), &QWidget::close);
    QTimer::singleShot(100, window_.get(), [this] { give_up_if_asked(); });
    QApplication::exec();
    QElapsedTimer clock;
    clock.start();
    window_.reset();
    qInfo("ended in %lld ms", static_cast<long long>(clock.elapsed()));
  }

  // What changes the case is not given up without a question.
  void give_up_if_asked() {
    auto* question = window_->findChild<QMessageBox*>("ask_close");
    if (question != nullptr) child_of<QPushButton>(*question, "give_up")->click();
  }

  static void write_image(const fs::path& file) {
    imaging::Volume volume;
    volume.grid.size = {160, 160, 80};
    volume.grid.spacing_mm = {2, 2, 3};
    volume.values.resize(volume.grid.voxels());
    for (std::size_t k = 0; k < volume.values.size(); ++k) volume.values[k] = static_cast<float>(k % 251);
    if (!imaging::write_volume_file(file, volume)) qFatal("no image for the test");
  }

  QStringList files() const {
    return QDir(QString::fromStdString(folder_->path().string())).entryList(QDir::NoDotAndDotDot | QDir::AllEntries);
  }

  static std::string model_of(const fs::path& folder) {
    const auto file = casefile::Case::open(folder)->file_of("meshes/model");
    return file ? read_text_file(*file, 1 << 26).value_or("unreadable") : "gone";
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ClosingTest>(argc, argv); }

#include "closing_test.moc"
