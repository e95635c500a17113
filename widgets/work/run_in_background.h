#pragma once
// Work on another thread whose outcome is taken on the owner's, for what is asked for often and takes no progress. Long
// work that a person waits for is BackgroundWork's.

#include <memory>
#include <QFutureWatcher>
#include <QtConcurrentRun>
#include <QThreadPool>
#include <type_traits>
#include <utility>

#include "base/handover.h"

namespace glisson::widgets {

// Runs work() on a thread of `pool`. Then runs then(outcome), with a reference to what it gave, on that of `owner`; not
// where `owner` is gone by then. Neither may throw.
template <typename Work, typename Then>
void run_in_background(QObject* owner, QThreadPool* pool, Work work, Then then) {
  using Given = std::invoke_result_t<Work&>;
  const auto handover = std::make_shared<Handover>();
  auto* watcher = new QFutureWatcher<std::shared_ptr<Given>>(owner);
  QObject::connect(watcher, &QFutureWatcherBase::finished, owner,
                   [watcher, handover, then = std::move(then)]() mutable {
                     watcher->deleteLater();
                     handover->take();
                     then(*watcher->result());
                   });
  handover->give();
  watcher->setFuture(QtConcurrent::run(pool, [handover, work = std::move(work)]() mutable {
    handover->take();
    auto given = std::make_shared<Given>(work());
    handover->give();
    return given;
  }));
}

// On whichever thread is free.
template <typename Work, typename Then>
void run_in_background(QObject* owner, Work work, Then then) {
  run_in_background(owner, QThreadPool::globalInstance(), std::move(work), std::move(then));
}

}  // namespace glisson::widgets
