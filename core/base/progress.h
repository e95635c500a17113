#pragma once
// How far a long computation is, and whether it should go on. Passed by const reference; a default
// Progress reports to nobody and is never cancelled.

#include <functional>
#include <stop_token>
#include <string_view>

namespace glisson {

class Progress {
 public:
  // Called with the fraction done (0..1) and what is being done, from any thread, one call at a time
  // for one computation.
  using Listener = std::function<void(double fraction, std::string_view stage)>;

  Progress() = default;
  explicit Progress(Listener listener, std::stop_token stop = {})
      : listener_(std::move(listener)), stop_(std::move(stop)) {}

  void report(double fraction, std::string_view stage) const {
    if (listener_) listener_(begin_ + (end_ - begin_) * fraction, stage);
  }

  // A computation that finds this true returns cancelled() soon, and leaves nothing half done.
  [[nodiscard]] bool cancelled() const { return stop_.stop_requested(); }

  // The progress of one part of the work, from fraction `begin` to fraction `end` of the whole.
  [[nodiscard]] Progress part(double begin, double end) const {
    Progress inner = *this;
    inner.begin_ = begin_ + (end_ - begin_) * begin;
    inner.end_ = begin_ + (end_ - begin_) * end;
    return inner;
  }

 private:
  Listener listener_;
  std::stop_token stop_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

}  // namespace glisson
