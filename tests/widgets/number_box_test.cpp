// Numbers as they are typed: no digit is lost above the limit, and the box that holds back says so.

#include <QToolTip>
#include <QtTest>

#include "block_patient.h"
#include "run_test.h"
#include "shown.h"
#include "widgets/main_window.h"
#include "widgets/settings/settings_window.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {
namespace {

class NumberBoxTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // With the probe, whose slider ends at 3 N.
  void initTestCase() {
    window_ = shown_window();
    window_->show_patient(block_patient({6, 4, 4}, {{"tumour-1", {100, 40, 40}}}, {}));
    window_->go_to("rehearse");
    auto* tool = child_of<QComboBox>(*window_, "tool");
    tool->setFocus();
    QTest::keyClick(tool, Qt::Key_End);
    force_ = child_of<NumberBox>(*window_, "force");
    QCOMPARE(force_->maximum(), 3.0);
  }

  void init() {
    force_->setValue(1.0);
    QToolTip::hideText();
    QTRY_VERIFY(!QToolTip::isVisible());
  }

  void holds_back_at_the_maximum_and_says_so_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed : {"12", "25", "1e9", "3,1"}) QTest::newRow(typed) << typed;
  }
  void holds_back_at_the_maximum_and_says_so() {
    QFETCH(QString, typed);
    begin();
    QTest::keyClicks(force_, typed);
    QCOMPARE(force_->text().left(typed.size()), QString(typed).replace(',', '.'));  // nothing is swallowed
    QCOMPARE(force_->value(), 1.0);
    QTest::keyClick(force_, Qt::Key_Return);
    QCOMPARE(force_->value(), 3.0);
    QCOMPARE(force_->text(), "3.0 N");
    QCOMPARE(window_->rehearsal().force_N(), 3.0);
    QTRY_COMPARE(QToolTip::text(), "At most 3.0 N.");
  }

  void says_so_too_when_the_hand_goes_on_to_another_control() {
    begin();
    QTest::keyClicks(force_, "-2");
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(force_, Qt::Key_Tab);
    QCOMPARE(force_->value(), 0.0);
    QTRY_COMPARE(QToolTip::text(), "At least 0.0 N.");
  }

  void takes_what_lies_within_without_a_word() {
    for (const char* typed : {"2.5", "2,5", "2.5 N", "2,46"}) {
      begin();
      QTest::keyClicks(force_, typed);
      QTest::keyClick(force_, Qt::Key_Return);
      QCOMPARE(force_->value(), 2.5);
      QCOMPARE(force_->text(), "2.5 N");
    }
    QTest::qWait(50);
    QVERIFY(!QToolTip::isVisible());
  }

  void goes_back_to_the_number_before_what_is_none() {
    begin();
    QTest::keyClicks(force_, "x-");
    QTest::keyClick(force_, Qt::Key_Return);
    QCOMPARE(force_->value(), 1.0);
    QCOMPARE(force_->text(), "1.0 N");
  }

  void every_box_for_a_number_is_one() {
    SettingsWindow settings;
    int boxes = 0;
    for (const QWidget* window : std::initializer_list<const QWidget*>{window_.get(), &settings}) {
      for (const auto* box : window->findChildren<QAbstractSpinBox*>()) {
        QVERIFY2(qobject_cast<const NumberBox*>(box) != nullptr, qPrintable(box->objectName()));
        ++boxes;
      }
    }
    QVERIFY(boxes > 10);
  }

  void a_word_may_stand_for_the_least() {
    NumberBox box;
    box.setDecimals(0);
    box.setRange(0, 8);
    box.setSpecialValueText("All");
    QCOMPARE(box.text(), "All");
    box.selectAll();
    QTest::keyClicks(&box, "9");
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 8.0);
    box.setValue(0);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), "All");
  }

  void cleanupTestCase() { window_.reset(); }

 private:
  void begin() {
    force_->setFocus();
    force_->selectAll();
  }

  std::unique_ptr<MainWindow> window_;
  NumberBox* force_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::NumberBoxTest>(argc, argv); }

#include "number_box_test.moc"
