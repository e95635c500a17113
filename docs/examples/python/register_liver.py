"""A liver onto a part of its deformed surface, judged where nothing was seen.   register_liver.py REST SEEN TRUTH METHOD ...

A METHOD is icp or geo. TRUTH is the deformed liver, point for point as REST. Prints the mean error over the whole liver.
"""
import sys

import numpy as np

import glisson

rest, seen, truth = (glisson.read_surface(file) for file in sys.argv[1:4])
off_mm = np.linalg.norm(rest.points_mm - truth.points_mm, axis=1)
print(f"before: {off_mm.mean():.1f} mm")
for method in sys.argv[4:]:
    registered = glisson.register_surfaces(rest, seen, method=method)
    off_mm = np.linalg.norm(registered["surface"].points_mm - truth.points_mm, axis=1)
    print(f"{method}: {off_mm.mean():.2f} mm, {off_mm.max():.1f} at most; {registered['rms_mm']:.2f} where it is seen")
