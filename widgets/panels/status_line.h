#pragma once
// The bottom line of the window: what was just done, long work with its time left and Cancel.

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>

#include "widgets/work/background_work.h"

namespace glisson::widgets {

class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(BackgroundWork& work, QWidget* parent = nullptr);

  void say(const QString& text) { text_->setText(text); }
  // Since the work under way, or the last one, began.
  [[nodiscard]] double work_ms() const { return static_cast<double>(since_.elapsed()); }

 private:
  void begin(const QString& title);
  void show_progress(double fraction, const QString& stage);
  void end();

  BackgroundWork& work_;
  QElapsedTimer since_;
  QLabel* text_;
  QProgressBar* progress_;
  QPushButton* cancel_;
};

}  // namespace glisson::widgets
