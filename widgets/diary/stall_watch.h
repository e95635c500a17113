#pragma once
// Measures how long the window's event loop stood still: a timer that should ring every 20 ms, and how late it is.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace glisson::widgets {

class StallWatch : public QObject {
  Q_OBJECT

 public:
  static constexpr double noticeable_ms = 100;  // what a hand on the mouse notices

  explicit StallWatch(QObject* parent = nullptr);

  // The longest since the watch began, or since it was last forgotten.
  [[nodiscard]] double longest_ms() const { return longest_ms_; }
  // The most that the window's own thread computed in one piece: what would have been the stall on a machine that does
  // nothing else.
  [[nodiscard]] double longest_computing_ms() const { return longest_computing_ms_; }
  void forget();

 Q_SIGNALS:
  void stood_still(double ms);  // for longer than noticeable_ms

 private:
  QTimer timer_;
  QElapsedTimer since_;
  double computed_before_ms_ = 0;
  double longest_ms_ = 0;
  double longest_computing_ms_ = 0;
};

}  // namespace glisson::widgets
