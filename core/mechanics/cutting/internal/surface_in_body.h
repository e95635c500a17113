#pragma once
// One surface along which a body may open, with what was solved for on it.

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "base/result.h"
#include "mechanics/cutting/cut_strip.h"
#include "mechanics/cutting/internal/opening_functions.h"

namespace glisson::mechanics {

struct SurfaceInBody;

// What was solved for of one function.
struct SolvedFunction {
  Eigen::MatrixXd v;  // its columns of V
  Eigen::VectorXd standing_load;
  // B^T K^-1 of its columns of B, rows of all functions of each surface that there was, by its number.
  std::vector<std::pair<std::uint64_t, Eigen::MatrixXd>> products;
  double relative_residual = 0;
};

// One surface wherever it crosses the body, with its functions in the order in which the first strip's front comes to
// them. They are solved for in fixed groups, so that what is solved does not depend on who asked first.
struct SurfaceInBody {
  std::uint64_t number;  // no other has it, also after it is gone
  geometry::CutSurface surface;
  Crossing crossing;
  std::unique_ptr<const OpeningFunctions> functions;
  Eigen::VectorXd standing_load;      // on all their amplitudes (mN)
  Eigen::Vector3d begin_mm, forward;  // of the first strip

  mutable std::mutex mutex;  // what is solved grows behind it
  mutable std::vector<std::shared_ptr<const SolvedFunction>> solved;
};

// The model must outlive it.
[[nodiscard]] std::shared_ptr<const SurfaceInBody> surface_in_body(const StaticModel& model,
                                                                   const Loads& standing_loads, const CutStrip& first);

// A swept line drawn further. Cells around the points that are open stay as they are to the bit, and so does all that
// was solved for of those points. Ahead of them the line is followed. Of finite elements only. Failure: "cut-turns",
// where the cells that stay do not lead along the strip to half a mean edge, or have a wall that crosses it.
Result<std::shared_ptr<const SurfaceInBody>> grown_surface(const StaticModel& model, const Loads& standing_loads,
                                                           const SurfaceInBody& before, const std::vector<int>& open,
                                                           const CutStrip& strip);

}  // namespace glisson::mechanics
