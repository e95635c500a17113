#pragma once
// Undo and redo for a mask that is edited by hand.

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// The mask as it is now, and the steps that led here. A step is stored as the runs of voxels that it turned, so that
// undoing and redoing are the same flip and a stroke of the brush costs a few hundred bytes. When the steps need more
// than the cap, the oldest are forgotten; the newest is kept even where it alone exceeds the cap.
class EditHistory {
 public:
  explicit EditHistory(imaging::Mask start, std::size_t cap_bytes = std::size_t{64} << 20);

  [[nodiscard]] const imaging::Mask& mask() const { return mask_; }

  // The mask becomes `edited` (same grid: asserts), under a name for the menu ("Erase"). Steps that were undone are
  // dropped. An edit that changed no voxel is no step.
  void commit(std::string name, const imaging::Mask& edited);

  // The name of the step that would be undone or redone next; empty when there is none.
  [[nodiscard]] std::string undo_name() const;
  [[nodiscard]] std::string redo_name() const;

  // Each says whether there was a step.
  bool undo();
  bool redo();

  [[nodiscard]] std::size_t steps_to_undo() const { return done_; }
  [[nodiscard]] std::size_t steps_to_redo() const { return steps_.size() - done_; }
  [[nodiscard]] std::size_t used_bytes() const { return used_bytes_; }

 private:
  struct Step {
    std::string name;
    std::vector<std::uint32_t> kept_and_turned;  // lengths by turns: voxels kept, voxels turned, ...
    [[nodiscard]] std::size_t bytes() const;
  };
  void turn(const Step& step);
  void forget_beyond_cap();

  imaging::Mask mask_;
  std::deque<Step> steps_;  // [0, done_) can be undone, the rest redone
  std::size_t done_ = 0;
  std::size_t cap_bytes_;
  std::size_t used_bytes_ = 0;
};

}  // namespace glisson::segmentation
