// The manual that ships, in its window: found by F1, searched by words, in the language of the window. The pages of all
// languages say the same: as many headings, pictures, list items and rows, and the same commands.

#include <filesystem>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QtTest>

#include "base/files.h"
#include "run_test.h"
#include "shown.h"
#include "support/folders.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

const fs::path manual_folder = glisson::test::source_folder() / "resources" / "manual";

QString text_in(const fs::path& page) {
  QFile file(text_of(page));
  if (!file.open(QIODevice::ReadOnly)) qFatal("there is no %s", qPrintable(file.fileName()));
  return QString::fromUtf8(file.readAll());
}

QStringList all_of(const QString& pattern, const QString& text) {
  QStringList found;
  for (auto match = QRegularExpression(pattern, QRegularExpression::MultilineOption).globalMatch(text);
       match.hasNext();)
    found << match.next().captured(1);
  return found;
}

QStringList links_of(const QString& text) { return all_of(R"(\]\(([^)]*)\))", text); }

// What a page is made of, in whatever language: its headings, list items, rows and cells in their order; its pictures
// and what stands in `code`.
QStringList bones_of(const QString& text) {
  QStringList code = all_of("`([^`]*)`", text);
  code.sort();  // sentences have their own order of words
  QStringList pictures;
  for (const QString& link : links_of(text)) pictures << link.section('/', -1);
  return all_of(R"(^(#+ |- |\d+\. |\|))", text) + pictures + code << QString::number(text.count('|'));
}

class ManualTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    window_.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window_));
    press_key(window_, Qt::Key_F1);
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
    for (const char* elsewhere :
         {"../icons/open.svg", "../../icons/open.svg", "file:///etc/hostname", "https://example.org/x.png"})
      QVERIFY(!text()->loadResource(QTextDocument::ImageResource, QUrl(elsewhere)).isValid());
  }

  void every_page_says_the_same_in_every_language_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"de", "fr", "es"}) QTest::newRow(language) << QString(language);
  }

  void every_page_says_the_same_in_every_language() {
    QFETCH(QString, language);
    int pages = 0;
    for (const auto& entry : fs::directory_iterator(manual_folder / path_of(language))) {
      QVERIFY2(fs::exists(manual_folder / entry.path().filename()), entry.path().c_str());
      ++pages;
    }
    QCOMPARE(pages, titles()->count());
    for (const auto& english : fs::directory_iterator(manual_folder)) {
      if (!english.is_regular_file()) continue;
      const fs::path page = manual_folder / path_of(language) / english.path().filename();
      const QString text = text_in(page);
      const QStringList bones = bones_of(text), expected = bones_of(text_in(english.path()));
      for (qsizetype n = 0; n < std::min(bones.size(), expected.size()); ++n)
        QVERIFY2(bones[n] == expected[n], qPrintable(text_of(page) + ": " + bones[n] + ", not " + expected[n]));
      QCOMPARE(bones.size(), expected.size());
      for (const QString& link : links_of(text))
        QVERIFY2(fs::exists(page.parent_path() / path_of(link)), qPrintable(text_of(page) + ": " + link));
    }
  }

  void follows_the_language_and_stays_at_the_page() {
    const int page = 5;
    titles()->setCurrentRow(page);
    const QString english = text()->toPlainText();
    choose("de");
    QCOMPARE(titles()->currentRow(), page);
    QCOMPARE(titles()->currentItem()->text(), QString("Eine Resektion planen"));
    QVERIFY(text()->toPlainText().startsWith("Eine Resektion planen"));
    shows_its_pictures_and_no_other_files();
    titles()->setCurrentRow(page);
    choose("en");
    QCOMPARE(titles()->currentRow(), page);
    QCOMPARE(text()->toPlainText(), english);
  }

  void keeps_the_search_and_the_page_that_is_read() {
    words()->setText("SIRGn");
    QCOMPARE(titles()->count(), 1);
    choose("fr");
    QCOMPARE(words()->text(), QString("SIRGn"));
    QCOMPARE(titles()->currentItem()->text(), QString("Juger le recalage d’une vidéo"));
    QCOMPARE(text()->textCursor().selectedText(), QString("SIRGn"));
    words()->setText("recalage");
    choose("es");  // where no page holds it
    QCOMPARE(titles()->count(), 0);
    QVERIFY(text()->toPlainText().startsWith("Juzgar registros de vídeo"));
    words()->clear();
    choose("en");
    QVERIFY(titles()->count() >= 10);
  }

  void finds_words_whatever_their_accents_and_case() {
    choose("fr");
    for (const QString& typed : {QString("deformation"), QString("DÉFORMATION"), QString("de\u0301formation")}) {
      words()->setText(typed);
      QVERIFY2(titles()->count() > 0 && titles()->count() < 10, qPrintable(typed));
      QCOMPARE(text()->textCursor().selectedText(), QString("déformation"));
    }
    words()->setText("l'ecarteur");
    QCOMPARE(text()->textCursor().selectedText().toLower(), QString("l’écarteur"));
    choose("de");
    words()->setText("flache");
    QCOMPARE(text()->textCursor().selectedText().toLower(), QString("fläche"));
    words()->clear();
    choose("en");
  }

  void shows_a_page_in_english_that_its_language_lacks() {
    const TemporaryFolder some;
    fs::create_directory(some.path() / "de");
    for (const char* name : {"01-a.md", "02-b.md"}) fs::copy_file(manual_folder / "12-limits.md", some.path() / name);
    fs::copy_file(manual_folder / "de" / "12-limits.md", some.path() / "de" / "02-b.md");
    choose("de");
    const ManualWindow manual(some.path());
    const auto* pages = manual.findChild<QListWidget*>("manual_titles");
    QCOMPARE(pages->item(0)->text(), QString("What to believe, and what not"));
    QCOMPARE(pages->item(1)->text(), QString("Was zu glauben ist und was nicht"));
    choose("en");
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
  void choose(const QString& language) {
    choose_language(language);
    QCoreApplication::sendPostedEvents();
    QTest::qWait(20);
  }

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
