#pragma once
// What the window says beside its views. A notice lies over them and moves nothing, until it is closed or nothing is
// left to say. Above them stands where a patient that is not real comes from.

#include <functional>
#include <QLabel>
#include <QWidget>

namespace glisson::widgets {

class Notices : public QWidget {
  Q_OBJECT

 public:
  explicit Notices(QWidget* parent = nullptr);

  // Where notices are shown: at the bottom of that widget, over what stands there.
  void float_over(QWidget& area);

  // Something went wrong. The words are asked for again when the language changes.
  void say(std::function<QString()> words) { show_notice("trouble", std::move(words)); }
  // Something is worth knowing, and nothing is wrong.
  void note(std::function<QString()> words) { show_notice("note", std::move(words)); }
  void close_notice() { notice_->hide(); }
  void show_origin(const std::string& origin);  // Patient::origin
  // Not where the patient is not what is shown.
  void set_origin_shown(bool shown);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_notice(const char* kind, std::function<QString()> words);
  void put_in_place();

  QWidget* area_ = nullptr;
  QWidget* notice_;
  QLabel* text_;
  QLabel* origin_text_;
  std::function<QString()> words_;
  std::string origin_;
  bool origin_shown_ = true;
};

}  // namespace glisson::widgets
