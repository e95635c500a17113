// The thread of a live session: commands wait in a queue, states are handed over whole.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

#include "rehearsal/session.h"

namespace glisson::rehearsal {
namespace {

// Does the later command make the earlier one pointless? A tool that is moved again before it was moved.
bool replaces(const SessionCommand& later, const SessionCommand& earlier) {
  const auto* now = std::get_if<HoldTool>(&later);
  const auto* before = std::get_if<HoldTool>(&earlier);
  return now != nullptr && before != nullptr && now->tool.id == before->tool.id &&
         now->tool.what.index() == before->tool.what.index();
}

// Steps of time that pass one by one are one wait in a recording.
void record(const SessionCommand& command, const std::string& digest, Recording& recording) {
  const auto* wait = std::get_if<Wait>(&command);
  auto* before = recording.empty() ? nullptr : std::get_if<Wait>(&recording.back().first);
  if (wait == nullptr || before == nullptr || before->steps + wait->steps > SessionEngine::most_waited_steps) {
    recording.emplace_back(command, digest);
    return;
  }
  before->steps += wait->steps;
  recording.back().second = digest;
}

}  // namespace

struct LiveSession::Impl {
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<SessionCommand> waiting;
  bool is_stepping = false, is_settling = false;
  std::stop_source settling;  // of the Settle under way, which whatever is asked for gives up
  enum class Reference { none, on_its_way, made, compared } reference = Reference::none;
  std::shared_ptr<const SessionState> latest;
  std::optional<Error> error;
  Recording recording;
  std::jthread thread;

  void run(const std::stop_token& closing, RehearsalSetup setup);
};

LiveSession::LiveSession(RehearsalSetup setup) : impl_(std::make_unique<Impl>()) {
  impl_->thread = std::jthread([parts = impl_.get(), given = std::move(setup)](const std::stop_token& closing) mutable {
    parts->run(closing, std::move(given));
  });
}

LiveSession::~LiveSession() {
  impl_->thread.request_stop();
  {
    const std::lock_guard lock(impl_->mutex);  // it waits, or will look before it does
    impl_->settling.request_stop();
  }
  impl_->changed.notify_all();
}

void LiveSession::Impl::run(const std::stop_token& closing, RehearsalSetup setup) {
  const double step_s = setup.motion ? setup.motion->step_s : 0;
  auto engine = SessionEngine::create(std::move(setup), Progress({}, closing), WithReference::when_asked);
  std::future<void> making;  // it ends before the engine does, and after the lock is given back
  std::unique_lock lock(mutex);
  if (!engine) {
    error = std::move(engine.error());
    return;
  }
  latest = engine->shared_state();
  if (engine->has_reference() && !latest->reference) {
    reference = Reference::on_its_way;
    making = std::async(std::launch::async, [this, &engine, closing] {
      auto made = engine->make_reference(Progress({}, closing));
      {
        const std::lock_guard told(mutex);
        reference = Reference::made;
        if (!made) error = std::move(made.error());
      }
      changed.notify_all();
    });
  }
  int settles = 0;  // since the last command
  bool may_prepare = true;
  bool may_go_on = true;  // in motion: the last step was made
  auto next_step = std::chrono::steady_clock::now();
  for (;;) {
    const auto moves = [&] { return latest->motion && latest->motion->moves && may_go_on; };
    const auto may_settle = [&] { return !latest->settled && settles < SessionEngine::most_settles; };
    const auto may_compare = [&] { return reference == Reference::made; };
    changed.wait(lock, [&] {
      return closing.stop_requested() || !waiting.empty() || may_settle() || may_prepare || may_compare() || moves();
    });
    if (closing.stop_requested() || error) return;
    if (waiting.empty() && may_compare()) {
      waiting.push_back(Compare{});
      reference = Reference::compared;
    }
    if (waiting.empty() && !may_settle() && !moves()) {
      lock.unlock();
      may_prepare = engine->prepare();
      lock.lock();
      continue;
    }
    // Of a hand that goes on moving the next picture is wanted, and a Settle under way would hold it up.
    constexpr std::chrono::milliseconds rest_of_a_hand(150);
    is_stepping = is_settling = waiting.empty();
    if (waiting.empty() && moves()) {
      changed.wait_until(lock, next_step, [&] { return closing.stop_requested() || !waiting.empty(); });
      if (closing.stop_requested()) return;
      if (waiting.empty()) waiting.push_back(Wait{});
    } else if (waiting.empty() && settles == 0) {
      changed.wait_for(lock, rest_of_a_hand, [&] { return closing.stop_requested() || !waiting.empty(); });
      if (closing.stop_requested()) return;
    }
    SessionCommand command = Settle{};
    if (waiting.empty()) {
      ++settles;
    } else {
      command = std::move(waiting.front());
      waiting.pop_front();
      settles = 0;
    }
    const bool waits = std::holds_alternative<Wait>(command);
    is_settling = waits || std::holds_alternative<Settle>(command);
    is_stepping = true;
    settling = std::stop_source();
    const Progress given_up = waits ? Progress() : Progress({}, settling.get_token());
    next_step = std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(step_s));
    lock.unlock();
    engine->step(command, given_up, [this](std::shared_ptr<const SessionState> on_the_way) {
      const std::lock_guard told(mutex);
      latest = std::move(on_the_way);
    });
    lock.lock();
    is_stepping = false;
    if (engine->shared_state() == latest) continue;  // a Settle that was given up
    latest = engine->shared_state();
    may_prepare = true;
    may_go_on = latest->refused.empty() || !waits;
    if (may_go_on) record(command, latest->digest, recording);
  }
}

void LiveSession::post(SessionCommand command) {
  {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->waiting.empty() && replaces(command, impl_->waiting.back())) impl_->waiting.pop_back();
    impl_->waiting.push_back(std::move(command));
    impl_->settling.request_stop();
  }
  impl_->changed.notify_all();
}

SessionPhase LiveSession::phase() const {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->error) return SessionPhase::failed;
  if (!impl_->latest) return SessionPhase::preparing;
  if (!impl_->waiting.empty()) return SessionPhase::stepping;
  if (!impl_->is_stepping) {
    const bool awaits = impl_->reference == Impl::Reference::on_its_way || impl_->reference == Impl::Reference::made;
    return awaits ? SessionPhase::comparing : SessionPhase::ready;
  }
  return impl_->is_settling ? SessionPhase::settling : SessionPhase::stepping;
}

std::shared_ptr<const SessionState> LiveSession::latest() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->latest;
}

std::optional<Error> LiveSession::error() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->error;
}

Recording LiveSession::recording() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->recording;
}

}  // namespace glisson::rehearsal
