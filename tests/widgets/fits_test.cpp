// Every workspace at the sizes that screens have, in English and in German, the longest of the languages: nothing is
// cut off and nothing lies beyond the window. CTest runs it a second time at twice the resolution, where 1280 x 720 is
// a screen of 2560 x 1440. The pictures are kept in build/PRESET/pictures/fits-...

#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "fits.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 60000;

class FitsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_ = shown_window({1280, 720});
    QCOMPARE(window_->minimumSize().boundedTo({1280, 720}), window_->minimumSize());
  }

  void the_first_page_data() { sizes(); }
  void the_first_page() { look("start"); }

  void a_case_is_open() {
    window_->open_path(test::modelled_case(folder_.path()));
    QTRY_VERIFY_WITH_TIMEOUT(window_->rehearsal().body() != nullptr && !window_->work().busy(), patience_ms);
    window_->go_to("rehearse");
    QSignalSpy placed(&window_->rehearsal(), &LiveRehearsal::placed);
    child_of<QPushButton>(*window_, "hoist")->click();
    QVERIFY(placed.wait(patience_ms));
    window_->go_to("resect");
    child_of<QPushButton>(*window_, "cut_through_crosshair")->click();
    QTRY_VERIFY_WITH_TIMEOUT(child_of<QLabel>(*window_, "remnant_volume")->text().contains("ml"), patience_ms);
  }

  void each_workspace_data() { sizes(); }
  void each_workspace() {
    for (const char* workspace : {"study", "segment", "model", "rehearse", "resect", "report", "guide", "register",
                                  "platform", "evidence", "studies"}) {
      window_->go_to(workspace);
      look(workspace);
    }
  }

  void shuts_down_cleanly() { window_.reset(); }

 private:
  static void sizes() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("language");
    const bool fine = qApp->devicePixelRatio() > 1;
    for (const QSize& size : fine ? std::vector<QSize>{{1280, 720}} : std::vector<QSize>{{1280, 720}, {1600, 1000}}) {
      for (const char* language : {"en", "de"}) {
        const QString row = QString("%1x%2-%3").arg(size.width()).arg(size.height()).arg(language);
        QTest::newRow(qPrintable(row)) << size << QString(language);
      }
    }
  }

  void look(const char* what) {
    QFETCH(QSize, size);
    QFETCH(QString, language);
    choose_language(language);
    window_->resize(size);
    QTest::qWait(200);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    QTest::qWait(300);
    const QSize least = window_->minimumSizeHint();
    if (window_->size() != size) qWarning("least %d x %d", least.width(), least.height());
    QCOMPARE(window_->size(), size);  // it needs no more
    LinkedViews& views = window_->views();
    if (views.space().isVisible()) (void)views.space().picture();
    const QString scale = qApp->devicePixelRatio() > 1 ? "-twice" : "";
    const QString file = QString("/fits-%1-%2%3.png").arg(QTest::currentDataTag(), what, scale);
    QVERIFY(window_->grab().save(glisson::test::kept_pictures() + file));
    const int slice_px = views.slice(SliceDirection::transverse).width();
    if (views.space().isVisible()) {  // four views of one size
      QVERIFY2(std::abs(views.space().width() - slice_px) < 10,
               qPrintable(QString("%1 and %2 px").arg(slice_px).arg(views.space().width())));
    }
    const QStringList problems = test::what_does_not_fit(*window_);
    for (const QString& problem : problems) qWarning("%s: %s", what, qPrintable(problem));
    if (!problems.isEmpty())
      QTest::qFail(qPrintable(QString("%1: %2").arg(what, problems.front())), __FILE__, __LINE__);
  }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::FitsTest>(argc, argv); }

#include "fits_test.moc"
