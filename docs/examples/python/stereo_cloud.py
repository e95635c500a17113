"""A pair of a laparoscope's pictures to points.   stereo_cloud.py CALIBRATION LEFT.png RIGHT.png OUT.ply

Prints how many points were seen, and of what share of the picture that is neither border nor highlight.
"""
import sys

import numpy as np

import glisson

camera = glisson.read_calibration(sys.argv[1])
left, right = (glisson.read_picture(file) for file in sys.argv[2:4])
cloud = glisson.stereo_cloud(left, right, camera)
points_mm = cloud["surface"].points_mm
print(f"{len(points_mm):,} points, {100 * cloud['valid_fraction']:.0f} % seen, {np.median(points_mm[:, 2]):.0f} mm away; "
      f"the eyes are {camera.baseline_mm:.1f} mm apart")
glisson.write_surface(sys.argv[4], cloud["surface"])
