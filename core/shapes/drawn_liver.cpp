#include "shapes/drawn_liver.h"

#include <cmath>

#include "anatomy/level_surface.h"
#include "base/noise.h"
#include "segmentation/rasterise.h"

namespace glisson::shapes {

using Eigen::Index;

Result<DrawnLiver> draw_liver(const ShapeModel& model, std::uint64_t seed, std::uint64_t number) {
  constexpr int most_attempts = 100;
  constexpr double farthest_sd = 3, smallest_ml = 400, largest_ml = 5000;
  DrawnLiver liver;
  liver.coefficients.resize(model.rank());
  std::uint64_t used = 0;
  const std::uint64_t stream = mixed(seed, number);
  for (liver.attempts = 1; liver.attempts <= most_attempts; ++liver.attempts) {
    for (Index k = 0; k < liver.coefficients.size(); ++k) {
      do {
        liver.coefficients[k] = normal_pair(stream, used++).x();
      } while (std::abs(liver.coefficients[k]) > farthest_sd);
    }
    liver.surface = model.at(liver.coefficients);
    const double ml = geometry::volume_mm3(liver.surface) / 1000;
    if (ml >= smallest_ml && ml <= largest_ml) return liver;
  }
  return failure("shapes-cannot-draw",
                 GLISSON_TEXT("No liver of {0} drawn from the model is a body of 400 to 5000 ml."),
                 {std::to_string(most_attempts)});
}

Result<meshing::LiverMesh> mesh_of(const DrawnLiver& liver, int target_cells, double spacing_mm,
                                   const Progress& progress) {
  geometry::Box box = geometry::bounding_box(liver.surface.points_mm);
  box.min_mm.array() -= 2 * spacing_mm;
  box.max_mm.array() += 2 * spacing_mm;
  const imaging::Mask mask = segmentation::rasterise(liver.surface, anatomy::grid_over(box, spacing_mm));
  const imaging::LabelMap labels{mask.grid, {mask.values.begin(), mask.values.end()}};
  meshing::MeshOptions options;
  options.target_cells = target_cells;
  return meshing::mesh_labels(labels, options, progress);
}

}  // namespace glisson::shapes
