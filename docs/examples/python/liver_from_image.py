"""A liver out of an image, as tetrahedra with a stiffness.   liver_from_image.py IMAGE X Y Z OUT.vtu

X Y Z lies in the liver: patient coordinates (LPS), mm.
"""
import sys

import numpy as np

import glisson

image = glisson.read_volume_file(sys.argv[1])
grown = glisson.grow_from_seeds(image, [[float(word) for word in sys.argv[2:5]]])
print(f"{grown.volume_ml:.0f} ml;", *grown.doubts or ["no doubts"])

body = glisson.mesh_labels(grown.mask, target_cells=3000).body
youngs_kPa = np.full(len(body.cells), 6.1)
stiff = body.with_fields(cell_fields={"youngs_modulus_kPa": youngs_kPa})
print(f"{len(stiff.cells)} tetrahedra, {stiff.volume_mm3 / 1000:.0f} ml")
glisson.write_tetrahedra(sys.argv[5], stiff)
