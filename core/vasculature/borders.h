#pragma once
// Borders of segments as a hand sets them: places through which the border of two segments runs.

#include <array>
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::vasculature {

using SegmentPair = std::array<int, 2>;  // 1 to 8, the smaller first

// A place in patient coordinates, LPS, mm.
struct BorderPlace {
  SegmentPair segments{};
  Eigen::Vector3d position_mm{0, 0, 0};
  bool operator==(const BorderPlace&) const = default;
};
using BorderPlaces = std::vector<BorderPlace>;

// The pairs that share a border: neighbours from right to left, above and below each other, and I with each other.
[[nodiscard]] const std::vector<SegmentPair>& all_borders();
[[nodiscard]] std::string border_name(const SegmentPair& segments);  // "V-VIII"
[[nodiscard]] std::string names_of_borders();                        // of all: "I-II, I-III, ..."
// Of "V-VIII" and "VIII-V"; nothing where those two share no border.
[[nodiscard]] std::optional<SegmentPair> border_named(const std::string& name);

// "V-VIII=1,2,3", place in mm, as a case says what it was told; nothing where a text is none such.
[[nodiscard]] std::string border_text(const BorderPlace& place);
[[nodiscard]] std::optional<BorderPlace> border_of_text(const std::string& text);

// Places between voxels of two segments, by the border that they share; at most a few thousand of each, spread over it.
using DrawnBorders = std::map<SegmentPair, std::vector<Eigen::Vector3d>>;
[[nodiscard]] DrawnBorders drawn_borders(const imaging::LabelMap& segments);

// Fails with border-outside (a place does not lie in the liver) and borders-many (more than 200 places).
Result<void> lie_in_liver(const imaging::Mask& liver, const BorderPlaces& borders);

}  // namespace glisson::vasculature
