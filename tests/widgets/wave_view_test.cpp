// The waves of a case, in the window: inverted, seen running, accepted.
//
// The case holds a plane wave of known stiffness, written as its importer leaves it.

#include "widgets/views/wave_view.h"

#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "run_test.h"
#include "shown.h"
#include "wave_case.h"
#include "widgets/views/map_picture.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 60000;  // on a machine that does other work too

class WaveViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    case_ = folder_.path() / "plane.glisson";
    test::write_wave_case(case_);
    view_ = std::make_unique<WaveView>(case_);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  }

  void knows_which_cases_hold_waves() {
    QVERIFY(WaveView::has_waves(case_));
    QVERIFY(!WaveView::has_waves(folder_.path() / "none.glisson"));
  }

  void inverts_at_the_press_of_a_button() {
    QVERIFY(!child<QPushButton>("wave_accept")->isEnabled());
    QSignalSpy inverted(view_.get(), &WaveView::inverted);
    QTest::mouseClick(child<QPushButton>("primary"), Qt::LeftButton);
    QVERIFY(inverted.wait(patience_ms));
    QVERIFY(child<QLabel>("wave_summary")->text().contains("60 Hz"));
    QTRY_VERIFY(child<QPushButton>("wave_accept")->isEnabled());
    // In the middle the stiffness is known, and 4 kPa.
    const QImage& modulus = child<MapPicture>("modulus_picture")->image();
    QCOMPARE(modulus.size(), QSize(48, 48));
    QCOMPARE(qAlpha(modulus.pixel(24, 24)), 255);
  }

  void waves_run_and_come_back_after_a_period() {
    auto* play = child<QPushButton>("wave_play");
    if (!play->isChecked()) play->click();
    const double before = view_->instant();
    QTRY_VERIFY(view_->instant() != before);
    play->click();
    const double stopped = view_->instant();
    const QImage picture = child<MapPicture>("wave_picture")->image();
    QTest::qWait(200);
    QCOMPARE(view_->instant(), stopped);
    play->click();
    QTRY_VERIFY(child<MapPicture>("wave_picture")->image() != picture);
    play->click();
  }

  void shows_other_slices() {
    auto* slice = child<QSlider>("wave_slice");
    QCOMPARE(slice->maximum(), 4);
    const QImage picture = child<MapPicture>("confidence_picture")->image();
    slice->setValue(0);
    QVERIFY(child<MapPicture>("confidence_picture")->image() != picture);
    slice->setValue(2);
  }

  void leaves_the_case_alone_until_it_is_told() {
    QVERIFY(!std::filesystem::exists(case_ / "volumes" / "stiffness.nrrd"));
    QSignalSpy accepted(view_.get(), &WaveView::accepted);
    // A window that only looks at the case takes nothing into it.
    int asked = 0;
    view_->set_guard([&asked] { return ++asked == 0; });
    QTest::mouseClick(child<QPushButton>("wave_accept"), Qt::LeftButton);
    QCOMPARE(asked, 1);
    QTest::qWait(300);
    QCOMPARE(accepted.count(), 0);
    QVERIFY(!std::filesystem::exists(case_ / "volumes" / "stiffness.nrrd"));
    view_->set_guard([] { return true; });
    QTest::mouseClick(child<QPushButton>("wave_accept"), Qt::LeftButton);
    QVERIFY(accepted.wait(patience_ms));
    const auto patient = casefile::Case::open(case_);
    const auto map = patient->volume("volumes/stiffness");
    QVERIFY(map.has_value());
    QVERIFY(std::abs(map->at(24, 24, 2) - 4.0F) < 0.5F);
  }

  void says_what_is_wrong_with_an_answer_that_cannot_be() {
    child<QComboBox>("wave_long_waves")->setCurrentIndex(1);  // the curl, of one direction
    QTest::mouseClick(child<QPushButton>("primary"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("faint")->text().contains("three known directions"), patience_ms);
  }

 private:
  template <typename Widget>
  Widget* child(const char* name) const {
    return child_of<Widget>(*view_, name);
  }

  TemporaryFolder folder_;
  std::filesystem::path case_;
  std::unique_ptr<WaveView> view_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::WaveViewTest>(argc, argv); }

#include "wave_view_test.moc"
