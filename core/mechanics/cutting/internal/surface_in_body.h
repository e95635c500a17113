#pragma once
// One surface along which a body may open, with what was solved for on it.

#include <Eigen/SparseCore>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "mechanics/cutting/cut_strip.h"
#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/body.h"

namespace glisson::mechanics {

struct SurfaceInBody;

// What was solved for of one point.
struct SolvedPoint {
  Eigen::MatrixXd v;  // its columns of V
  Eigen::Vector3d standing_load;
  // B^T K^-1 of its columns of B, 3 rows a candidate of each surface that there was.
  std::vector<std::pair<const SurfaceInBody*, Eigen::MatrixXd>> products;
  double relative_residual = 0;
};

// One surface wherever it crosses the body. Its candidates are the points that may open, in the order in which the
// first strip's front comes to them. They are solved for in fixed groups, so that what is solved does not depend on who
// asked first.
struct SurfaceInBody {
  geometry::CutSurface surface;
  Crossing crossing;
  std::vector<int> candidates;           // points of the mesh
  std::vector<double> at_mm;             // of each, along the first strip
  Eigen::SparseMatrix<double> coupling;  // their columns of B
  Eigen::Vector3d begin_mm, forward;     // of the first strip

  mutable std::mutex mutex;  // what is solved grows behind it
  mutable std::vector<std::shared_ptr<const SolvedPoint>> solved;
};

// Points that are fixed stay together, and so do those whose function would fill next to nothing of their cells.
[[nodiscard]] std::shared_ptr<const SurfaceInBody> surface_in_body(const Body& body, const CutStrip& first);

}  // namespace glisson::mechanics
