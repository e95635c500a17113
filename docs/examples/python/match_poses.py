"""One shape in two poses, matched by geodesic distance alone.   match_poses.py FROM TO

Both have the same points in the same order. Prints how far matches are off along the surface, over the square root of its
area, how far the best match there could be is, and the share within 5, 10, 15 and 25 %.
"""
import sys

import numpy as np

import glisson

source, target = (glisson.read_surface(file) for file in sys.argv[1:3])
match = glisson.match_surfaces(source, target)
a, b, c = np.moveaxis(target.points_mm[target.triangles], 1, 0)
size_mm = np.sqrt(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
from_samples = match.target_distances_mm[:, match.source_points] / size_mm  # where each point truly lies
chosen = [list(match.target_samples).index(point) for point in match.target_points]
off = from_samples[chosen, np.arange(len(chosen))]
within = [f"{100 * (off <= limit).mean():.0f}" for limit in (0.05, 0.1, 0.15, 0.25)]
print(f"{100 * off.mean():.1f} %, sampling {100 * from_samples.min(axis=0).mean():.1f} %, within {' '.join(within)}")
