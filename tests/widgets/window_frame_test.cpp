// The window around its views: size and place, notices that move nothing, F1, a case that another window has open or
// that goes away, and closing in the midst of a build.

#include <filesystem>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QtTest>

#include "base/files.h"
#include "block_patient.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/help/manual_pages.h"
#include "widgets/help/manual_window.h"
#include "widgets/main_window.h"
#include "widgets/segment/segment_panel.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 60000;

class WindowFrameTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { choose_language("en"); }

  void opens_as_large_and_where_it_was() {
    auto first = shown_window({1290, 740});
    first->move(60, 40);
    QTRY_COMPARE(first->pos(), QPoint(60, 40));
    first->close();
    MainWindow second;
    QCOMPARE(second.size(), QSize(1290, 740));
    second.show();
    QVERIFY(QTest::qWaitForWindowExposed(&second));
    QTest::qWait(50);
    QCOMPARE(second.size(), QSize(1290, 740));
    QCOMPARE(second.pos(), QPoint(60, 40));
  }

  // Progress and Cancel stand in the window's last line.
  void all_of_it_is_on_the_screen_when_it_opens() {
    {
      const auto large = shown_window({3000, 2000});
      large->move(300, 200);
      QTest::qWait(50);
      large->close();
    }
    MainWindow opened;
    opened.show();
    QVERIFY(QTest::qWaitForWindowExposed(&opened));
    const QRect screen = opened.screen()->availableGeometry();
    QTRY_VERIFY2(screen.contains(opened.frameGeometry()), qPrintable(translated(opened.frameGeometry())));
    const QStatusBar* line = opened.statusBar();
    QVERIFY(screen.contains(QRect(line->mapToGlobal(QPoint(0, 0)), line->size())));
  }

  // 2560 x 1440 at twice the size, less a frame.
  void fits_a_small_screen_in_every_language() {
    const auto window = shown_window();
    for (const char* language : {"en", "de", "fr", "es"}) {
      choose_language(language);
      const auto minimum = [&] { return window->minimumSizeHint(); };
      QTRY_VERIFY2(minimum().width() <= 1264 && minimum().height() <= 680,
                   qPrintable(QString("%1: %2 x %3").arg(language).arg(minimum().width()).arg(minimum().height())));
    }
  }

  void a_notice_moves_nothing_and_is_red_only_for_trouble() {
    const auto window = shown_window();
    Patient patient = block_patient({3, 2, 2}, {}, {});
    window->show_patient(patient);
    QTest::qWait(50);
    const QRect views = window->views().geometry();
    const QPoint corner = window->views().mapToGlobal(QPoint(0, 0));
    auto* notice = child_of<QWidget>(*window, "notice");
    patient.remarks = {{"The liver is small.", {}}};
    window->show_patient(patient);
    QTRY_VERIFY(notice->isVisible());
    QVERIFY(!is_reddish(*notice));
    QCOMPARE(window->views().geometry(), views);
    QCOMPARE(window->views().mapToGlobal(QPoint(0, 0)), corner);
    QVERIFY(window->rect().contains(QRect(notice->mapTo(window.get(), QPoint(0, 0)), notice->size())));
    const TemporaryFolder empty;
    QSignalSpy finished(&window->work(), &BackgroundWork::finished);
    window->open_path(empty.path());
    QVERIFY(finished.wait(patience_ms));
    QTRY_VERIFY(is_reddish(*notice));
    QTest::mouseClick(notice->findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(!notice->isVisible());
  }

  // Half of the work took 3.2 s, and the other half says nothing while it is done.
  void the_time_left_goes_down_while_nothing_is_reported() {
    BackgroundWork work;
    StatusLine line(work);
    line.show();
    const auto told = [&] {
      const auto labels = line.findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const QLabel* one) { return one->text().contains("left"); })
                 ? labels.front()->text()
                 : QString();
    };
    work.start("Building", [](const Progress& progress) -> BackgroundWork::Then {
      progress.report(0.01, "Meshing");
      QThread::msleep(3200);
      progress.report(0.5, "Factorising");
      QThread::msleep(3200);
      return [] {};
    });
    QTRY_COMPARE_WITH_TIMEOUT(told(), QString("Factorising, about 4 s left"), 5000);
    QTRY_COMPARE_WITH_TIMEOUT(told(), QString("Factorising, about 2 s left"), 2500);
    QTRY_VERIFY_WITH_TIMEOUT(!work.busy(), 5000);
    QCOMPARE(told(), QString());
  }

  void f1_opens_the_page_of_the_workspace() {
    const auto window = shown_window();
    press_key(*window, Qt::Key_F1);
    auto* manual = window->findChild<ManualWindow*>();
    QVERIFY(manual != nullptr);
    QCOMPARE(manual->open_page(), QString("01-start"));  // nothing is open yet
    window->show_patient(block_patient({3, 2, 2}, {}, {}));
    for (const char* workspace : {"study", "segment", "model", "rehearse", "resect", "report", "guide", "register",
                                  "platform", "evidence", "studies"}) {
      window->go_to(workspace);
      press_key(*window, Qt::Key_F1);
      QCOMPARE(manual->open_page(), manual_page_of(workspace));
      QVERIFY(manual->open_page() != "01-start");
      QVERIFY(manual->isVisible());
      manual->hide();
    }
  }

  void a_second_window_on_a_case_only_looks() {
    const TemporaryFolder folder;
    const fs::path small = test::small_case(folder.path());
    auto first = opened(small);
    QVERIFY(!child_of<QWidget>(*first, "notice")->isVisible());
    const auto second = opened(small);
    const auto* words = child_of<QLabel>(*second, "notice_text");
    QTRY_VERIFY(words->isVisible());
    QVERIFY2(words->text().startsWith("Another window has small.glisson open"), qPrintable(words->text()));
    QVERIFY(!is_reddish(*child_of<QWidget>(*second, "notice")));
    const std::size_t before = test::voxels_of(small, "liver");
    grow_liver(*second);
    QCOMPARE(test::voxels_of(small, "liver"), before);
    grow_liver(*first);
    QVERIFY(test::voxels_of(small, "liver") > before);
    // The first lets go of it: opened anew, the second may change it.
    first->close();
    first.reset();
    open(*second, small);
    const std::size_t grown = test::voxels_of(small, "liver");
    grow_liver(*second);
    QVERIFY(test::voxels_of(small, "liver") > grown);
  }

  void says_at_once_that_the_folder_is_gone() {
    const TemporaryFolder folder;
    const fs::path small = test::small_case(folder.path());
    const auto window = opened(small);
    const auto* words = child_of<QLabel>(*window, "notice_text");
    QVERIFY(!words->isVisible());
    fs::rename(small, folder.path() / "elsewhere.glisson");
    QTRY_VERIFY(words->isVisible());
    QVERIFY(words->text().contains("is gone"));
    QVERIFY(is_reddish(*child_of<QWidget>(*window, "notice")));
  }

  void closing_during_a_build_asks() {
    const TemporaryFolder folder;
    const auto window = opened(test::modelled_case(folder.path()));
    window->go_to("model");
    auto* build = child_of<QPushButton>(*window, "model_build");
    QTRY_VERIFY_WITH_TIMEOUT(build->isEnabled() && build->text() == "Build it anew", patience_ms);
    child_of<QDoubleSpinBox>(*window, "model_target")->setValue(200000);
    QTest::mouseClick(build, Qt::LeftButton);
    QVERIFY(window->work().busy());
    answer(*window, false);
    QVERIFY(!window->close());
    QVERIFY(window->isVisible());
    QVERIFY(window->work().busy());
    answer(*window, true);
    QVERIFY(window->close());
  }

 private:
  static QString translated(const QRect& rect) {
    return QString("%1 x %2 at %3, %4").arg(rect.width()).arg(rect.height()).arg(rect.x()).arg(rect.y());
  }

  static bool is_reddish(QWidget& widget) {
    const QColor ground = widget.grab().toImage().pixelColor(widget.width() - 4, 3);
    return ground.red() > ground.green() + 20 && ground.red() > ground.blue() + 20;
  }

  static void open(MainWindow& window, const fs::path& folder) {
    QSignalSpy finished(&window.work(), &BackgroundWork::finished);
    window.open_path(folder);
    if (finished.empty() && !finished.wait(patience_ms)) qFatal("the case does not open");
    QTest::qWait(50);
  }

  static std::unique_ptr<MainWindow> opened(const fs::path& folder) {
    auto window = shown_window();
    open(*window, folder);
    return window;
  }

  static void grow_liver(MainWindow& window) {
    window.go_to("segment");
    auto* panel = window.findChild<SegmentPanel*>();
    QVERIFY(QTest::qWaitFor([&] { return panel->editor().can_edit(); }, patience_ms));
    panel->editor().apply(GLISSON_TEXT("Margin around {0}"),
                          [](imaging::Mask mask) { return segmentation::with_margin(std::move(mask), 2); });
    QVERIFY(QTest::qWaitFor([&] { return !window.undo().busy(); }, patience_ms));
  }

  // What the question will be answered, once it stands there.
  static void answer(MainWindow& window, bool give_up) {
    auto* timer = new QTimer(&window);
    connect(timer, &QTimer::timeout, &window, [timer, &window, give_up] {
      auto* question = window.findChild<QMessageBox*>("ask_close");
      if (question == nullptr || !question->isVisible()) return;
      timer->deleteLater();
      if (give_up) {
        child_of<QPushButton>(*question, "give_up")->click();
      } else {
        QTest::keyClick(question, Qt::Key_Escape);
      }
    });
    timer->start(20);
  }
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::WindowFrameTest>(argc, argv); }

#include "window_frame_test.moc"
