#!/usr/bin/python3
"""Are the plates by which `explain` is judged those of their laws? The solver of tests/support/undeclared/plane.py beside CalculiX, on
the same quadratic triangles: displacements and forces of a plate with a hole, pulled by a quarter, under every law that CalculiX has.
The laws that it has not are held to their energies by differences."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support" / "undeclared"))
try:
    import numpy as np

    from make_plane import arruda_boyce, laws
    from plane import Plate, isochoric, ogden
except ModuleNotFoundError as missing:
    print(f"skipped: {missing.name} is not installed")
    sys.exit(77)

PULL = (0.24, 0.09)
C, D = 0.5, 1.5  # of the shear and of the volume


def main():
    stresses_are_slopes_of_energies()
    if shutil.which("ccx") is None:
        print("skipped: CalculiX (ccx) is not installed")
        sys.exit(77)
    plate = Plate((0.25, 0.2), 1.0, 10, 8, True)
    for name, (material, law) in known_to_calculix().items():
        theirs, forces_of_theirs = by_calculix(plate, material)
        ours, forces_of_ours = plate.pulled(law, *PULL)
        off = np.abs(ours.reshape(-1, 2) - theirs).max() / np.abs(theirs).max()
        forces_off = max(abs(forces_of_ours[side] - force) for side, force in forces_of_theirs.items())
        print(f"{name}: displacements off by {off:.1e} of the largest, forces by {forces_off:.1e}")
        assert off < 2e-6 and forces_off < 2e-6, name  # CalculiX prints seven digits


# CalculiX.

def known_to_calculix():
    """{name: (its cards, P(F))}"""
    volume = lambda j: 2 * D * (j - 1)
    constant = lambda value: lambda k1, k2: value + 0 * k1
    hyperelastic = lambda card, *numbers: ["*MATERIAL, NAME=PLATE", f"*HYPERELASTIC, {card}", *numbers]
    inverse = f"{1 / D:.12g}"
    angle, k1, k2 = 35.0, 0.8, 0.9
    x, y = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    fibres = lambda i: np.where(np.real(i) > 1, k1 * (i - 1) * np.exp(k2 * (i - 1) ** 2), 0)  # its fibres bear no pressure
    return {
        "neo-hookean": (hyperelastic("NEO HOOKE", f"{C}, {inverse}"), isochoric(constant(C), constant(0), volume)),
        "mooney-rivlin": (hyperelastic("MOONEY-RIVLIN", f"{C}, 0.4, {inverse}"), isochoric(constant(C), constant(0.4), volume)),
        "isihara": (hyperelastic("POLYNOMIAL, N=2", f"{C}, 0.6, 0.7, 0., 0., {inverse}, 1e9"),
                    isochoric(lambda a, b: C + 1.4 * a, constant(0.6), volume)),
        "yeoh": (hyperelastic("YEOH", f"{C}, -0.08, 0.07, {inverse}, 1e9, 1e9"),
                 isochoric(lambda a, b: C - 0.16 * a + 0.21 * a ** 2, constant(0), volume)),
        "haines-wilson": (hyperelastic("POLYNOMIAL, N=3", f"{C}, 0.6, 0., 0.5, 0., 0.2, 0., 0.,", f"0., {inverse}, 1e9, 1e9"),
                          isochoric(lambda a, b: C + 0.5 * b + 0.6 * a ** 2, lambda a, b: 0.6 + 0.5 * a, volume)),
        "ogden": (hyperelastic("OGDEN, N=1", f"{2 * C}, 5., {inverse}"), ogden(2 * C, 5.0, volume)),
        # Its Arruda-Boyce has another part of the volume.
        "arruda-boyce": (hyperelastic("ARRUDA-BOYCE", f"{2 * C}, {2 ** 0.5:.12g}, {inverse}"),
                         isochoric(arruda_boyce(2 * C, 2.0), constant(0), lambda j: D * (j - 1 / j))),
        "holzapfel": (["*MATERIAL, NAME=ELASTIC_FIBER_PLATE", "*USER MATERIAL, CONSTANTS=10",
                       f"{C}, {inverse}, {x:.12g}, {y:.12g}, {k1}, {k2}, {x:.12g}, {-y:.12g}", f"{k1}, {k2}"],
                      isochoric(constant(C), constant(0), volume, fibres, [angle, -angle])),
    }


def by_calculix(plate, material):
    """Displacements, a row a point, and {side: its force along what is prescribed}."""
    lines = ["*NODE, NSET=NALL"] + [f"{i}, {x:.12g}, {y:.12g}, 0" for i, (x, y) in enumerate(plate.points, 1)]
    lines += ["*ELEMENT, TYPE=CPE6, ELSET=BODY"]
    lines += [", ".join(map(str, [e, *(t + 1)])) for e, t in enumerate(plate.triangles, 1)]
    directions = {"left": 1, "right": 1, "bottom": 2, "top": 2}
    for side in directions:
        lines += [f"*NSET, NSET={side.upper()}"] + [f"{p + 1}," for p in plate.side(side)]
    lines += [*material, f"*SOLID SECTION, ELSET=BODY, MATERIAL={material[0].split('=')[1]}", "1."]
    lines += ["*STEP, NLGEOM, INC=500", "*STATIC", "0.1, 1., 1e-4, 0.2", "*BOUNDARY"]
    lines += [f"{side.upper()}, {directions[side]}, {directions[side]}, {move}"
              for side, move in (("left", 0.0), ("bottom", 0.0), ("right", PULL[0]), ("top", PULL[1]))]
    lines += ["*NODE PRINT, NSET=NALL, FREQUENCY=999", "U"]
    for side in directions:
        lines += [f"*NODE PRINT, NSET={side.upper()}, TOTALS=ONLY, FREQUENCY=999", "RF"]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "plate.inp").write_text("\n".join([*lines, "*END STEP"]) + "\n")
        done = subprocess.run(["ccx", "plate"], cwd=folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        printed = (pathlib.Path(folder) / "plate.dat").read_text()
    assert "*ERROR" not in done.stdout and "time  0.1000000E+01" in printed, done.stdout[-1500:]
    rows = [[float(word) for word in line.split()] for line in printed.splitlines() if line.strip() and ":" not in line
            and "f" not in line]
    moves = np.array([row[1:3] for row in rows if len(row) == 4])
    totals = [row for row in rows if len(row) == 3]
    return moves, {side: total[directions[side] - 1] for side, total in zip(directions, totals)}


# What CalculiX has not.

def stresses_are_slopes_of_energies():
    """Of energies written down here, at random states."""
    rng = np.random.default_rng(5)
    made = laws(rng)
    energies = {
        "gent-thomas": lambda n, k1, k2, j, along: n["C10"] * k1 + n["C2"] * np.log((k2 + 3) / 3),
        "gent": lambda n, k1, k2, j, along: -n["C10"] * n["Jm"] * np.log(1 - k1 / n["Jm"]),
        "fibre": lambda n, k1, k2, j, along: n["C10"] * k1 + n["k"] * (along - 1) ** 2,
        "fung": lambda n, k1, k2, j, along: n["C10"] * integral(lambda x: np.exp(n["b"] * x ** 2), k1),
        "volume": lambda n, k1, k2, j, along: n["C10"] * k1
        + 2 * n["D"] / n["power"] * ((j ** (n["power"] + 1) - 1) / (n["power"] + 1) - np.log(j))}
    f = np.array([1.0, 0, 0, 1]) + rng.uniform(-0.2, 0.2, (20, 4))
    for name, energy in energies.items():
        stress, numbers = made[name]

        def whole(f):
            j = f[:, 0] * f[:, 3] - f[:, 1] * f[:, 2]
            i1 = (f ** 2).sum(1) + 1
            angle = np.deg2rad(numbers.get("angle_deg", 0))
            stretched = f.reshape(-1, 2, 2) @ [np.cos(angle), np.sin(angle)]
            invariants = i1 * j ** (-2 / 3) - 3, (i1 + j ** 2 - 1) * j ** (-4 / 3) - 3, j, (stretched ** 2).sum(1) * j ** (-2 / 3)
            return energy(numbers, *invariants) + (0 if name == "volume" else numbers["D"] * (j - 1) ** 2)

        slopes = np.stack([whole(f + 1e-30j * np.eye(4)[i]).imag / 1e-30 for i in range(4)], -1)
        assert np.abs(stress(f) - slopes).max() < 1e-8 * np.abs(slopes).max(), name


def integral(slope, end):
    """From 0, by Gauss's rule of forty places."""
    places, weights = np.polynomial.legendre.leggauss(40)
    return sum(w * slope(end * (1 + x) / 2) for x, w in zip(places, weights)) * end / 2


if __name__ == "__main__":
    main()
