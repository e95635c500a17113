#pragma once
// Which messages are sent when, and by which thread: the rescheduled pass of the dissertation (section 3.2.2).
//
// A sweep visits the nodes by position. The node at position p sends to all later positions. It may do so once its
// belief is gathered, which needs the messages from all earlier positions. Each node's messages are cut into chunks;
// the first, the head, holds the message to the next node. Threads claim chunks in order, heads first. So the next
// node's belief is gathered while the rest of this node's messages are still on their way: nobody waits long. Sweeps
// follow one another without a gap. Every wait is for a chunk claimed earlier, hence there is no deadlock, even with a
// single thread.
//
// On a busy machine a thread that holds a chunk may be off the processor for longer than the whole work takes. That
// happens again and again. Once anybody has waited so long that this must be so, the helpers claim no more and one
// thread goes on.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "registration/trwls.h"

namespace glisson::registration {

struct Chunk {
  int position = 0;
  int first_target = 0;  // positions
  int targets = 0;
};

class Schedule {
 public:
  // patience: longer than any wait lasts while all threads run.
  Schedule(int nodes, int sweeps, std::chrono::microseconds patience, Order order = Order::head_first)
      : nodes_(nodes),
        sweeps_(sweeps),
        patience_(patience),
        order_(order),
        done_(count()),
        head_done_(count()),
        gathered_(count()) {
    for (int p = 0; p < nodes; ++p) {
      first_chunk_.push_back(chunks_.size());
      int size = head_size;
      for (int target = p + 1; target < nodes; target += chunks_.back().targets, size = chunk_size) {
        chunks_.push_back({p, target, std::min(size, nodes - target)});
      }
    }
    first_chunk_.push_back(chunks_.size());
  }

  struct Claim {
    int sweep = 0;
    std::size_t chunk = 0;
  };
  // The next chunk for the calling thread; its sweep is sweeps() or more when there are none left.
  Claim claim() {
    const std::uint64_t number = next_chunk_.fetch_add(1, std::memory_order_relaxed);
    return {static_cast<int>(number / chunks_.size()), static_cast<std::size_t>(number % chunks_.size())};
  }
  [[nodiscard]] const Chunk& chunk(std::size_t index) const { return chunks_[index]; }
  [[nodiscard]] std::size_t chunks() const { return chunks_.size(); }
  [[nodiscard]] int sweeps() const { return sweeps_; }

  void finished(const Claim& claim) {
    const auto p = static_cast<std::size_t>(chunks_[claim.chunk].position);
    if (claim.chunk == first_chunk_[p]) head_done_[p].store(claim.sweep + 1, std::memory_order_release);
    done_[p].fetch_add(1, std::memory_order_release);
  }

  // Waits until the belief of the node at a position is gathered, and gathers whatever is due meanwhile by calling
  // gather(sweep, position). False when everything was called off.
  template <typename Gather>
  bool wait_for_belief(int sweep, int position, const Gather& gather) {
    constexpr int turns_before_yielding = 200;
    std::chrono::steady_clock::time_point since;
    for (int turn = 0; gathered_[static_cast<std::size_t>(position)].load(std::memory_order_acquire) <= sweep; ++turn) {
      if (called_off_.load(std::memory_order_relaxed)) return false;
      if (gather_next(gather) || turn < turns_before_yielding) continue;
      const auto now = std::chrono::steady_clock::now();
      if (since == std::chrono::steady_clock::time_point()) since = now;
      if (now - since > patience_) helpers_stay_.store(false, std::memory_order_relaxed);
      std::this_thread::yield();
    }
    return true;
  }

  // Gathers the next belief if all messages to it have arrived. Called after every chunk.
  template <typename Gather>
  bool gather_next(const Gather& gather) {
    std::uint64_t number = next_belief_.load(std::memory_order_acquire);
    const int sweep = static_cast<int>(number / static_cast<std::uint64_t>(nodes_));
    const int position = static_cast<int>(number % static_cast<std::uint64_t>(nodes_));
    if (sweep >= sweeps_ || !messages_have_arrived(sweep, position)) return false;
    if (!next_belief_.compare_exchange_strong(number, number + 1, std::memory_order_acq_rel)) return true;
    gather(sweep, position);
    gathered_[static_cast<std::size_t>(position)].store(sweep + 1, std::memory_order_release);
    return true;
  }

  // The sweep back overwrites the messages that a pass's labelling is read from: it begins only when they were read.
  void labelling_was_read(int passes) { passes_read_.store(passes, std::memory_order_release); }
  // Whether helpers should claim more.
  [[nodiscard]] bool helpers_stay() const { return helpers_stay_.load(std::memory_order_relaxed); }
  void call_off() { called_off_.store(true, std::memory_order_relaxed); }

 private:
  static constexpr int head_size = 2;
  static constexpr int chunk_size = 12;  // 2 us of work at 128 labels: many times what claiming costs

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(nodes_); }

  [[nodiscard]] bool all_done(int sweep, int position) const {
    const auto p = static_cast<std::size_t>(position);
    return done_[p].load(std::memory_order_acquire) >=
           static_cast<std::uint64_t>(sweep + 1) * (first_chunk_[p + 1] - first_chunk_[p]);
  }

  // Beliefs are gathered in order, so what this one's predecessors waited for need not be looked at again.
  [[nodiscard]] bool messages_have_arrived(int sweep, int position) const {
    if (position == 0) {
      if (sweep == 0) return true;
      const bool back = sweep % 2 == 1;
      if (back && passes_read_.load(std::memory_order_acquire) < sweep / 2) return false;
      // No messages wait for the last belief of a sweep. Without this a thread may still be at it when the next sweep
      // ends, and both write in the same place.
      return all_done(sweep - 1, nodes_ - 2) && gathered_[count() - 1].load(std::memory_order_acquire) >= sweep;
    }
    if (order_ == Order::naive) return all_done(sweep, position - 1);
    if (head_done_[static_cast<std::size_t>(position - 1)].load(std::memory_order_acquire) <= sweep) return false;
    return position < 2 || all_done(sweep, position - 2);
  }

  int nodes_;
  int sweeps_;
  std::chrono::microseconds patience_;
  Order order_;
  std::vector<Chunk> chunks_;
  std::vector<std::size_t> first_chunk_;
  alignas(64) std::atomic<std::uint64_t> next_chunk_{0};
  alignas(64) std::atomic<std::uint64_t> next_belief_{0};
  std::vector<std::atomic<std::uint64_t>> done_;  // chunks of each position, in all sweeps
  std::vector<std::atomic<int>> head_done_;       // in this many sweeps
  std::vector<std::atomic<int>> gathered_;        // in this many sweeps
  std::atomic<int> passes_read_{0};
  std::atomic<bool> called_off_{false};
  std::atomic<bool> helpers_stay_{true};
};

}  // namespace glisson::registration
