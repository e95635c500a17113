#pragma once
// Loops over both cores.

#include <cstddef>
#include <functional>

namespace glisson {

// How many threads our own loops use; 0 (the default) means as many as the machine has.
void set_thread_count(int threads);
[[nodiscard]] int thread_count();

// Calls body(begin, end) for disjoint ranges that together cover 0..count, on several threads at once.
// Small counts (below `grain`) run on the calling thread. An exception from the body reaches the caller.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace glisson
