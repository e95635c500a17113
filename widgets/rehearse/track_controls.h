#pragma once
// The rehearsal over time: freeze, play, go to any moment; its plot, its movie and its table.

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QWidget>

#include "widgets/plots/track_plot.h"
#include "widgets/rehearse/movie_maker.h"
#include "widgets/session/live_rehearsal.h"

namespace glisson::widgets {

class TrackControls : public QWidget {
  Q_OBJECT

 public:
  explicit TrackControls(LiveRehearsal& rehearsal, QWidget* parent = nullptr);

  // Where movies take their pictures from.
  void set_camera(std::function<QImage()> grab);
  // Which landmark the plot follows; empty: what moves most.
  void follow_landmark(const std::string& id);
  void make_movie(const std::filesystem::path& file);

 Q_SIGNALS:
  void failed(const glisson::Error& error);
  void said(const QString& what);

 private:
  void choose_movie();
  void save_table();
  void play_on();
  void show_time(double time_s);
  void show_track();
  void show_state();

  LiveRehearsal& rehearsal_;
  TrackPlot* plot_;
  QPushButton* freeze_;
  QPushButton* play_;
  QSlider* time_;
  QLabel* clock_;
  QPushButton* movie_button_;
  QPushButton* table_;
  QPushButton* clear_;
  MovieMaker* movie_ = nullptr;
  QString movie_file_;
  std::string landmark_;
  QTimer playing_;
  QElapsedTimer played_;
  double played_from_s_ = 0;
};

}  // namespace glisson::widgets
