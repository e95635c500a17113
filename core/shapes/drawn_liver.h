#pragma once
// SIMULATED livers drawn from a shape model: nobody's, but as different from one another as the model's.

#include <cstdint>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "meshing/mesh_labels.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

struct DrawnLiver {
  Eigen::VectorXd coefficients;  // of the modes, in standard deviations
  geometry::Surface surface;     // the model's points
  int attempts = 1;              // draws until one was a body: none of 400 to 5000 ml, none X
};

// The same model, seed and number give the same liver, whatever the number of threads. Each coefficient is normal,
// within three standard deviations. Fails with "shapes-cannot-draw" (100 draws gave no body).
Result<DrawnLiver> draw_liver(const ShapeModel& model, std::uint64_t seed, std::uint64_t number);

// Its tetrahedra, as those of any segmented liver (meshing/mesh_labels.h), by way of voxels of `spacing_mm`.
Result<meshing::LiverMesh> mesh_of(const DrawnLiver& liver, int target_cells = 20000, double spacing_mm = 3,
                                   const Progress& progress = {});

}  // namespace glisson::shapes
