#pragma once
// Long work off the UI thread, one piece at a time, with progress and Cancel.
//
//   work->start(tr("Opening"), [folder](const Progress& progress) -> BackgroundWork::Then {
//     auto patient = load_patient(folder, progress);                       // on a worker thread
//     return [this, patient = std::move(patient)] { show(patient); };      // on the UI thread
//   });

#include <functional>
#include <memory>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <stop_token>

#include "base/progress.h"

namespace glisson::widgets {

class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  // What to do on the UI thread once the work is done.
  using Then = std::function<void()>;
  using Work = std::function<Then(const Progress&)>;

  explicit BackgroundWork(QObject* parent = nullptr);
  ~BackgroundWork() override { end(); }

  // False, and refused() is told, while another piece is under way.
  bool start(const QString& title, Work work);
  void cancel();
  // Cancels what is under way and waits until it has heard of it. What it would have shown is shown when the event loop
  // turns, if this is still there.
  void end();
  [[nodiscard]] bool busy() const { return busy_; }

 Q_SIGNALS:
  void started(const QString& title);
  void progressed(double fraction, const QString& stage);
  void finished();
  void refused();
  void broke(const QString& what);  // a defect of ours: an exception came out of the work

 private:
  std::stop_source stop_;
  bool busy_ = false;
  QThreadPool thread_;  // its own: what else computes neither waits for long work nor is waited for
};

}  // namespace glisson::widgets
