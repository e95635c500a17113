#!/usr/bin/python3
"""What the makers of palpations put on a body is what they say: gas presses evenly on all of its surface, boxes and round
bodies and pieces of generated livers alike. undeclared_makers.py GLISSON_CLI; exit code 77 where numpy is not installed."""

import itertools
import os
import pathlib
import sys
from types import SimpleNamespace

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support" / "undeclared"))
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
try:
    import numpy as np
except ModuleNotFoundError:
    print("skipped: numpy is not installed")
    sys.exit(77)

from generated_liver import liver
from palpation import Effects, preload
from shape_functions import brick_values
from specimens import block, brick_mesh, lobe, pillar


def main():
    os.environ["GLISSON_CLI"] = sys.argv[1]
    for body in (block((45, 45, 30), (2, 2, 1)), pillar(60, 40, (8, 8, 4)), lobe(110, 80, 45, (12, 9, 4)),
                 liver(5, (8, 6, 4))):
        presses_evenly(body.name, brick_mesh(body, (6, 5, 4)))


def presses_evenly(name, mesh, pressure_kPa=0.7):
    """An even pressure p on a closed surface has no resultant, and sum f . x = -3 p V. The volume comes from the elements."""
    load = preload(SimpleNamespace(truth=mesh, footprints={}), Effects(pressure_kPa=pressure_kPa)).nodes
    largest = np.abs(load).sum()
    volume = volume_of(mesh)
    found = -(load * mesh.points).sum() / (3 * pressure_kPa)
    print(f"{name}: {volume:.0f} mm3, {found:.0f} by the forces of gas")
    assert np.abs(load.sum(axis=0)).max() < 1e-9 * largest, f"{name}: gas moves it"
    assert abs(found - volume) < 1e-6 * volume, f"{name}: gas does not press on the surface that the elements have"


def volume_of(mesh):
    """Of the bricks, by Gauss's rule."""
    line = [(-np.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (np.sqrt(0.6), 5 / 9)]
    total = 0.0
    for (x, a), (y, b), (z, c) in itertools.product(line, repeat=3):
        slope = [np.einsum("k,nkd->nd", (brick_values(np.array([[x, y, z]]) + step)
                                         - brick_values(np.array([[x, y, z]]) - step))[0] / 2e-5,
                           mesh.points[mesh.elements]) for step in 1e-5 * np.eye(3)]
        total += a * b * c * np.linalg.det(np.stack(slope, axis=1)).sum()
    return total


if __name__ == "__main__":
    main()
