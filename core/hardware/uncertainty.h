#pragma once
// How sure a plan's answer is. Every figure of a device is drawn again and again about its value, as widely as its
// source deserves. The answer is the share of the draws in which the platform holds.
//
// A figure's logarithm is drawn from a normal distribution about its own. Its sd is 5 % where it was measured or stands
// in the dissertation. It is 10 % where the figure was computed, 30 % where it is assumed. The widths are our
// judgement, the same for all. Figures that are limits or counts (throttling, tiles, the battery's exponents) stay, and
// so do those that stand for "ideal". What the convergence curve or a task's transfer to another machine may be wrong
// by is not in it.

#include <cstdint>

#include "hardware/device.h"

namespace glisson::hardware {

[[nodiscard]] double relative_sd(Source source);

// The same device with figures that it might have; the same number gives the same figures.
[[nodiscard]] Device drawn(const Device& device, std::uint64_t draw);

struct Certainty {
  double holds = 0;                  // share of the draws, 0 to 1
  double fps_low = 0, fps_high = 0;  // of what it can hold: the 10th and the 90th percentile
};

}  // namespace glisson::hardware
