#pragma once
// How the last answer came about, by a sign and a word, never a colour alone. With it stand how far from rest its
// landmarks may be, the residual, and the time that it took.

#include <QLabel>
#include <QWidget>

#include "widgets/session/live_rehearsal.h"

namespace glisson::widgets {

class SolvingLight : public QWidget {
  Q_OBJECT

 public:
  explicit SolvingLight(const LiveRehearsal& rehearsal, QWidget* parent = nullptr);
  // What drawing the last picture took, for the tooltip and the line.
  void show_drawing_ms(double drawing_ms);

 private:
  void show_state();
  void show_sign();
  void show_bound();
  [[nodiscard]] QString trouble() const;

  const LiveRehearsal& rehearsal_;
  double drawing_ms_ = 0;
  QLabel* sign_;
  QLabel* bound_;
  QLabel* figures_;
  QLabel* trouble_;
};

}  // namespace glisson::widgets
