"""Which places of a registered video are not to be trusted, without any truth to compare with?

A patch of tissue breathes through 24 frames. Its registration is perfect but for a disc of 25 mm, where it slips now
and then by up to 12 mm. SIRGn sees landmarks alone, and is asked where the slip is.
"""
import numpy as np

import glisson

slipping_mm = np.array([30, 30])
side = np.arange(-60, 61, 4)
i, j = (grid.ravel() for grid in np.meshgrid(side, side, indexing="ij"))
rest_mm = np.stack([i, j, 0.002 * (i * i + j * j)], axis=1)
in_disc = np.hypot(*(rest_mm[:, :2] - slipping_mm).T) < 25
is_landmark = (i % 12 == 0) & (j % 12 == 0)  # every third point

frames, seen = [], []
for frame in range(24):
    cloud_mm = rest_mm + [0, 0, 8 * np.sin(0.7 * frame)]
    slip_mm = 12.0 * (frame * 7 % 4) / 3 if frame % 5 < 2 else 0
    frames.append((cloud_mm, rest_mm + np.outer(in_disc, [slip_mm, 0, 0])))
    seen.append(cloud_mm[is_landmark])
landmarks = {f"{k:03}": track for k, track in enumerate(np.swapaxes(seen, 0, 1))}

judged = glisson.sirgn(frames, landmarks)
middles_mm = judged["mesh"].points_mm[judged["mesh"].triangles].mean(axis=1)
from_slip_mm = np.hypot(*(middles_mm[:, :2] - slipping_mm).T)
slips = from_slip_mm < 25
print(f"SIRGn is {judged['correlation'][slips].mean():.2f} on average where the registration slips, "
      f"{judged['correlation'][~slips].mean():.2f} elsewhere.")
print(f"Most doubtful is the place {from_slip_mm[judged['doubt_mm'].argmax()]:.0f} mm from the middle of the slip.")
