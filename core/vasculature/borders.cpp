#include "vasculature/borders.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "base/text.h"
#include "vasculature/couinaud.h"
#include "vasculature/internal/nearest_voxel.h"

namespace glisson::vasculature {

const std::vector<SegmentPair>& all_borders() {
  static const std::vector<SegmentPair> pairs = {{1, 2}, {1, 3}, {1, 4}, {1, 5}, {1, 6}, {1, 7},
                                                 {1, 8}, {2, 3}, {2, 4}, {3, 4}, {4, 5}, {4, 8},
                                                 {5, 6}, {5, 7}, {5, 8}, {6, 7}, {6, 8}, {7, 8}};
  return pairs;
}

std::string border_name(const SegmentPair& segments) {
  return fmt::format("{}-{}", segment_name(static_cast<std::size_t>(segments[0])),
                     segment_name(static_cast<std::size_t>(segments[1])));
}

std::string names_of_borders() {
  std::vector<std::string> names;
  for (const SegmentPair& pair : all_borders()) names.push_back(border_name(pair));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<SegmentPair> border_named(const std::string& name) {
  const auto& pairs = all_borders();
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const SegmentPair& pair) {
    return name == border_name(pair) || name == border_name({pair[1], pair[0]});
  });
  return found == pairs.end() ? std::nullopt : std::optional<SegmentPair>(*found);
}

std::string border_text(const BorderPlace& place) {
  const Eigen::Vector3d& p = place.position_mm;
  return fmt::format("{}={},{},{}", border_name(place.segments), p.x(), p.y(), p.z());
}

std::optional<BorderPlace> border_of_text(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const auto segments = border_named(text.substr(0, equals));
  if (!segments) return {};
  BorderPlace place{*segments, {}};
  std::size_t from = equals;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (from >= text.size()) return {};
    const std::size_t to = axis < 2 ? std::min(text.find(',', from + 1), text.size()) : text.size();
    const auto number = read_number(text.substr(from + 1, to - from - 1));
    if (!number) return {};
    place.position_mm[axis] = *number;
    from = to;
  }
  return place;
}

DrawnBorders drawn_borders(const imaging::LabelMap& segments) {
  const imaging::Grid& grid = segments.grid;
  DrawnBorders borders;
  const auto look_between = [&](int i, int j, int k, int axis) {
    const int a = segments.at(i, j, k), b = segments.at(i + (axis == 0), j + (axis == 1), k + (axis == 2));
    if (a == 0 || b == 0 || a == b) return;
    const Eigen::Vector3d middle = Eigen::Vector3d(i, j, k) + 0.5 * Eigen::Vector3d::Unit(axis);
    borders[{std::min(a, b), std::max(a, b)}].push_back(grid.position_mm(middle));
  };
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (i + 1 < grid.size[0]) look_between(i, j, k, 0);
        if (j + 1 < grid.size[1]) look_between(i, j, k, 1);
        if (k + 1 < grid.size[2]) look_between(i, j, k, 2);
      }
    }
  }
  std::erase_if(borders, [](const auto& border) { return !border_named(border_name(border.first)); });
  constexpr std::size_t most = 3000;
  for (auto& [segments_beside, places_mm] : borders) {
    const std::size_t step = places_mm.size() / most + 1;
    for (std::size_t n = 0; n * step < places_mm.size(); ++n) places_mm[n] = places_mm[n * step];
    places_mm.resize((places_mm.size() + step - 1) / step);
  }
  return borders;
}

Result<void> lie_in_liver(const imaging::Mask& liver, const BorderPlaces& borders) {
  constexpr std::size_t most = 200;
  if (borders.size() > most) {
    return failure("borders-many", GLISSON_TEXT("{0} places on borders are told: tell {1} at most."),
                   {std::to_string(borders.size()), std::to_string(most)});
  }
  for (const BorderPlace& place : borders) {
    const auto voxel = nearest_voxel(liver.grid, place.position_mm);
    if (voxel && liver.values[*voxel] != 0) continue;
    const Eigen::Vector3d& p = place.position_mm;
    return failure(
        "border-outside",
        GLISSON_TEXT("{0} does not lie in the liver, where the border of {1} was told: put the place inside."),
        {fmt::format("{:.1f},{:.1f},{:.1f}", p.x(), p.y(), p.z()), border_name(place.segments)});
  }
  return {};
}

}  // namespace glisson::vasculature
