// The meshfree engine in the hand: chosen in the window, under rigid tools, with finite elements beside it that say
// what it misses.

#include <QComboBox>
#include <QtTest>

#include "kept_pictures.h"
#include "probe_on_block.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/rehearse_panel.h"
#include "widgets/words/language.h"

namespace glisson::widgets {
namespace {

class RehearseMeshfreeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { window_ = shown_window({1400, 950}); }
  void init() { show_probe_on_block(*window_); }

  void is_chosen_by_its_name_and_says_what_it_costs_and_misses() {
    choose_meshfree();
    QCOMPARE(rehearsal().touch(), Touch::rigid);
    QVERIFY(rehearsal().contact() != nullptr);
    const auto& beside = rehearsal().contact()->beside_elements;
    QVERIFY(beside.has_value());
    // 16 nodes on a block of 175 points miss something, and not all.
    QVERIFY2(beside->landmarks_mm > 0.01 && beside->landmarks_mm < 5,
             qPrintable(QString::number(beside->landmarks_mm)));
    const QString told = child<QLabel>("deformations_why")->text();
    QVERIFY2(told.contains(QString::number(beside->landmarks_mm, 'f', 1) + " mm apart"), qPrintable(told));
    QVERIFY2(told.contains("finite elements"), qPrintable(told));
    window_->grab().save(test::kept_picture("rehearse-meshfree.png"));
    choose_language("de");
    QTest::qWait(100);
    const QString in_german = child<QLabel>("deformations_why")->text();
    window_->grab().save(test::kept_picture("rehearse-meshfree-de.png"));
    choose_language("en");
    QVERIFY2(in_german.contains("finite Elemente"), qPrintable(in_german));
    // Orders of steps are run again by finite elements.
    QVERIFY(!child<QPushButton>("keep_order")->isEnabled());
  }

  // The same as a session without the window, to the bit; and what stands beside it is the other engine's own answer.
  void gives_the_states_of_the_session_and_those_of_finite_elements() {
    choose_meshfree();
    auto engine = rehearsal::SessionEngine::create(rehearsal::by_meshfree(own_setup(), {})).value();
    auto elements = rehearsal::SessionEngine::create(own_setup()).value();
    for (const auto& [command, digest] : rehearsal().recording()) {
      engine.step(command);
      elements.step(command);
    }
    const rehearsal::SessionState& shown = *rehearsal().contact();
    QCOMPARE(engine.state().digest, shown.digest);
    double apart_mm = 0;
    for (std::size_t l = 0; l < shown.patient.landmarks.size(); ++l) {
      apart_mm = std::max(
          apart_mm,
          (shown.patient.landmarks[l].displaced_mm - elements.state().patient.landmarks[l].displaced_mm).norm());
    }
    QVERIFY(std::abs(apart_mm - shown.beside_elements->landmarks_mm) < 1e-9);
  }

  // A tool that is no solid again, and small deformations by finite elements with it.
  void ends_where_a_tool_spreads_its_force() {
    choose_meshfree();
    rehearsal().set_touch(Touch::patch);
    QCOMPARE(rehearsal().deformations(), Deformations::small);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
    QVERIFY(child<QLabel>("deformations_why")->text().contains("Small deformations"));
  }

 private:
  LiveRehearsal& rehearsal() { return window_->rehearsal(); }
  static rehearsal::RehearsalSetup own_setup() { return *block_with_a_tumour().rehearsal_setup; }
  void choose_meshfree() {
    auto* choice = child<QComboBox>("deformations");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    QCOMPARE(rehearsal().deformations(), Deformations::meshfree);
    QTRY_COMPARE_WITH_TIMEOUT(rehearsal().solving(), Solving::solved, patience_ms);
  }
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) {
  return glisson::widgets::run_test<glisson::widgets::RehearseMeshfreeTest>(argc, argv);
}

#include "rehearse_meshfree_test.moc"
