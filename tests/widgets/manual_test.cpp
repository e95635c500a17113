// The manual that ships, in its window: found by F1, searched by words.

#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QtTest>

#include "base/files.h"
#include "main_window.h"
#include "run_test.h"

namespace glisson::widgets {
namespace {

class ManualTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window_));
    window_.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window_));
    QTest::keyClick(&window_, Qt::Key_F1);
    manual_ = window_.findChild<ManualWindow*>();
    QVERIFY(manual_ != nullptr && manual_->isVisible());
  }

  void opens_at_the_first_page() {
    QVERIFY(titles()->count() >= 10);
    QCOMPARE(titles()->item(0)->text(), QString("Getting started"));
    QVERIFY(text()->toPlainText().contains("Not a medical device"));
  }

  void every_page_has_a_title_and_text() {
    for (int row = 0; row < titles()->count(); ++row) {
      titles()->setCurrentRow(row);
      const QString title = titles()->item(row)->text();
      QVERIFY2(!title.isEmpty() && !title.contains('#'), qPrintable(title));
      QVERIFY2(text()->toPlainText().size() > 300, qPrintable(title));
    }
  }

  void finds_the_pages_that_hold_all_the_words_and_marks_the_first() {
    const int all = titles()->count();
    QTest::keyClicks(words(), "retractor FORCE");
    QVERIFY(titles()->count() > 0 && titles()->count() < all);
    for (int row = 0; row < titles()->count(); ++row) {
      titles()->setCurrentRow(row);
      QVERIFY(text()->toPlainText().contains("retractor", Qt::CaseInsensitive));
      QCOMPARE(text()->textCursor().selectedText().toLower(), QString("retractor"));
    }
    words()->clear();
    QCOMPARE(titles()->count(), all);
  }

  void shows_its_pictures_and_no_other_files() {
    int pictures = 0;
    for (int row = 0; row < titles()->count(); ++row) {
      titles()->setCurrentRow(row);
      auto links = QRegularExpression("!\\[[^\\]]*\\]\\(([^)]*)\\)").globalMatch(text()->toMarkdown());
      for (; links.hasNext(); ++pictures) {
        const QString name = links.next().captured(1);
        const auto picture = text()->loadResource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
        QVERIFY2(!picture.isNull(), qPrintable(name));
        QVERIFY(picture.width() <= text()->viewport()->width());
      }
    }
    QVERIFY(pictures >= 9);
    for (const char* elsewhere : {"../icons/open.svg", "file:///etc/hostname", "https://example.org/x.png"})
      QVERIFY(!text()->loadResource(QTextDocument::ImageResource, QUrl(elsewhere)).isValid());
  }

  void says_when_no_page_holds_them() {
    words()->setText("xylophone");
    QCOMPARE(titles()->count(), 0);
    QCOMPARE(text()->toPlainText(), QString("No page holds these words."));
    words()->clear();
  }

  void says_when_the_manual_is_missing() {
    const TemporaryFolder empty;
    const ManualWindow missing(empty.path());
    QVERIFY(missing.findChild<QTextBrowser*>()->toPlainText().contains("not found"));
  }

 private:
  [[nodiscard]] QLineEdit* words() const { return manual_->findChild<QLineEdit*>("manual_words"); }
  [[nodiscard]] QListWidget* titles() const { return manual_->findChild<QListWidget*>("manual_titles"); }
  [[nodiscard]] QTextBrowser* text() const { return manual_->findChild<QTextBrowser*>("manual_text"); }

  MainWindow window_;
  ManualWindow* manual_ = nullptr;
};

}  // namespace
}  // namespace glisson::widgets

int main(int argc, char** argv) { return glisson::widgets::run_test<glisson::widgets::ManualTest>(argc, argv); }

#include "manual_test.moc"
