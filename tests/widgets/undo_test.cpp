// Undo as a person meets it: Ctrl+Z and the Edit menu, with the name of what is undone, also after a case was closed.

#include <QMenuBar>
#include <QSignalSpy>
#include <QtTest>

#include "base/files.h"
#include "modelled_case.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 20000;

class UndoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::small_case(temporary_.path());
    open_window();
  }

  void names_in_the_menu_what_it_undoes_and_undoes_it_by_key() {
    window_->undo().change({"Brush on {0}", {"liver"}}, {"labels/liver"},
                           [this] { return test::save_ball(folder_, "liver", 14); });
    settle();
    QCOMPARE(window_->undo().undo_action()->text(), "&Undo: Brush on Liver");
    QVERIFY(menu_has(window_->undo().undo_action()));
    const std::size_t grown = test::voxels_of(folder_, "liver");
    QVERIFY(grown > start_);
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    settle();
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
    QVERIFY(!window_->undo().undo_action()->isEnabled());
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    settle();
    QCOMPARE(test::voxels_of(folder_, "liver"), grown);
  }

  void undoes_after_the_case_was_closed_and_opened_again() {
    window_.reset();
    open_window();
    QCOMPARE(window_->undo().undo_action()->text(), "&Undo: Brush on Liver");
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    settle();
    QCOMPARE(test::voxels_of(folder_, "liver"), start_);
  }

  void keeps_small_values_of_workspaces_and_gives_them_back() {
    QJsonValue seen;
    window_->undo().keep("test/force", [&](const QJsonValue& now) { seen = now; });
    window_->undo().value_changed({"Force", {}}, "test/force", 1.0, 2.0, Undo::Joins::with_same);
    window_->undo().value_changed({"Force", {}}, "test/force", 2.0, 3.5, Undo::Joins::with_same);
    settle();
    press_key(*window_, Qt::Key_Z, Qt::ControlModifier);
    settle();
    QCOMPARE(seen.toDouble(), 1.0);
    window_->undo().redo();
    settle();
    QCOMPARE(seen.toDouble(), 3.5);
  }

  // Two tools, the second moved; each step goes back and forth again, also where one tool is left.
  void gives_several_rigid_tools_back() {
    window_.reset();
    folder_ = test::modelled_case(modelled_.path());
    open_window();
    window_->go_to("rehearse");
    LiveRehearsal& rehearsal = window_->rehearsal();
    QVERIFY(rehearsal.knows_rigid_tools());
    rehearsal.set_touch(Touch::rigid);
    const auto on_surface = [&](const Eigen::Vector3d& outward) {
      const Eigen::Vector3d middle_mm = test::small_middle_mm();
      return PlacedTool{"palpation-probe", middle_mm + 12 * outward, outward, 4, -outward, 0.05};
    };
    const PlacedTool first = on_surface({0, -1, 0}), second = on_surface({1, 0, 0});
    PlacedTool pressed = second;
    pressed.force_N = 0.08;
    using Tools = std::vector<PlacedTool>;
    const auto becomes = [&](const Tools& wanted) {
      if (!QTest::qWaitFor([&] { return rehearsal.tools() == wanted && rehearsal.solving() != Solving::solving; },
                           patience_ms)) {
        return false;
      }
      QTest::qWait(600);  // a rest makes a step of it
      settle();
      return true;
    };
    rehearsal.hold(first);
    QVERIFY(becomes({first}));
    rehearsal.keep_tool();
    rehearsal.hold(second);
    QVERIFY(becomes({first, second}));
    rehearsal.set_force_N(0.08);
    QVERIFY(becomes({first, pressed}));
    QCOMPARE(window_->undo().undo_action()->text(), "&Undo: Change the force");
    window_->undo().undo();
    QVERIFY(becomes({first, second}));
    QCOMPARE(window_->undo().undo_action()->text(), "&Undo: Place another tool");
    window_->undo().undo();
    QVERIFY(becomes({first}));
    window_->undo().redo();
    QVERIFY(becomes({first, second}));
    window_->undo().redo();
    QVERIFY(becomes({first, pressed}));
    QCOMPARE(rehearsal.touch(), Touch::rigid);
    // Large deformations are a step as well.
    rehearsal.set_deformations(Deformations::large);
    QVERIFY(becomes({first, pressed}));
    QTRY_COMPARE_WITH_TIMEOUT(window_->undo().undo_action()->text(), "&Undo: Small or large deformations", patience_ms);
    window_->undo().undo();
    QVERIFY(becomes({first, pressed}));
    QCOMPARE(rehearsal.deformations(), Deformations::small);
    window_->undo().redo();
    QVERIFY(becomes({first, pressed}));
    QCOMPARE(rehearsal.deformations(), Deformations::large);
    QCOMPARE(rehearsal.touch(), Touch::rigid);
  }

 private:
  void open_window() {
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->open_path(folder_);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
    start_ = test::voxels_of(folder_, "liver");
    if (first_ == 0) first_ = start_;
    start_ = first_;
  }
  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
  }
  bool menu_has(QAction* action) {
    for (QAction* menu : window_->menuBar()->actions()) {
      if (menu->menu() != nullptr && menu->menu()->actions().contains(action)) return true;
    }
    return false;
  }

  TemporaryFolder temporary_, modelled_;
  std::filesystem::path folder_;
  std::size_t start_ = 0, first_ = 0;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::UndoTest>(argc, argv); }

#include "undo_test.moc"
