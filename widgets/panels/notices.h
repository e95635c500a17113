#pragma once
// What stands above the views: a notice, until it is closed or nothing is left to say, and where a patient that is not
// real comes from.

#include <functional>
#include <QLabel>
#include <QWidget>

namespace glisson::widgets {

class Notices : public QWidget {
  Q_OBJECT

 public:
  explicit Notices(QWidget* parent = nullptr);

  // The words are asked for again when the language changes.
  void say(std::function<QString()> words);
  void close_notice() { notice_->hide(); }
  void show_origin(const std::string& origin);  // Patient::origin

 private:
  QWidget* notice_;
  QLabel* text_;
  QLabel* origin_text_;
  std::function<QString()> words_;
  std::string origin_;
};

}  // namespace glisson::widgets
