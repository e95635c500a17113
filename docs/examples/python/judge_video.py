"""Which registration of a video is better, and where neither is to be trusted?   judge_video.py SEQUENCE.json METHOD ...

A METHOD is given, icp, geo or gnra. Prints SIRGn's figures for each: mean correlation, share of triangles rejected at
5 mm, root mean square error and target registration error over the frames.
"""
import sys

import numpy as np

import glisson

for method in sys.argv[2:]:
    judged = glisson.sirgn_of_sequence(sys.argv[1], method, tolerances_mm=[5])
    print(f"{method}: correlation {judged['mean_correlation']:.3f}, {100 * judged['rejected_fraction'][0]:.1f} % rejected at "
          f"5 mm, RMSE {np.mean(judged['rmse_mm']):.2f} mm, TRE {np.mean(judged['tre_mm']):.2f} mm")
