#include "session/live_rehearsal.h"

#include <QFutureWatcher>
#include <QtConcurrentRun>

namespace glisson::widgets {

void LiveRehearsal::set_body(std::shared_ptr<const rehearsal::StaticRehearsal> body) {
  body_ = std::move(body);
  take_tool_away();
}

void LiveRehearsal::place_tool(const Eigen::Vector3d& center_mm, double radius_mm) {
  if (!body_) return;
  const int placement = ++placements_;
  using Outcome = Result<rehearsal::PlacedTool>;
  auto* watcher = new QFutureWatcher<std::shared_ptr<Outcome>>(this);
  connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, placement] {
    watcher->deleteLater();
    if (placement != placements_) return;
    const std::shared_ptr<Outcome> outcome = watcher->result();
    if (!*outcome) {
      Q_EMIT failed(outcome->error());
      return;
    }
    tool_ = **outcome;
    answer();
    Q_EMIT placed(tool_->solve_ms());
  });
  Q_EMIT placing();
  watcher->setFuture(QtConcurrent::run([body = body_, center_mm, radius_mm] {
    return std::make_shared<Outcome>(body->place_tool(center_mm, radius_mm));
  }));
}

void LiveRehearsal::take_tool_away() {
  ++placements_;
  tool_.reset();
  answer();
}

void LiveRehearsal::set_force_N(double force_N) {
  if (force_N == force_N_) return;
  force_N_ = force_N;
  if (tool_) answer();
}

void LiveRehearsal::set_direction(const Eigen::Vector3d& unit) {
  if (unit == direction_) return;
  direction_ = unit;
  if (tool_) answer();
}

void LiveRehearsal::answer() {
  frame_.reset();
  if (tool_) frame_ = tool_->answer(force_N_ * direction_);
  Q_EMIT frame_changed();
}

}  // namespace glisson::widgets
