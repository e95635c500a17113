#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <atomic>
#include <thread>

#include "base/handover.h"

namespace glisson {
namespace {

std::atomic<int> requested_threads{0};

}  // namespace

void set_thread_count(int threads) { requested_threads = std::max(0, threads); }

int thread_count() {
  const int requested = requested_threads;
  return requested > 0 ? requested : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body) {
  if (count == 0) return;
  if (count <= grain || thread_count() == 1) {
    body(0, count);
    return;
  }
  Handover loop;
  const auto in_parallel = [&] {
    loop.give();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        loop.take();
                        body(range.begin(), range.end());
                        loop.give();
                      });
    loop.take();
  };
  if (requested_threads > 0) {
    tbb::task_arena(thread_count()).execute(in_parallel);
  } else {
    // TBB's own arena keeps its threads awake between loops; one made for each loop costs their waking, 20 us and more.
    // Isolated, so that a thread waiting here takes no work of a loop around this one.
    tbb::this_task_arena::isolate(in_parallel);
  }
}

}  // namespace glisson
