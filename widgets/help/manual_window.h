#pragma once
// The manual in a window of its own: pages on the left, found by the words they hold, and the page chosen beside them.
//
// The pages are Markdown files of resources/manual, readable as they are; a page's title is its first line.

#include <filesystem>
#include <QWidget>
#include <vector>

class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace glisson::widgets {

class ManualWindow : public QWidget {
  Q_OBJECT

 public:
  // Reads the pages of a folder, in the order of their file names. Without any it says that the manual is missing.
  explicit ManualWindow(const std::filesystem::path& folder, QWidget* parent = nullptr);

 private:
  struct ManualPage {
    QString title, markdown;
  };
  void search(const QString& words);
  void show_page(int row);

  std::vector<ManualPage> pages_;
  QLineEdit* words_ = nullptr;
  QListWidget* titles_ = nullptr;
  QTextBrowser* text_ = nullptr;
};

}  // namespace glisson::widgets
