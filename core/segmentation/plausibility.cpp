#include "segmentation/plausibility.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/result.h"
#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

using imaging::Grid;
using imaging::Mask;
using imaging::Volume;

constexpr double most_of_the_body = 0.6;
constexpr double smallest_ml = 100;
constexpr double narrowest_image_mm = 100;

struct Seen {
  std::size_t outline = 0, body = 0;  // voxels, in the slices that hold some of the outline
  bool reaches_end = false;           // the first or last slice
};
Seen seen_in(const Mask& liver, const Volume& image);
float body_begins_at(const std::vector<float>& values);
std::size_t body_in_slice(const Volume& image, int k, float threshold);

}  // namespace

std::optional<Sentence> doubt_of_liver(const Mask& liver, const Volume& image) {
  GLISSON_ASSERT(imaging::same_grid(liver.grid, image.grid));
  const Seen seen = seen_in(liver, image);
  if (seen.outline == 0) return {};
  const double share = static_cast<double>(seen.outline) / static_cast<double>(std::max(seen.outline, seen.body));
  if (share > most_of_the_body) {
    return Sentence{
        GLISSON_TEXT("The outline fills {0} % of the body in its slices, a person's liver less than half: it "
                     "is not the liver alone, or these are images of an animal or a phantom."),
        {fmt::format("{:.0f}", 100 * share)}};
  }
  const double ml = volume_ml(liver);
  const auto side_mm = [&](int axis) {
    return image.grid.spacing_mm[axis] * image.grid.size[static_cast<std::size_t>(axis)];
  };
  const bool whole = !seen.reaches_end || std::min(side_mm(0), side_mm(1)) < narrowest_image_mm;
  if (ml >= smallest_ml || !whole) return {};
  return Sentence{
      GLISSON_TEXT("{0} ml is less than any person's liver holds: the outline is a part of it, or these are "
                   "images of an animal or a phantom."),
      {ml < 10 ? fmt::format("{:.1f}", ml) : fmt::format("{:.0f}", ml)}};
}

namespace {

Seen seen_in(const Mask& liver, const Volume& image) {
  Seen seen;
  const float threshold = body_begins_at(image.values);
  const auto [nx, ny, nz] = liver.grid.size;
  for (int k = 0; k < nz; ++k) {
    const auto begin = liver.values.begin() + static_cast<std::ptrdiff_t>(liver.grid.offset(0, 0, k));
    const auto inside = std::count_if(begin, begin + static_cast<std::ptrdiff_t>(nx) * ny,
                                      [](std::uint8_t value) { return value != 0; });
    if (inside == 0) continue;
    seen.outline += static_cast<std::size_t>(inside);
    seen.body += body_in_slice(image, k, threshold);
    seen.reaches_end = seen.reaches_end || k == 0 || k + 1 == nz;
  }
  return seen;
}

// A tenth of the way from dark to bright, the outermost fiftieths left out.
float body_begins_at(const std::vector<float>& values) {
  std::vector<float> sorted;
  std::copy_if(values.begin(), values.end(), std::back_inserter(sorted),
               [](float value) { return std::isfinite(value); });
  if (sorted.empty()) return 0;
  const auto at = [&](std::size_t place) {
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place), sorted.end());
    return sorted[place];
  };
  const std::size_t tail = sorted.size() / 50;
  const float dark = at(tail), bright = at(sorted.size() - 1 - tail);
  return dark + 0.1F * (bright - dark);
}

// What lies between bright voxels of its row and of its column both.
std::size_t body_in_slice(const Volume& image, int k, float threshold) {
  const auto [nx, ny, nz] = image.grid.size;
  const auto bright = [&](int i, int j) { return image.at(i, j, k) >= threshold; };
  std::vector<int> first_of_column(static_cast<std::size_t>(nx), ny), last_of_column(static_cast<std::size_t>(nx), -1);
  std::vector<int> first_of_row(static_cast<std::size_t>(ny), nx), last_of_row(static_cast<std::size_t>(ny), -1);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      if (!bright(i, j)) continue;
      const auto column = static_cast<std::size_t>(i), row = static_cast<std::size_t>(j);
      first_of_column[column] = std::min(first_of_column[column], j);
      last_of_column[column] = j;
      first_of_row[row] = std::min(first_of_row[row], i);
      last_of_row[row] = i;
    }
  }
  std::size_t count = 0;
  for (int j = 0; j < ny; ++j) {
    const auto row = static_cast<std::size_t>(j);
    for (int i = first_of_row[row]; i <= last_of_row[row]; ++i) {
      const auto column = static_cast<std::size_t>(i);
      if (first_of_column[column] <= j && j <= last_of_column[column]) ++count;
    }
  }
  return count;
}

}  // namespace
}  // namespace glisson::segmentation
