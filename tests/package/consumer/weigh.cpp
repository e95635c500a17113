// Uses three rooms of the core and their libraries: a mask (imaging), its surface (meshing), its volume (geometry).

#include <fmt/format.h>

#include "base/units.h"
#include "geometry/surface.h"
#include "meshing/mask_surface.h"

int main() {
  glisson::imaging::Mask cube;
  cube.grid.size = {24, 24, 24};
  cube.values.assign(cube.grid.voxels(), 0);
  for (int k = 2; k < 22; ++k)
    for (int j = 2; j < 22; ++j)
      for (int i = 2; i < 22; ++i) cube.at(i, j, k) = 1;

  const auto surface = glisson::meshing::mask_surface(cube);
  if (!surface || !glisson::geometry::is_watertight(*surface)) return 1;
  fmt::print("A cube of 20 mm: {:.1f} ml, 2 kPa in shear is {:.2f} kPa in tension.\n",
             glisson::units::ml_from_mm3(glisson::geometry::volume_mm3(*surface)),
             glisson::units::youngs_from_shear(2.0, 0.495));
}
