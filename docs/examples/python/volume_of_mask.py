"""How large is what was outlined?   volume_of_mask.py labels/liver.nrrd

Counts the voxels, and measures the smooth surface around them, which has no stairs.
"""
import sys

import glisson

outlined = glisson.read_mask_file(sys.argv[1])
mask = outlined.mask
counted_ml = mask.array.sum() * mask.voxel_volume_mm3 / 1000

surface = glisson.mask_surface(mask)
print(f"{outlined.name}: {mask.array.sum()} voxels are {counted_ml:.1f} ml; the surface around them encloses "
      f"{surface.volume_mm3 / 1000:.1f} ml and has {surface.area_mm2 / 100:.0f} cm2.")
sys.exit(0 if surface.is_watertight else 1)
