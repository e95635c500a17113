// A liver in motion in the window: chosen by its name, it swings when it is let go and comes to rest, and its steps are
// those of the session without a window.

#include <QComboBox>
#include <QPushButton>
#include <QtTest>

#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/rehearse_panel.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

class RehearseMotionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }
  void init() { show_probe_on_block(*window_); }

  void moves_until_it_rests_where_the_liver_at_rest_does() {
    const double at_rest_mm = rehearsal_at_rest_mm();
    choose_motion();
    QCOMPARE(rehearsal().touch(), Touch::rigid);
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().contact() != nullptr && rehearsal().contact()->motion.has_value(),
                             patience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(sign(), "◐ Moving", patience_ms);
    window_->grab().save(test::kept_picture("rehearse-motion.png"));
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY2(why().contains("come to rest") && why().contains("elastic"), qPrintable(why()));
    QVERIFY(std::abs(rehearsal().contact()->patient.max_displacement_mm - at_rest_mm) < 0.1);
    choose_language("de");
    QTest::qWait(100);
    const QString in_german = why();
    choose_language("en");
    QVERIFY2(in_german.contains("zur Ruhe gekommen"), qPrintable(in_german));
    QVERIFY(!child<QPushButton>("keep_order")->isEnabled());
  }

  // What is let go is seen to come back; then there is nothing to show.
  void comes_back_when_the_tool_is_taken_away() {
    choose_motion();
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    const double held_mm = rehearsal().state()->patient.max_displacement_mm;
    const std::size_t moments = rehearsal().track().moments().size();
    rehearsal().take_tool_away();
    QVERIFY(rehearsal().state().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal().track().moments().size() > moments + 3, patience_ms);
    QVERIFY(rehearsal().track().moments().back().max_displacement_mm < held_mm);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::no_tool, patience_ms);
    QVERIFY(!rehearsal().state().has_value());
    auto engine =
        rehearsal::SessionEngine::create(rehearsal::in_motion(own_setup(), rehearsal::step_in_the_hand_s)).value();
    QVERIFY(!rehearsal::replay(engine, rehearsal().recording()).has_value());
  }

  void ends_where_a_tool_spreads_its_force() {
    choose_motion();
    rehearsal().set_touch(Touch::patch);
    QCOMPARE(rehearsal().deformations(), Deformations::small);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
  }

 private:
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }
  QString why() { return child<QLabel>("deformations_why")->text(); }
  QString sign() { return child<QLabel>("solving_sign")->text(); }
  static rehearsal::RehearsalSetup own_setup() { return *block_with_a_tumour().rehearsal_setup; }
  double rehearsal_at_rest_mm() {
    auto engine = rehearsal::SessionEngine::create(own_setup()).value();
    const auto hand = contact_tool(rehearsal().tools().back(), "tool", Touch::rigid).value();
    return engine.step(rehearsal::HoldTool{hand}).patient.max_displacement_mm;
  }
  void choose_motion() {
    auto* choice = child<QComboBox>("deformations");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_End);
    QCOMPARE(rehearsal().deformations(), Deformations::moving);
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::RehearseMotionTest>(argc, argv); }

#include "rehearse_motion_test.moc"
