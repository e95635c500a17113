"""Noise of an experiment, as stated or otherwise than its file says: 0.7 or 1.5 times as large, repeating itself from sample
to sample (half of each error is kept, of the stated size in all), or with one in a hundred ten times as large."""

import numpy as np

KINDS = ("stated", "x0.7", "x1.5", "correlated", "outliers")
KEPT = 0.5
OUTLIERS, AS_LARGE = 0.01, 10


def noise(rng, stated, shape, kind="stated"):
    """Along the first axis of `shape` time passes."""
    white = rng.normal(0, stated, shape)
    if kind == "correlated":
        for k in range(1, len(white)):
            white[k] = KEPT * white[k - 1] + np.sqrt(1 - KEPT ** 2) * white[k]
        return white
    if kind == "outliers":
        return white * np.where(rng.random(shape) < OUTLIERS, AS_LARGE, 1)
    return white * {"stated": 1, "x0.7": 0.7, "x1.5": 1.5}[kind]
