#!/usr/bin/python3
"""Stress relaxation and load-unload of the elastomer VHB 4910 as a material experiment: elastomer.py OUT [--data DIR]

DIR is vhb4910_visco of the shared data (its SOURCE.txt says what was measured). Declared is the linear law with the
modulus of the first 10 % of strain of the load-unload tests that are fitted. Relaxation at stretch 1.5, 2 and 3 and the
load-unload tests at 0.01 and 0.03 1/s to 2 and 3 are fitted; relaxation at 3.5 and load-unload to 1.5 are held out. The
noise is 2 % of the largest stress: the tests are not repeated, and the load cell alone does far better.
"""

import json
import sys

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for

FITTED = ["relaxation/1d5", "relaxation/2d0", "relaxation/3d0", "load_unload/0d01_2d0", "load_unload/0d03_2d0",
          "load_unload/0d01_3d0"]
HELD_OUT = ["relaxation/3d5", "load_unload/0d01_1d5", "load_unload/0d03_1d5", "load_unload/0d03_3d0"]


def recorded(file, samples=150):
    """Time, stretch, nominal stress: evenly along the curve in time and in stretch, so that fast parts keep samples."""
    table = np.loadtxt(file, delimiter=",", skiprows=1)
    path = np.concatenate([[0], np.cumsum(np.abs(np.diff(table[:, 0])) / np.ptp(table[:, 0]) +
                                          np.abs(np.diff(table[:, 1])) / np.ptp(table[:, 1]))])
    kept = np.unique(np.searchsorted(path, np.linspace(0, path[-1], samples)))
    return table[kept]


def main():
    asked = asked_for(__doc__, "vhb4910_visco")
    tests = {name: recorded(asked.data / f"{name}.csv") for name in FITTED + HELD_OUT}
    small = np.vstack([t[(t[:, 1] < 1.1) & (t[:, 0] < 30)] for n, t in tests.items()
                       if n in FITTED and n.startswith("load")])
    youngs = float((small[:, 1] - 1) @ small[:, 2] / ((small[:, 1] - 1) @ (small[:, 1] - 1)))
    noise = 0.02 * max(float(tests[n][:, 2].max()) for n in FITTED)
    print(f"{youngs:.1f} kPa over the first 10 %; noise {noise:.2f} kPa")
    for name, table in tests.items():
        rows = "\n".join(f"{t:.3f},{x:.6f},{s:.6f}" for t, x, s in table)
        (asked.out / f"{name.replace('/', '-')}.csv").write_text("time_s,stretch,stress_kPa\n" + rows + "\n")
    for file, names in (("experiment.json", FITTED), ("heldout.json", HELD_OUT)):
        (asked.out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "material", "title": "Elastomer VHB 4910 in tension",
            "specimen": {"length_mm": 80, "area_mm2": 22}, "mode": "tension",
            "declared": {"law": "linear", "youngs_modulus_kPa": round(youngs, 2)}, "noise_kPa": round(noise, 3),
            "trials": [{"id": n, "file": f"{n.replace('/', '-')}.csv",
                        "columns": {"time_s": "time_s", "stretch": "stretch", "stress_kPa": "stress_kPa"}}
                       for n in names]}, indent=1) + "\n")


if __name__ == "__main__":
    main()
