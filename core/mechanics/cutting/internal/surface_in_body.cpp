#include "mechanics/cutting/internal/surface_in_body.h"

namespace glisson::mechanics {

std::shared_ptr<const SurfaceInBody> surface_in_body(const StaticModel& model, const Loads& standing_loads,
                                                     const CutStrip& first) {
  const Body& body = model.body();
  auto made = std::make_shared<SurfaceInBody>();
  made->surface = first.surface;
  made->crossing = crossing_of(body.mesh, first.surface);
  made->begin_mm = first.from_mm;
  made->forward = (first.to_mm - first.from_mm).normalized();
  const ReducedFunctions* reduced = model.reduced_functions();
  made->functions = reduced == nullptr ? point_jumps(body, made->crossing, made->begin_mm, made->forward)
                                       : split_functions(body, made->crossing, *reduced, made->begin_mm, made->forward);
  made->standing_load = made->functions->load_on(standing_loads);
  made->solved.resize(made->functions->points_of.size());
  return made;
}

}  // namespace glisson::mechanics
