#include "diary/stall_watch.h"

#include <algorithm>

namespace glisson::widgets {
namespace {

constexpr int every_ms = 20;

}  // namespace

StallWatch::StallWatch(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  since_.start();
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double late_ms = static_cast<double>(since_.nsecsElapsed()) / 1e6 - every_ms;
    since_.restart();
    longest_ms_ = std::max(longest_ms_, late_ms);
    if (late_ms > noticeable_ms) Q_EMIT stood_still(late_ms);
  });
  timer_.start(every_ms);
}

}  // namespace glisson::widgets
