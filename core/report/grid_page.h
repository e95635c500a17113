#pragma once
// Figures 6.7 to 6.9 of the dissertation as a page. They show a device over liver volume and resolution, and what an
// iteration costs each device over the nodes.

#include <vector>

#include "hardware/grid.h"
#include "report/page.h"

namespace glisson::report {

struct GridAtRate {
  double frames_per_s = 0;
  hardware::DeviceSurfaces surfaces;
};

// `devices` are those of figure 6.8, the one of the surfaces among them or not. The request's rate is not read.
[[nodiscard]] Page grid_page(const hardware::Device& device, const std::vector<GridAtRate>& at,
                             const std::vector<hardware::Device>& devices, const hardware::PlanRequest& request);

}  // namespace glisson::report
