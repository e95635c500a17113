#pragma once
// A generated liver as a patient's model, to lay on the video that `study example-sequence` makes of it: its outline
// meshed, one stiffness, and places inside whose truth the video's tables hold.

#include <vector>

#include "casefile/model.h"
#include "meshing/mesh_labels.h"
#include "segmentation/rasterise.h"
#include "table_places.h"

namespace glisson::test {

inline casefile::PatientModel liver_model(const geometry::Surface& liver, std::size_t cells,
                                          const std::vector<Eigen::Vector3d>& hidden_mm) {
  const auto box = geometry::bounding_box(liver.points_mm);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(10);
  imaging::Grid grid;
  grid.spacing_mm = Eigen::Vector3d::Constant(3);
  grid.origin_mm = box.min_mm - margin;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((box.max_mm - box.min_mm + 2 * margin)[axis] / 3)) + 1;
  }
  const imaging::Mask inside = segmentation::rasterise(liver, grid);
  const imaging::LabelMap labels{grid, {inside.values.begin(), inside.values.end()}};
  meshing::MeshOptions options;
  options.target_cells = cells;
  casefile::PatientModel model;
  model.mesh = meshing::mesh_labels(labels, options).value().body;
  model.mesh.cell_fields.push_back(
      {mechanics::youngs_modulus_field, 1, std::vector<double>(model.mesh.cells.size(), 5.0)});
  for (std::size_t k = 0; k < hidden_mm.size(); ++k) {
    model.landmarks.push_back({"hidden-" + std::to_string(k + 1), hidden_mm[k]});
  }
  model.liver = {"liver", {0.7, 0.3, 0.3}, liver, 0};
  return model;
}

}  // namespace glisson::test
