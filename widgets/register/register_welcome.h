#pragma once
// What the Register workspace shows while no sequence is open: what it needs, and how to get it.

#include <QLabel>
#include <QWidget>

namespace glisson::widgets {

class RegisterWelcome : public QWidget {
  Q_OBJECT

 public:
  explicit RegisterWelcome(QWidget* parent = nullptr);
  // What came of the last attempt.
  void say(const QString& words) { says_->setText(words); }

 Q_SIGNALS:
  void video_wanted();
  void file_wanted();
  void example_wanted();

 private:
  QLabel* says_;
};

}  // namespace glisson::widgets
