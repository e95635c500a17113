#pragma once
// Part of a panel that can be folded away: a title with an arrow, and below it what it holds.

#include <QToolButton>
#include <QWidget>

namespace glisson::widgets {

class Fold : public QWidget {
  Q_OBJECT

 public:
  enum class At { open, closed };

  // The title's button bears the name.
  Fold(const char* name, QWidget* held, At at, QWidget* parent = nullptr);

  void set_title(const QString& title) { title_->setText(title); }
  [[nodiscard]] bool is_open() const { return title_->isChecked(); }

 Q_SIGNALS:
  void toggled(bool open);

 private:
  QToolButton* title_;
};

}  // namespace glisson::widgets
