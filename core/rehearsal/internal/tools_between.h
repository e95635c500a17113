#pragma once
// Tools on their way from where they were to where they are wanted, in steps that a body follows.

#include <vector>

#include "mechanics/contact/contact.h"

namespace glisson::rehearsal {

using Tools = std::vector<mechanics::ContactTool>;

// Those of the same id go in a straight line, the others are there at once; what pushes or pulls begins gently and ends
// so. At part 1 the tools that are wanted and no others.
[[nodiscard]] Tools between(const Tools& from, const Tools& to, double part);

[[nodiscard]] double farthest_move_mm(const Tools& from, const Tools& to);
[[nodiscard]] double largest_change_of_push_mN(const Tools& from, const Tools& to);
// With what pulls, and what was let go.
[[nodiscard]] double largest_change_of_force_mN(const Tools& from, const Tools& to);

}  // namespace glisson::rehearsal
