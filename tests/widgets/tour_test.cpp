// The tour, as a person takes it: by its buttons, through every workspace, on the demo patient. At each stop the window
// is drawn and held against its baseline. Nowhere on the way does its thread compute for longer than 100 ms in one
// piece, which is its longest stall on a machine that does nothing else; where this one is slower at that moment, for
// as many times longer. What it stood still on this one is printed.

#include <QDir>
#include <QImage>
#include <QSignalSpy>
#include <QtTest>
#include <set>

#include "run_test.h"
#include "support/machine_pace.h"
#include "support/tour_picture.h"
#include "widgets/evidence/evidence_view.h"
#include "widgets/main_window.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/views/wave_view.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 240'000;

class TourTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void begins_on_the_demo_patient() {
    window_ = std::make_unique<MainWindow>();
    window_->setFixedSize(1600, 1000);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY(!window_->tour().isVisible());
    window_->stalls().forget();
    window_->findChild<QAction*>("take_tour")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->tour().isVisible(), patience_ms);
    QVERIFY(window_->tour().stops() >= 2);
  }

  void shows_every_workspace() {
    std::set<QString> seen;
    for (int stop = 0; stop < window_->tour().stops(); ++stop) {
      QCOMPARE(window_->tour().stop(), stop);
      settle();
      const QString workspace = window_->workspace();
      seen.insert(workspace);
      const double computing_ms = window_->stalls().longest_computing_ms();
      qInfo("%s: the window stood still for %.0f ms at most, of which it computed %.0f ms at most",
            qPrintable(workspace), window_->stalls().longest_ms(), computing_ms);
      if (computing_ms > StallWatch::noticeable_ms) {
        const double slower = test::times_slower_than_usual();
        const auto words = QString("%1: %2 ms, at %3 times the usual").arg(workspace).arg(computing_ms).arg(slower);
        qInfo("%s", qPrintable(words));
        if (computing_ms > StallWatch::noticeable_ms * slower) stalls_ << words;
      }
      const test::PictureVerdict verdict = test::held_against_baseline(shown(), "tour-" + workspace);
      if (!verdict.alike) pictures_that_differ_ << verdict.words;
      window_->stalls().forget();  // holding pictures against each other is this test's own work
      QTest::mouseClick(window_->findChild<QPushButton*>("tour_next"), Qt::LeftButton);
    }
    QVERIFY2(stalls_.isEmpty(), qPrintable(stalls_.join(", ")));
    QCOMPARE(static_cast<int>(seen.size()), window_->tour().stops());
    QVERIFY(!window_->tour().isVisible());  // the last button ends it
    QVERIFY2(pictures_that_differ_.isEmpty(), qPrintable(pictures_that_differ_.join('\n')));
  }

  // Its picture stands in the manual.
  void shows_the_waves_of_its_patient() {
    for (QAction* action : window_->findChildren<QAction*>()) {
      if (action->shortcut() == QKeySequence("Ctrl+W")) action->trigger();
    }
    auto* waves = window_->findChild<WaveView*>();
    QVERIFY(waves != nullptr);
    waves->setFixedSize(1280, 720);
    QSignalSpy inverted(waves, &WaveView::inverted);
    waves->invert();
    QVERIFY(inverted.wait(patience_ms));
    auto* play = waves->findChild<QPushButton*>("wave_play");
    if (!play->isChecked()) play->click();
    while (waves->instant() > 0.01 && waves->instant() < 0.99) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    play->click();
    QTest::qWait(100);  // words find their room
    const QImage picture = waves->grab().toImage().convertToFormat(QImage::Format_RGB888);
    const test::PictureVerdict verdict = test::held_against_baseline(picture, "wave-window");
    QVERIFY2(verdict.alike, qPrintable(verdict.words));
    waves->close();
  }

  void goes_back_and_ends_by_keys() {
    window_->take_tour();  // at once: the patient is open
    QVERIFY(window_->tour().isVisible());
    auto* next = window_->findChild<QPushButton*>("tour_next");
    auto* back = window_->findChild<QPushButton*>("tour_back");
    QVERIFY(!back->isEnabled());
    const QString first = window_->workspace();
    QTest::keyClick(next, Qt::Key_Space);
    QVERIFY(window_->workspace() != first);
    QTest::keyClick(back, Qt::Key_Space);
    QCOMPARE(window_->workspace(), first);
    QTest::keyClick(window_->findChild<QPushButton*>("tour_end"), Qt::Key_Space);
    QVERIFY(!window_->tour().isVisible());
  }

  // Register computes for most of a minute; who does not wait for it sees Evidence's example all the same.
  void evidence_runs_its_example_for_an_impatient_person_too() {
    window_ = std::make_unique<MainWindow>();  // whose Register has computed nothing yet
    window_->show();
    window_->take_tour();
    QTRY_VERIFY_WITH_TIMEOUT(window_->tour().isVisible(), patience_ms);
    bool computed = false;
    while (window_->workspace() != "evidence") {
      if (window_->workspace() == "register") QTRY_VERIFY_WITH_TIMEOUT(window_->work().busy(), patience_ms);
      computed = computed || window_->workspace() == "register";
      QTest::mouseClick(window_->findChild<QPushButton*>("tour_next"), Qt::LeftButton);
    }
    QVERIFY(computed);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<EvidenceView*>()->record() != nullptr, patience_ms);
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  // Until nothing is computed any more and what was computed is drawn.
  void settle() {
    QTest::qWait(400);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().solving() != Solving::solving, patience_ms);
    const auto* resect = window_->findChild<ResectPanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!resect->by_anatomy().live().opening(), patience_ms);
    QTest::qWait(600);
  }

  // With each view as it is now, however long its drawing takes.
  QImage shown() {
    LinkedViews& views = window_->views();
    if (views.space().isVisible()) (void)views.space().picture();
    for (SliceView* slice : views.slices()) {
      if (slice->isVisible()) (void)slice->picture();
    }
    return window_->grab().toImage().convertToFormat(QImage::Format_RGB888);
  }

  std::unique_ptr<MainWindow> window_;
  QStringList pictures_that_differ_;
  QStringList stalls_;  // longer than a hand on the mouse notices
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::TourTest>(argc, argv); }

#include "tour_test.moc"
