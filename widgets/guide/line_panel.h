#pragma once
// Marks a line that a person recognises on both sides: the falciform ligament, the lower edge. While it is on, a click
// on the frame or on the model is its next place.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <string>

namespace glisson::widgets {

class LinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LinePanel(QWidget* parent = nullptr);

  [[nodiscard]] bool is_on() const { return mark_->isChecked(); }
  void set_on(bool on) { mark_->setChecked(on); }
  void set_allowed(bool allowed, const QString& why_not);
  // The line that is being marked, by its id.
  [[nodiscard]] std::string line() const { return line_->currentData().toString().toStdString(); }
  // How many places it has so far.
  void show_places(std::size_t on_frame, std::size_t on_model);

 Q_SIGNALS:
  void turned(bool on);
  void line_chosen();
  void removing_wanted();

 private:
  void update_text();

  std::size_t on_frame_ = 0, on_model_ = 0;
  QPushButton* mark_;
  QWidget* body_;
  QComboBox* line_;
  QPushButton* remove_;
  QLabel* help_;
  QLabel* places_;
};

}  // namespace glisson::widgets
