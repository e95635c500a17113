#include "widgets/work/background_work.h"

#include "widgets/work/give_back_memory.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

constexpr int shortest_between_reports_ms = 40;

}  // namespace

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

bool BackgroundWork::start(const QString& title, Work work) {
  if (busy_) {
    Q_EMIT refused();
    return false;
  }
  busy_ = true;
  stop_ = {};
  auto clock = std::make_shared<QElapsedTimer>();
  clock->start();
  // Called on the worker's thread; the signal is delivered on ours.
  const Progress progress(
      [this, clock](double fraction, std::string_view stage) {
        if (clock->elapsed() < shortest_between_reports_ms && fraction < 1) return;
        clock->restart();
        Q_EMIT progressed(fraction, QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size())));
      },
      stop_.get_token());
  auto guarded = [this, work = std::move(work), progress]() -> Then {
    try {
      Then then = work(progress);
      give_back_memory();
      return then;
    } catch (const std::exception& problem) {
      return [this, what = QString::fromUtf8(problem.what())] { Q_EMIT broke(what); };
    }
  };
  Q_EMIT started(title);
  run_in_background(this, &thread_, std::move(guarded), [this](const Then& then) {
    busy_ = false;
    Q_EMIT finished();
    then();
  });
  return true;
}

void BackgroundWork::cancel() { stop_.request_stop(); }

void BackgroundWork::end() {
  cancel();
  thread_.waitForDone();
}

}  // namespace glisson::widgets
