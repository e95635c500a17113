// Orders of steps as a surgeon keeps them: two pushes under two names, put side by side, in the report, and undone.

#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QToolButton>
#include <QtTest>

#include "base/files.h"
#include "kept_pictures.h"
#include "modelled_case.h"
#include "report/html.h"
#include "report/patient_page.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/rehearse/rehearse_panel.h"

namespace glisson::widgets {
namespace {

constexpr int patience_ms = 60000;

class KeptOrdersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    folder_ = test::modelled_case(temporary_.path());
    window_ = shown_window({1400, 950});
    window_->open_path(folder_);
    settle();
    window_->go_to("rehearse");
  }

  void are_offered_where_steps_are_recorded() {
    QVERIFY(!fold()->isVisible());
    window_->rehearsal().set_touch(Touch::rigid);
    push(0.02);
    QVERIFY(fold()->isVisible());
    fold()->click();
    QTRY_VERIFY(child<QPushButton>("keep_order")->isVisible());
  }

  void are_kept_under_names_and_compared_by_what_they_ask() {
    keep("Gently");
    push(0.05);
    keep("Hard");
    QCOMPARE(table()->rowCount(), 2);
    QCOMPARE(text(0, KeptOrders::name_column), QString("Gently"));
    QCOMPARE(text(1, KeptOrders::force_column), QString("–"));
    press("compare_orders");
    settle();
    QTRY_VERIFY_WITH_TIMEOUT(text(1, KeptOrders::force_column) != "–", patience_ms);
    // Along the push, and what the skin pulls sideways.
    for (const auto& [row, pushed_N] : {std::pair{0, 0.02}, std::pair{1, 0.05}}) {
      const double force_N = text(row, KeptOrders::force_column).toDouble();
      QVERIFY2(force_N >= 0.99 * pushed_N && force_N < 1.3 * pushed_N, qPrintable(text(row, KeptOrders::force_column)));
    }
    QVERIFY(text(1, KeptOrders::strain_column).toDouble() >= text(0, KeptOrders::strain_column).toDouble());
    window_->findChild<RehearsePanel*>()->findChild<QScrollArea*>()->ensureWidgetVisible(
        child<QPushButton>("drop_order"));
    QTest::qWait(100);
    window_->grab().save(glisson::test::kept_picture("rehearse-orders.png"));
  }

  void stand_in_the_report() {
    const auto patient = casefile::Case::open(folder_);
    const auto page = report::patient_page(patient.value(), {});
    QVERIFY(page.has_value());
    const std::filesystem::path file = temporary_.path() / "report.html";
    QVERIFY(report::write_html(file, *page).has_value());
    const QString html = QString::fromStdString(read_text_file(file, 1 << 24).value());
    QVERIFY(html.contains("What each order asks of the liver at its worst"));
    QVERIFY(html.contains("Gently") && html.contains("Hard"));
  }

  void come_back_when_dropping_is_undone() {
    table()->selectRow(0);
    press("drop_order");
    settle();
    QTRY_COMPARE(table()->rowCount(), 1);
    QCOMPARE(text(0, KeptOrders::force_column), QString("–"));  // the comparison went with it
    QCOMPARE(window_->undo().undo_action()->text(), "&Undo: Drop the steps Gently");
    window_->undo().undo();
    settle();
    QTRY_COMPARE(table()->rowCount(), 2);
    QVERIFY(text(0, KeptOrders::force_column) != "–");
  }

 private:
  template <typename Widget>
  Widget* child(const char* name) {
    return child_of<Widget>(*window_, name);
  }
  QToolButton* fold() { return child<QToolButton>("orders_fold"); }
  QTableWidget* table() { return child<QTableWidget>("orders"); }
  QString text(int row, int column) { return table()->item(row, column)->text(); }
  void press(const char* name) {
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>(name)->isEnabled(), patience_ms);
    child<QPushButton>(name)->click();
  }
  void push(double force_N) {
    LiveRehearsal& rehearsal = window_->rehearsal();
    rehearsal.hold(
        {"palpation-probe", test::small_middle_mm() + Eigen::Vector3d(0, -12, 0), {0, -1, 0}, 4, {0, 1, 0}, force_N});
    QTRY_VERIFY_WITH_TIMEOUT(rehearsal.solving() == Solving::solved && rehearsal.state() &&
                                 rehearsal.state()->force_N.norm() > 0.99 * force_N,
                             patience_ms);
    QTest::qWait(600);  // a rest makes a step of undo of it
    settle();
  }
  void keep(const char* name) {
    child<QLineEdit>("order_name")->setText(name);
    press("keep_order");
    settle();
  }
  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->undo().busy(), patience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->work().busy(), patience_ms);
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::KeptOrdersTest>(argc, argv); }

#include "kept_orders_test.moc"
