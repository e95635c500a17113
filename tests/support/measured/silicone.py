#!/usr/bin/python3
"""Compression of a silicone cylinder as a material experiment: silicone.py OUT [--phantom EF10_75T] [--data DIR]

DIR is silicone_phantom_compression of the shared data (its SOURCE.txt says what was measured). Declared is the linear
law with the modulus of the first 10 % of strain, by least squares over the tests that are fitted; A1, A2, B1 and B2 are
fitted, A5 and B5 are held out. The noise is how far repeated tests of one specimen are apart: the standard deviation of
their stresses at equal strain, as a root mean square over strain.
"""

import json
import sys

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for

FITTED, HELD_OUT = ["A1", "A2", "B1", "B2"], ["A5", "B5"]


def recorded(file, every=8):
    """Time, engineering strain, engineering stress (kPa); both negative in compression."""
    rows = []
    for line in file.read_text(errors="replace").splitlines():
        try:
            rows.append([float(x) for x in line.split(",")[:5]])
        except ValueError:
            continue
    table = np.array([row for row in rows if len(row) == 5])
    return table[::every, 0], table[::every, 3], table[::every, 4]


def repeats_to(tests):
    strain = np.linspace(0.02, min(-test[1].min() for test in tests), 60)
    stresses = np.array([np.interp(strain, -test[1], test[2]) for test in tests])
    return float(np.sqrt(stresses.var(axis=0, ddof=1).mean()))


def main():
    asked = asked_for(__doc__, "silicone_phantom_compression",
                      lambda ask: ask.add_argument("--phantom", default="EF10_75T"))
    folder = asked.data / "data" / asked.phantom
    if not folder.is_dir():
        sys.exit(f"no tests at {folder}")
    tests = {name: recorded(folder / f"{asked.phantom}_{name}.csv") for name in FITTED + HELD_OUT}
    small = [(e, s) for name in FITTED for e, s in zip(*tests[name][1:]) if -e < 0.1]
    strains, stresses = np.array(small).T
    youngs = float(strains @ stresses / (strains @ strains))
    noise = float(np.sqrt(np.mean([repeats_to([tests[n] for n in FITTED if n[0] == s]) ** 2 for s in "AB"])))
    print(f"{asked.phantom}: {youngs:.2f} kPa over the first 10 %; tests of one specimen repeat to {noise:.3f} kPa")
    for name, (time, strain, stress) in tests.items():
        rows = "\n".join(f"{t:.3f},{1 + e:.6f},{s:.6f}" for t, e, s in zip(time, strain, stress))
        (asked.out / f"{name}.csv").write_text("time_s,stretch,stress_kPa\n" + rows + "\n")
    for file, names in (("experiment.json", FITTED), ("heldout.json", HELD_OUT)):
        (asked.out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "material", "title": f"Silicone {asked.phantom} in compression",
            "specimen": {"shape": "cylinder", "diameter_mm": 50, "height_mm": 30}, "mode": "compression",
            "declared": {"law": "linear", "youngs_modulus_kPa": round(youngs, 3)}, "noise_kPa": round(noise, 4),
            "trials": [{"id": n, "file": f"{n}.csv",
                        "columns": {"time_s": "time_s", "stretch": "stretch", "stress_kPa": "stress_kPa"}}
                       for n in names]}, indent=1) + "\n")


if __name__ == "__main__":
    main()
