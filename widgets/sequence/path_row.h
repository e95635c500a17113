#pragma once
// A file or folder that is asked for: its name, the path, which can be typed, and a button that asks.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace glisson::widgets {

class PathRow : public QWidget {
  Q_OBJECT

 public:
  enum class Asks { file_or_folder, new_folder };

  // `name` is that of the line; the button is called choose_NAME.
  PathRow(const char* name, Asks asks, QWidget* parent = nullptr);

  void set_words(const QString& label, const QString& tooltip);
  void set_path(const QString& path) { path_->setText(path); }
  [[nodiscard]] QString path() const { return path_->text().trimmed(); }

 Q_SIGNALS:
  void changed();

 private:
  void ask();

  Asks asks_;
  QLabel* label_;
  QLineEdit* path_;
  QPushButton* choose_;
};

}  // namespace glisson::widgets
