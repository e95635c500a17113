#!/usr/bin/python3
"""What an organ's unknown stiffness does to `glisson-cli guide`: cases are answered again with moduli that are off.

    tests/support/guidance_stiffness.py GLISSON_CLI CASE [CASE ...]

A CASE is a folder with guidance.json. Moduli are multiplied by a log-normal field of a given
spread, alike over some 25 mm, three draws each. For each spread: how far the answered targets move, and how large their
stated standard deviations are, without stiffness in them. SIMULATED.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import meshio
import numpy as np

ALIKE_OVER_MM = 25
DRAWS = 3


def targets(program, case):
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([program, "guide", case / "guidance.json", "--out", out, "--json", "--quiet"],
                              check=True, capture_output=True, text=True)
    found = [target for frame in json.loads(done.stdout)["frames"] for target in frame["targets"]]
    return np.array([t["position_mm"] for t in found]), np.array([t["sd_mm"] for t in found])


def smooth_field(places_mm, random):
    """Of mean 0 and variance 1: a sum of waves."""
    waves = 200
    k = random.normal(size=(waves, 3)) / ALIKE_OVER_MM
    return np.sqrt(2 / waves) * np.cos(places_mm @ k.T + random.uniform(0, 2 * np.pi, waves)).sum(axis=1)


def with_other_moduli(case, spread, random, where):
    shutil.copytree(case, where, copy_function=shutil.copyfile)
    where.chmod(0o755)
    asked = json.loads((case / "guidance.json").read_text())
    mesh = meshio.read(case / asked["model"]["mesh"])
    cells = mesh.cells_dict["tetra"]
    known = asked["model"]["youngs_modulus_kPa"]  # a number, or the name of a field
    known = mesh.cell_data[known][0] if isinstance(known, str) else known
    moduli = known * np.exp(spread * smooth_field(mesh.points[cells].mean(axis=1), random))
    meshio.write(where / asked["model"]["mesh"],
                 meshio.Mesh(mesh.points, [("tetra", cells)], cell_data={"youngs_kPa": [moduli]}))
    asked["model"]["youngs_modulus_kPa"] = "youngs_kPa"
    (where / "guidance.json").write_text(json.dumps(asked))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, cases = sys.argv[1], [pathlib.Path(case) for case in sys.argv[2:]]
    as_stated = [targets(program, case) for case in cases]
    for spread in (0.15, 0.3, 0.6):
        moved = []
        for number, (case, (at_mm, _)) in enumerate(zip(cases, as_stated)):
            for draw in range(DRAWS):
                with tempfile.TemporaryDirectory() as folder:
                    where = pathlib.Path(folder) / "case"
                    with_other_moduli(case, spread, np.random.default_rng([number, draw]), where)
                    moved.extend(np.linalg.norm(targets(program, where)[0] - at_mm, axis=1))
        print(f"moduli off by {spread:.0%}: targets move by {np.mean(moved):.2f} mm on average, "
              f"{np.percentile(moved, 90):.2f} at the 90th percentile, {np.max(moved):.2f} at most")
    stated = np.concatenate([sd for _, sd in as_stated])
    print(f"stated without: {np.mean(stated):.2f} mm on average, {len(stated)} targets of {len(cases)} cases")


if __name__ == "__main__":
    main()
