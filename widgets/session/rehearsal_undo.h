#pragma once
// Where the tool stands and how it pulls, as a small value of the case's history: a drag is one step of undo. For the
// one tool of a patch; rigid tools have a session of their own, whose track is gone through instead.

#include <QJsonValue>
#include <QObject>
#include <QTimer>

#include "session/live_rehearsal.h"
#include "session/undo.h"

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
