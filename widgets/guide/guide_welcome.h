#pragma once
// What the Guide page shows while no sequence is open: what it needs, and how to get it.

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace glisson::widgets {

class GuideWelcome : public QWidget {
  Q_OBJECT

 public:
  explicit GuideWelcome(QWidget* parent = nullptr);
  // What the case lacks before anything can be placed; empty for nothing.
  void show_missing(const QString& missing);
  // What came of the last attempt.
  void say(const QString& words) { says_->setText(words); }

 Q_SIGNALS:
  void video_wanted();
  void file_wanted();
  void example_wanted();

 private:
  void update_text();

  QString missing_;
  QPushButton* video_;
  QPushButton* open_;
  QPushButton* make_;
  QLabel* says_;
};

}  // namespace glisson::widgets
