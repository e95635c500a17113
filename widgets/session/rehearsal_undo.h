#pragma once
// Where the tools stand and how they pull, as a small value of the case's history: a drag is one step of undo. Rigid
// tools go back to where they were; the shape that the liver then takes may depend on the way, and the track keeps
// that.

#include <QJsonValue>
#include <QObject>
#include <QTimer>

#include "widgets/session/live_rehearsal.h"
#include "widgets/session/undo.h"

namespace glisson::widgets {

class RehearsalUndo : public QObject {
  Q_OBJECT

 public:
  RehearsalUndo(LiveRehearsal& rehearsal, Undo& undo, QObject* parent = nullptr);

  // Another patient, or the same read anew: what stands now is where it begins, and no step.
  void begin();

 private:
  [[nodiscard]] QJsonValue state() const;
  void apply(const QJsonValue& state);
  void note();

  LiveRehearsal& rehearsal_;
  Undo& undo_;
  QJsonValue known_;
  QTimer rest_;  // since the last movement
};

}  // namespace glisson::widgets
