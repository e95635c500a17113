#pragma once
// The manual in a window of its own: pages on the left, found by the words they hold, and the page chosen beside them.
//
// The pages are Markdown files of resources/manual, readable as they are; a page's title is its first line. A page in
// another language stands in the folder named by it (de/01-start.md); one that is not there is shown in English.

#include <filesystem>
#include <QWidget>
#include <vector>

class QLineEdit;
class QListWidget;

namespace glisson::widgets {

class PageText;

class ManualWindow : public QWidget {
  Q_OBJECT

 public:
  // Reads the pages of a folder, in the order of their file names and in the language of the window. It reads them
  // again when that changes: the page that is read stays open. Without any it says that the manual is missing.
  explicit ManualWindow(const std::filesystem::path& folder, QWidget* parent = nullptr);

  // The page of that file name without its ending ("05-rehearse"), whatever was searched for.
  void open(const QString& page);
  [[nodiscard]] QString open_page() const;  // its file name without its ending; empty where none is open

 private:
  struct ManualPage {
    std::filesystem::path file;
    QString title, markdown;
  };
  void read_pages();
  void search(const QString& words);
  void follow_language();
  void show_row(int row);
  void show_page(int page);

  std::filesystem::path folder_;
  QString language_;  // that the pages were read in
  std::vector<ManualPage> pages_;
  int open_page_ = -1;  // none while no page holds the words
  QLineEdit* words_ = nullptr;
  QListWidget* titles_ = nullptr;
  PageText* text_ = nullptr;
};

}  // namespace glisson::widgets
