// How large is what was outlined?
//
//   volume_of_mask labels/liver.nrrd
//
// Counts the voxels, and measures the smooth surface around them, which has no stairs.

#include <algorithm>

#include "base/units.h"
#include "geometry/surface.h"
#include "imaging/volume_file.h"
#include "meshing/mask_surface.h"
#include "or_stop.h"

using namespace glisson;

int main(int count, char** words) {
  if (count != 2) {
    fmt::print(stderr, "usage: volume_of_mask MASK.nrrd\n");
    return 2;
  }
  const auto outlined = or_stop(imaging::read_mask_file(words[1]));
  const imaging::Mask& mask = outlined.mask;
  const auto voxels = std::count(mask.values.begin(), mask.values.end(), 1);
  const double counted_ml = units::ml_from_mm3(static_cast<double>(voxels) * mask.grid.voxel_volume_mm3());

  const auto surface = or_stop(meshing::mask_surface(mask, meshing::organ_smoothing));
  const double enclosed_ml = units::ml_from_mm3(geometry::volume_mm3(surface));
  fmt::print("{}: {} voxels are {:.1f} ml; the surface around them encloses {:.1f} ml and has {:.0f} cm2.\n",
             outlined.info.name, voxels, counted_ml, enclosed_ml, geometry::area_mm2(surface) / 100);
  return geometry::is_watertight(surface) ? 0 : 1;
}
