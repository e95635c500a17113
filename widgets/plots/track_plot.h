#pragma once
// A rehearsal over time: the force, how far a landmark moves, and how far off the atlas is. A line stands at 5 mm, from
// which it matters to a surgeon. Click or drag in it: that time.

#include <QWidget>

#include "widgets/session/rehearsal_track.h"

class QCustomPlot;
class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;

namespace glisson::widgets {

class TrackPlot : public QWidget {
  Q_OBJECT

 public:
  explicit TrackPlot(QWidget* parent = nullptr);

  // `landmark` is its place in each moment's list; none: the largest displacement of the surface.
  void show_track(const RehearsalTrack& track, std::optional<std::size_t> landmark, const QString& landmark_name);
  // The upright line; none for now.
  void show_time(std::optional<double> time_s);

 Q_SIGNALS:
  void time_chosen(double time_s);

 private:
  QCustomPlot* plot_;
  QCPGraph* moved_;
  QCPGraph* reference_off_;
  QCPGraph* force_;
  QCPItemStraightLine* five_mm_;
  QCPItemText* five_mm_label_;
  QCPItemStraightLine* now_;
};

}  // namespace glisson::widgets
