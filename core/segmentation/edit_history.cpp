// Steps as runs of turned voxels.

#include "segmentation/edit_history.h"

#include <algorithm>
#include <limits>

#include "base/result.h"

namespace glisson::segmentation {

EditHistory::EditHistory(imaging::Mask start, std::size_t cap_bytes) : mask_(std::move(start)), cap_bytes_(cap_bytes) {
  GLISSON_ASSERT(mask_.values.size() <= std::numeric_limits<std::uint32_t>::max());
  for (std::uint8_t& value : mask_.values) value = value != 0 ? 1 : 0;  // so that a turn undoes a turn
}

void EditHistory::commit(std::string name, const imaging::Mask& edited) {
  GLISSON_ASSERT(edited.values.size() == mask_.values.size() && imaging::same_grid(edited.grid, mask_.grid));
  Step step{std::move(name), {}};
  bool turned = false;
  std::uint32_t length = 0;
  for (std::size_t voxel = 0; voxel < mask_.values.size(); ++voxel) {
    const bool turns = (edited.values[voxel] != 0) != (mask_.values[voxel] != 0);
    if (turns != turned) {
      step.kept_and_turned.push_back(length);
      turned = turns;
      length = 0;
    }
    ++length;
  }
  if (turned) step.kept_and_turned.push_back(length);
  if (step.kept_and_turned.empty()) return;
  step.kept_and_turned.shrink_to_fit();

  while (steps_.size() > done_) {
    used_bytes_ -= steps_.back().bytes();
    steps_.pop_back();
  }
  turn(step);
  used_bytes_ += step.bytes();
  steps_.push_back(std::move(step));
  ++done_;
  forget_beyond_cap();
}

std::string EditHistory::undo_name() const { return done_ > 0 ? steps_[done_ - 1].name : std::string{}; }

std::string EditHistory::redo_name() const { return done_ < steps_.size() ? steps_[done_].name : std::string{}; }

bool EditHistory::undo() {
  if (done_ == 0) return false;
  turn(steps_[--done_]);
  return true;
}

bool EditHistory::redo() {
  if (done_ == steps_.size()) return false;
  turn(steps_[done_++]);
  return true;
}

std::size_t EditHistory::Step::bytes() const {
  return sizeof(Step) + name.capacity() + kept_and_turned.capacity() * sizeof(std::uint32_t);
}

void EditHistory::turn(const Step& step) {
  std::size_t voxel = 0;
  for (std::size_t run = 0; run < step.kept_and_turned.size(); ++run) {
    const std::size_t end = voxel + step.kept_and_turned[run];
    if (run % 2 == 1) {
      for (std::size_t n = voxel; n < end; ++n) mask_.values[n] ^= 1;
    }
    voxel = end;
  }
}

void EditHistory::forget_beyond_cap() {
  while (used_bytes_ > cap_bytes_ && steps_.size() > 1) {
    used_bytes_ -= steps_.front().bytes();
    steps_.pop_front();
    --done_;
  }
}

}  // namespace glisson::segmentation
