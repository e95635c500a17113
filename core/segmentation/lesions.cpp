#include "segmentation/lesions.h"

#include "segmentation/edit.h"

namespace glisson::segmentation {
namespace {

bool is_lesion(const std::string& name) { return name.starts_with("tumour") || name.starts_with("cyst"); }

bool meets(const imaging::Mask& a, const imaging::Mask& b) {
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (a.values[i] && b.values[i]) return true;
  }
  return false;
}

bool holds(const imaging::Mask& outer, const imaging::Mask& inner) {
  for (std::size_t i = 0; i < outer.values.size(); ++i) {
    if (inner.values[i] && !outer.values[i]) return false;
  }
  return true;
}

}  // namespace

WithLesions with_lesions(imaging::Mask liver, const std::vector<Structure>& structures, double gap_mm) {
  WithLesions result{std::move(liver), {}};
  imaging::Mask lesions{result.liver.grid, std::vector<std::uint8_t>(result.liver.values.size(), 0)};
  for (const Structure& structure : structures) {
    if (!is_lesion(structure.name) || !imaging::same_grid(structure.mask.grid, result.liver.grid)) continue;
    if (holds(result.liver, structure.mask)) continue;
    if (!meets(with_margin(structure.mask, gap_mm), result.liver)) continue;
    lesions = united(std::move(lesions), structure.mask);
    result.added.push_back(structure.name);
  }
  if (result.added.empty()) return result;

  result.liver = united(std::move(result.liver), lesions);
  // Closing, but only around the lesions: elsewhere it would fill the liver's own fissures.
  const imaging::Mask closed = with_margin(with_margin(result.liver, gap_mm), -gap_mm);
  const imaging::Mask around = with_margin(lesions, gap_mm);
  result.liver = fill_holes(united(std::move(result.liver), intersected(closed, around)));
  return result;
}

}  // namespace glisson::segmentation
