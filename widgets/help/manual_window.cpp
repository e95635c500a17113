#include "widgets/help/manual_window.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QTextCursor>
#include <QUrl>
#include <QVBoxLayout>

#include "base/files.h"
#include "base/folder_contents.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/language.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace fs = std::filesystem;
namespace {

constexpr int page_margin_px = 24;

std::vector<fs::path> page_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& file : contents_of(folder)) {
    if (file.extension() == ".md") files.push_back(file);
  }
  return files;
}

// Without case and accents ("Déformation": "deformation"), letter by letter, so that every place stays where it is.
QString plain_text(const QString& text) {
  QString letters = text.normalized(QString::NormalizationForm_C);
  for (QChar& letter : letters) {
    if (letter.decompositionTag() == QChar::Canonical) letter = letter.decomposition().front();
    letter = letter == u'\u2019' ? QChar(u'\'') : letter.toCaseFolded();
  }
  return letters;
}

bool holds_all(const QString& text, const QStringList& words) {
  const QString letters = plain_text(text);
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return letters.contains(plain_text(word)); });
}

}  // namespace

// A page with its pictures, as wide as the page is at most; they come from the manual's folder and nowhere else.
class PageText : public QTextBrowser {
 public:
  explicit PageText(const fs::path& folder) : folder_(folder.lexically_normal()), beside_(folder_) {}

  void show_page(const fs::path& file, const QString& markdown) {
    beside_ = file.parent_path();
    setMarkdown(markdown);
  }

  void mark(const QString& word) {
    const QString letters = plain_text(word);
    const qsizetype at = plain_text(toPlainText()).indexOf(letters);
    if (at < 0) return;
    QTextCursor found(document());
    found.setPosition(static_cast<int>(at));
    found.setPosition(static_cast<int>(at + letters.size()), QTextCursor::KeepAnchor);
    setTextCursor(found);
  }

  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource || !name.isRelative()) return {};
    const fs::path file = (beside_ / path_of(name.path())).lexically_normal();
    if (*file.lexically_relative(folder_).begin() == "..") return {};
    const QImage picture(text_of(file));
    if (picture.isNull()) return {};
    const int room = viewport()->width() - 2 * page_margin_px;
    return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation) : picture;
  }

 private:
  fs::path folder_, beside_;
};

ManualWindow::ManualWindow(const fs::path& folder, QWidget* parent) : QWidget(parent, Qt::Window), folder_(folder) {
  words_ = new QLineEdit;
  words_->setObjectName("manual_words");
  words_->setClearButtonEnabled(true);
  titles_ = new QListWidget;
  titles_->setObjectName("manual_titles");
  titles_->setSpacing(3);
  titles_->setWordWrap(true);
  text_ = new PageText(folder);
  text_->setObjectName("manual_text");
  text_->setOpenLinks(false);  // it opens nothing that is not its own
  text_->document()->setDocumentMargin(page_margin_px);

  auto* left = new QVBoxLayout;
  left->addWidget(words_);
  left->addWidget(titles_, 1);
  auto* row = new QHBoxLayout(this);
  row->addLayout(left, 2);
  row->addWidget(text_, 5);
  resize(1000, 700);

  connect(words_, &QLineEdit::textChanged, this, &ManualWindow::search);
  connect(titles_, &QListWidget::currentRowChanged, this, &ManualWindow::show_row);
  keep_translated(this, [this] {
    setWindowTitle(tr("Manual - Glisson"));
    words_->setPlaceholderText(tr("Search the manual"));
    words_->setAccessibleName(tr("Words to search for"));
    titles_->setAccessibleName(tr("Pages of the manual"));
    text_->setAccessibleName(tr("The page"));
    follow_language();
  });
}

void ManualWindow::read_pages() {
  language_ = spoken_language();
  pages_.clear();
  for (const fs::path& english : page_files(folder_)) {
    std::error_code problem;
    const fs::path translated = folder_ / path_of(language_) / english.filename();
    const fs::path& file = fs::exists(translated, problem) ? translated : english;
    const auto text = read_text_file(file);
    if (!text) continue;
    const QString markdown = QString::fromStdString(*text);
    pages_.push_back({file, markdown.section('\n', 0, 0).remove("# "), markdown});
  }
}

void ManualWindow::follow_language() {
  const int open = open_page_;
  const bool other_language = language_ != spoken_language();
  if (other_language) read_pages();
  if (other_language || open < 0) search(words_->text());
  if (!other_language || open < 0) return;
  // The page that is read stays, also where it does not hold these words in this language.
  for (int row = 0; row < titles_->count(); ++row) {
    if (titles_->item(row)->data(Qt::UserRole).toInt() == open) return titles_->setCurrentRow(row);
  }
  titles_->setCurrentRow(-1);
  show_page(open);
}

void ManualWindow::search(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  titles_->clear();
  for (std::size_t n = 0; n < pages_.size(); ++n) {
    if (!holds_all(pages_[n].markdown, wanted)) continue;
    auto* item = new QListWidgetItem(pages_[n].title, titles_);
    item->setData(Qt::UserRole, static_cast<int>(n));
  }
  if (titles_->count() > 0) {
    titles_->setCurrentRow(0);
  } else {
    open_page_ = -1;
    text_->setPlainText(pages_.empty() ? tr("The manual was not found among the files that ship with Glisson.")
                                       : tr("No page holds these words."));
  }
}

void ManualWindow::open(const QString& page) {
  words_->clear();
  for (int row = 0; row < titles_->count(); ++row) {
    const auto n = static_cast<std::size_t>(titles_->item(row)->data(Qt::UserRole).toInt());
    if (text_of(pages_[n].file.stem()) == page) titles_->setCurrentRow(row);
  }
}

QString ManualWindow::open_page() const {
  return open_page_ < 0 ? QString() : text_of(pages_[static_cast<std::size_t>(open_page_)].file.stem());
}

void ManualWindow::show_row(int row) {
  if (row >= 0) show_page(titles_->item(row)->data(Qt::UserRole).toInt());
}

void ManualWindow::show_page(int page) {
  open_page_ = page;
  const ManualPage& shown = pages_[static_cast<std::size_t>(page)];
  text_->show_page(shown.file, shown.markdown);
  const QString first = words_->text().section(' ', 0, 0, QString::SectionSkipEmpty);
  if (!first.isEmpty()) text_->mark(first);
}

}  // namespace glisson::widgets
