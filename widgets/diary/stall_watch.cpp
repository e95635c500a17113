#include "widgets/diary/stall_watch.h"

#include <time.h>

#include <algorithm>

namespace glisson::widgets {
namespace {

constexpr int every_ms = 20;

// The processor time of this thread so far.
double computed_ms() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

}  // namespace

StallWatch::StallWatch(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  since_.start();
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double late_ms = static_cast<double>(since_.nsecsElapsed()) / 1e6 - every_ms;
    since_.restart();
    longest_ms_ = std::max(longest_ms_, late_ms);
    const double computed_now_ms = computed_ms();
    longest_computing_ms_ = std::max(longest_computing_ms_, computed_now_ms - computed_before_ms_);
    computed_before_ms_ = computed_now_ms;
    if (late_ms > noticeable_ms) Q_EMIT stood_still(late_ms);
  });
  computed_before_ms_ = computed_ms();
  timer_.start(every_ms);
}

void StallWatch::forget() {
  longest_ms_ = 0;
  longest_computing_ms_ = 0;
  since_.restart();
  computed_before_ms_ = computed_ms();
}

}  // namespace glisson::widgets
