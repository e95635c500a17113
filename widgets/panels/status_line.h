#pragma once
// The bottom line of the window: what was just done, long work with its time left and Cancel.

#include <optional>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include "widgets/work/background_work.h"

namespace glisson::widgets {

// "about 2 min left"; nothing where it should have been done by now.
[[nodiscard]] QString time_left(double left_ms);

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
  void tell_stage();

  BackgroundWork& work_;
  QElapsedTimer since_;
  QTimer every_second_;  // a long step reports nothing on its way
  QString stage_;
  std::optional<double> takes_ms_;  // the whole work, as far as it can be told
  QLabel* text_;
  QProgressBar* progress_;
  QPushButton* cancel_;
};

}  // namespace glisson::widgets
