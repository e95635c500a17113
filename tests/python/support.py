"""What the tests of the package share: numpy or a skip, and a ball of tissue."""
import os
import pathlib
import sys
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not there (python3-numpy)")
    sys.exit(77)
import glisson

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA", ROOT.parent / "shared" / "data"))


def ball(size=32, radius_mm=24.0, spacing_mm=2.0):
    """A Mask: a ball about the middle of the grid, which is at the origin."""
    middle = (size - 1) / 2
    axis = (np.arange(size) - middle) * spacing_mm
    i, j, k = np.meshgrid(axis, axis, axis, indexing="ij")
    return glisson.Mask(i**2 + j**2 + k**2 < radius_mm**2, spacing_mm=[spacing_mm] * 3, origin_mm=[-middle * spacing_mm] * 3)


class Case(unittest.TestCase):
    def assertRefused(self, code, call, *arguments, **named):
        """The call raises glisson.Error of that code; the error is answered."""
        with self.assertRaises(glisson.Error) as caught:
            call(*arguments, **named)
        self.assertEqual(caught.exception.code, code)
        return caught.exception
