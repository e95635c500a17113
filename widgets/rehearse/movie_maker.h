#pragma once
// Plays a rehearsal and writes what the view shows into a movie, with the force and what the answer is worth below it.
// One picture is drawn at a time between other events, so that nothing freezes.

#include <functional>
#include <optional>
#include <QImage>
#include <QObject>
#include <QTimer>

#include "vision/movie.h"
#include "widgets/session/live_rehearsal.h"

namespace glisson::widgets {

class MovieMaker : public QObject {
  Q_OBJECT

 public:
  static constexpr double frames_per_second = 25;

  // `grab` gives the view's picture of now.
  MovieMaker(LiveRehearsal& rehearsal, std::function<QImage()> grab, QObject* parent = nullptr);

  void begin(const std::filesystem::path& file);
  void stop();  // leaves nothing behind; does nothing where none is being made
  [[nodiscard]] bool busy() const { return writer_.has_value(); }

 Q_SIGNALS:
  void progressed(double fraction);
  // Each movie that begins ends with one of these.
  void written();
  void stopped();  // asked to, or there is nothing to film any more
  void failed(const glisson::Error& error);

 private:
  void next_picture();
  void end();

  LiveRehearsal& rehearsal_;
  std::function<QImage()> grab_;
  std::optional<vision::MovieWriter> writer_;
  double time_s_ = 0;
  QTimer timer_;
};

}  // namespace glisson::widgets
