#pragma once
// The diary on screen, and the report of a problem that is made of it.

#include <QPlainTextEdit>
#include <QWidget>

#include "widgets/diary/diary.h"

namespace glisson::widgets {

class DiaryWindow : public QWidget {
  Q_OBJECT

 public:
  // `graphics`: who draws, in one line.
  DiaryWindow(const Diary& diary, QString graphics, QWidget* parent = nullptr);

 private:
  void save();

  const Diary& diary_;
  QString graphics_;
  QPlainTextEdit* lines_;
};

}  // namespace glisson::widgets
