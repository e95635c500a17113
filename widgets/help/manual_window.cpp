#include "help/manual_window.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include "base/files.h"
#include "words/paths.h"
#include "words/worded.h"

namespace glisson::widgets {
namespace fs = std::filesystem;
namespace {

constexpr int page_margin_px = 24;

std::vector<fs::path> page_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool holds_all(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

// A page with its pictures, as wide as the page is at most; they come from the manual's folder and nowhere else.
class PageText : public QTextBrowser {
 public:
  explicit PageText(const fs::path& folder) : folder_(text_of(folder)) {}

  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource || !name.isRelative() || name.path().contains("..")) return {};
    const QImage picture(folder_ + '/' + name.path());
    const int room = viewport()->width() - 2 * page_margin_px;
    return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation) : picture;
  }

 private:
  QString folder_;
};

}  // namespace

ManualWindow::ManualWindow(const fs::path& folder, QWidget* parent) : QWidget(parent, Qt::Window) {
  for (const fs::path& file : page_files(folder)) {
    const auto text = read_text_file(file);
    if (!text) continue;
    const QString markdown = QString::fromStdString(*text);
    pages_.push_back({markdown.section('\n', 0, 0).remove("# "), markdown});
  }

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
  connect(titles_, &QListWidget::currentRowChanged, this, &ManualWindow::show_page);
  worded(this, [this] {
    setWindowTitle(tr("Manual - Glisson"));
    words_->setPlaceholderText(tr("Search the manual"));
    words_->setAccessibleName(tr("Words to search for"));
    titles_->setAccessibleName(tr("Pages of the manual"));
    text_->setAccessibleName(tr("The page"));
    if (titles_->count() == 0) search(words_->text());  // the page that is read stays
  });
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
    text_->setPlainText(pages_.empty() ? tr("The manual was not found among the files that ship with Glisson.")
                                       : tr("No page holds these words."));
  }
}

void ManualWindow::show_page(int row) {
  if (row < 0) return;
  const int page = titles_->item(row)->data(Qt::UserRole).toInt();
  text_->setMarkdown(pages_[static_cast<std::size_t>(page)].markdown);
  const QString first = words_->text().section(' ', 0, 0, QString::SectionSkipEmpty);
  if (!first.isEmpty()) text_->find(first);
}

}  // namespace glisson::widgets
