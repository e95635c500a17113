#pragma once
// What this product does in a frame, as a workload that any device can be asked for. The dissertation's own workload is
// workload.h's block product; these stand beside it: a live frame of the rehearsal, a frame of the guidance, a
// registration.
//
// What memory decides was timed on a machine whose memory was measured: bytes = seconds x bandwidth. A device then
// takes as long in proportion to what its memory gives. What arithmetic decides is counted. Either is an estimate of a
// program that nobody has run on that device, and a plan says so.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/figure.h"
#include "hardware/workload.h"

namespace glisson::hardware {

struct Task {
  std::string id;         // "rehearse": small letters, digits and dashes
  std::string what;       // one clause: of which body, with which engine
  double bytes = 0;       // a frame, of main memory
  double operations = 0;  // a frame; as many as a device's peak counts a second
  double seconds = 0;     // a frame, where it was timed
  Source source = Source::measured;
  std::string note;  // which machine, which command
};

// {"format": "glisson-tasks/1", "tasks": [{"id", "what", "bytes", "operations", "seconds", "source", "note"}]}
// Refused: no tasks or more than 100, an id twice, figures that are negative, a task without bytes and operations.
Result<std::vector<Task>> read_tasks(const std::filesystem::path& file);
Result<void> write_tasks(const std::filesystem::path& file, const std::vector<Task>& tasks);

// One product a frame, that is the frame; of blocks of no size, since no block product was timed that is like it.
[[nodiscard]] Workload workload_of(const Task& task);

}  // namespace glisson::hardware
