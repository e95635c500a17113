#include "casefile/drawn_vessels.h"

#include "casefile/structure_landmarks.h"
#include "vasculature/center_lines.h"
#include "vasculature/tubes.h"

namespace glisson::casefile {

bool may_be_drawn_as_tubes(const std::string& structure) {
  return is_vessel(structure) || structure.starts_with("vessel") || structure.starts_with("bil");
}

std::optional<geometry::Surface> drawn_vessel(const segmentation::Structure& structure,
                                              const geometry::Surface& outline) {
  if (!may_be_drawn_as_tubes(structure.name)) return {};
  const auto graph = vasculature::center_lines(structure.mask);
  if (!graph) return {};
  return vasculature::with_tubes(structure.mask, outline, *graph,
                                 {.thin_mm = vasculature::thin_radius_mm(structure.mask.grid.spacing_mm)});
}

}  // namespace glisson::casefile
