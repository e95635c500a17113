#include "segmentation/edit_history.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "segmentation/edit.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

Mask start_mask() {
  Mask mask;
  mask.grid.size = {14, 12, 10};
  mask.grid.spacing_mm = {1, 1.5, 2};
  mask.values.assign(mask.grid.voxels(), 0);
  return paint(std::move(mask), {{6, 8, 9}, 4});
}

// Not == within RC_ASSERT, which would print every voxel.
bool same(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) { return a == b; }

// One of the edits, chosen and placed at random.
Mask random_edit(const Mask& mask) {
  const auto coordinate = [](int end) { return static_cast<double>(*rc::gen::inRange(-10, 10 * end)) / 10; };
  const Vector3d at_mm(coordinate(14), coordinate(18), coordinate(20));
  const double radius_mm = static_cast<double>(*rc::gen::inRange(1, 80)) / 10;
  switch (*rc::gen::inRange(0, 8)) {
    case 0: return paint(mask, {at_mm, radius_mm});
    case 1: return erase(mask, {at_mm, radius_mm});
    case 2: return cut(mask, Plane{at_mm, Vector3d(radius_mm, 1, -1)});
    case 3: return fill_holes(mask);
    case 4: return keep_largest(mask);
    case 5: return smooth(mask, radius_mm / 4);
    case 6: return with_margin(mask, radius_mm / 4);
    default: return with_margin(mask, -radius_mm / 4);
  }
}

RC_GTEST_PROP(EditHistory, UndoneToTheStartIsTheStartAndRedoneIsTheEnd, ()) {
  const Mask start = start_mask();
  EditHistory history(start);
  std::vector<std::vector<std::uint8_t>> states{start.values};
  const int edits = *rc::gen::inRange(1, 25);
  for (int n = 0; n < edits; ++n) {
    const bool goes_back = *rc::gen::inRange(0, 4) == 0;
    if (goes_back && history.undo()) {
      states.pop_back();
    } else {
      history.commit("edit", random_edit(history.mask()));
      if (history.mask().values != states.back()) states.push_back(history.mask().values);
    }
    RC_ASSERT(same(history.mask().values, states.back()));
    RC_ASSERT(history.steps_to_undo() == states.size() - 1);
  }
  for (std::size_t n = states.size(); n-- > 1;) {
    RC_ASSERT(history.undo());
    RC_ASSERT(same(history.mask().values, states[n - 1]));
  }
  RC_ASSERT(!history.undo());
  RC_ASSERT(same(history.mask().values, start.values));
  for (std::size_t n = 1; n < states.size(); ++n) RC_ASSERT(history.redo());
  RC_ASSERT(same(history.mask().values, states.back()));
}

RC_GTEST_PROP(EditHistory, StaysUnderItsCapAndStillUndoesWhatItRemembers, ()) {
  const auto cap_bytes = static_cast<std::size_t>(*rc::gen::inRange(200, 4000));
  EditHistory history(start_mask(), cap_bytes);
  std::vector<std::vector<std::uint8_t>> states{history.mask().values};
  for (int n = 0; n < 15; ++n) {
    history.commit("edit", random_edit(history.mask()));
    if (history.mask().values != states.back()) states.push_back(history.mask().values);
    RC_ASSERT(history.used_bytes() <= cap_bytes || history.steps_to_undo() == 1);
  }
  while (history.undo()) {
    states.pop_back();
    RC_ASSERT(same(history.mask().values, states.back()));
  }
}

TEST(EditHistory, NamesItsSteps) {
  EditHistory history(start_mask());
  EXPECT_EQ(history.undo_name(), "");
  history.commit("Paint", paint(history.mask(), {{10, 10, 10}, 3}));
  history.commit("Erase", erase(history.mask(), {{6, 8, 9}, 3}));
  EXPECT_EQ(history.undo_name(), "Erase");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.undo_name(), "Paint");
  EXPECT_EQ(history.redo_name(), "Erase");
  history.commit("Cut", cut(history.mask(), Plane{{6, 8, 9}, {1, 0, 0}}));
  EXPECT_EQ(history.redo_name(), "");
  EXPECT_EQ(history.steps_to_undo(), 2U);
}

TEST(EditHistory, AnEditThatChangesNothingIsNoStep) {
  EditHistory history(start_mask());
  history.commit("Paint", history.mask());
  EXPECT_EQ(history.steps_to_undo(), 0U);
}

// 256 x 256 x 70 voxels take 4.6 MB; a stroke of a 10 mm brush turns some 2,800 voxels in about 500 runs.
TEST(EditHistory, AStrokeCostsFarLessThanTheMask) {
  Mask mask;
  mask.grid.size = {256, 256, 70};
  mask.grid.spacing_mm = {1.5, 1.5, 3};
  mask.values.assign(mask.grid.voxels(), 0);
  EditHistory history(mask);
  history.commit("Paint", paint(mask, {{190, 190, 100}, 10}));
  EXPECT_LT(history.used_bytes(), 8000U);
}

}  // namespace
}  // namespace glisson::segmentation
