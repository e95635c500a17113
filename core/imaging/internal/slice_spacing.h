#pragma once
// Whether slices stand evenly, and what to make of them when they do not.

#include <cstddef>
#include <string>
#include <vector>

namespace glisson::imaging {

// Which of the given slices a slice of the even grid is made of.
struct SliceBlend {
  std::size_t first = 0;
  std::size_t second = 0;  // the same as `first` where one slice stands there
  double weight_of_second = 0;
};

struct SliceGap {
  std::size_t before = 0;  // the gap lies between slices `before` and `before` + 1
  double width_mm = 0;
  int missing = 0;  // whole slices that would fit in; 0: the gap is merely uneven
};

struct EvenSlices {
  double spacing_mm = 1;
  double usual_gap_mm = 1;  // before it was made to fit first and last
  std::vector<SliceBlend> slices;
  std::vector<SliceGap> gaps;  // those that are not as wide as the usual one
};

// Gaps wider than this many spacings part a stack in two rather than being filled.
constexpr double widest_gap_in_spacings = 5;

// Positions along the normal, ascending, no two the same, at least two. The spacing is that of most slices: the lower
// median gap, made to fit first and last exactly. A slice counts as standing on the grid within a twentieth of it.
[[nodiscard]] EvenSlices even_slices(const std::vector<double>& positions_mm);

// The lower median of the gaps; 0 for fewer than two positions.
[[nodiscard]] double usual_gap_mm(const std::vector<double>& positions_mm);

}  // namespace glisson::imaging
