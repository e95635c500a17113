#!/usr/bin/python3
"""Makes full-field experiments of plates whose law is not the declared one: make_plane.py OUT [--laws a,b] [--levels low,high]
[--seed N]. A plate with an elliptic hole is pulled in two directions by a solver of its own (plane.py: quadratic triangles on
another mesh than the one that is declared), its points are seen with white noise, its forces with a load cell's. Two levels of
noise, those of the published plates (Joshi and others 2022): displacements of 1e-4 and 1e-3 of the plate's width, forces of a
two-thousandth and of two thousandths of the largest. Declared is a neo-Hookean law, softer than what was made; `null` is what
it says. heldout.json has other ratios of the two pulls. A case is named by its law, level and seed."""

import argparse
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

from plane import Plate, isochoric, neo_hookean, ogden, write_plane

LEVELS = {"low": (1e-4, 5e-4), "high": (1e-3, 2e-3)}  # of displacements in widths, of forces as a share of the largest
PULLS = [(0.08, 0.03), (0.16, 0.06), (0.24, 0.09), (0.05, 0.12), (0.1, 0.24)]  # of right and top, in widths
UNSEEN = [(0.16, 0.16), (0.22, 0.0)]


def between(rng, low, high):
    return float(rng.uniform(low, high))


def arruda_boyce(mu, n):
    terms = [1 / 2, 1 / 20 / n, 11 / 1050 / n ** 2, 19 / 7000 / n ** 3, 519 / 673750 / n ** 4]
    return lambda k1, k2: mu * sum((i + 1) * t * (k1 + 3) ** i for i, t in enumerate(terms))


def laws(rng):
    """{name: (P(F), parameters)}; each with a volume term d (J - 1)^2 but where another is the point."""
    c, d = between(rng, 0.4, 0.7), between(rng, 1, 2)
    volume = lambda j: 2 * d * (j - 1)
    none = lambda k1, k2: 0 * k1
    own = {
        "neo-hookean": dict(),
        "mooney-rivlin": dict(C01=between(rng, 0.3, 0.6)),
        "gent-thomas": dict(C2=between(rng, 0.6, 1.2)),
        "isihara": dict(C01=between(rng, 0.4, 1), C20=between(rng, 0.5, 1)),
        "yeoh": dict(C20=between(rng, -0.1, -0.05), C30=between(rng, 0.05, 0.1)),
        "haines-wilson": dict(C01=between(rng, 0.5, 1), C11=between(rng, 0.4, 0.8), C30=between(rng, 0.15, 0.3)),
        "gent": dict(Jm=between(rng, 2, 4)),
        "arruda-boyce": dict(N=between(rng, 1.5, 2.5)),
        "ogden": dict(alpha=between(rng, 4, 6)),
        "fibre": dict(k=between(rng, 0.3, 0.6), angle_deg=between(rng, 20, 70)),
        "holzapfel": dict(k1=between(rng, 0.6, 1), k2=between(rng, 0.6, 1), angle_deg=between(rng, 25, 40)),
        "fung": dict(b=between(rng, 2, 3)),
        "volume": dict(power=between(rng, 4, 6)),
    }
    n = {k: v for one in own.values() for k, v in one.items()}
    made = {
        "neo-hookean": isochoric(lambda k1, k2: c + 0 * k1, none, volume),
        "mooney-rivlin": isochoric(lambda k1, k2: c + 0 * k1, lambda k1, k2: own["mooney-rivlin"]["C01"] + 0 * k1, volume),
        "gent-thomas": isochoric(lambda k1, k2: c + 0 * k1, lambda k1, k2: n["C2"] / (k2 + 3), volume),
        "isihara": isochoric(lambda k1, k2: c + 2 * own["isihara"]["C20"] * k1,
                             lambda k1, k2: own["isihara"]["C01"] + 0 * k1, volume),
        "yeoh": isochoric(lambda k1, k2: c + 2 * own["yeoh"]["C20"] * k1 + 3 * own["yeoh"]["C30"] * k1 ** 2, none, volume),
        "haines-wilson": isochoric(lambda k1, k2: c + n["C11"] * k2 + 3 * own["haines-wilson"]["C30"] * k1 ** 2,
                                   lambda k1, k2: own["haines-wilson"]["C01"] + n["C11"] * k1, volume),
        "gent": isochoric(lambda k1, k2: c / (1 - k1 / n["Jm"]), none, volume),
        "arruda-boyce": isochoric(arruda_boyce(2 * c, n["N"]), none, volume),
        "ogden": ogden(2 * c, n["alpha"], volume),
        "fibre": isochoric(lambda k1, k2: c + 0 * k1, none, volume, lambda i: 2 * n["k"] * (i - 1),
                           [own["fibre"]["angle_deg"]]),
        "holzapfel": isochoric(lambda k1, k2: c + 0 * k1, none, volume,
                               lambda i: n["k1"] * (i - 1) * np.exp(n["k2"] * (i - 1) ** 2),
                               [own["holzapfel"]["angle_deg"], -own["holzapfel"]["angle_deg"]]),
        # Outside of the library: Fung's exponential, a volume that stiffens by a power.
        "fung": isochoric(lambda k1, k2: c * np.exp(n["b"] * k1 ** 2), none, volume),
        "volume": isochoric(lambda k1, k2: c + 0 * k1, none, lambda j: 2 * d / n["power"] * (j ** n["power"] - 1 / j)),
    }
    return {name: (law, dict(C10=c, D=d, **own[name])) for name, law in made.items()}


# What is no law at all: stiffness that differs from place to place, and stress that relaxes while the plate is held.
OUTSIDE = ["graded", "relaxing", "fung", "volume"]
INSIDE = ["null", "stiffness-scale", "neo-hookean", "mooney-rivlin", "gent-thomas", "isihara", "yeoh", "haines-wilson", "gent",
          "arruda-boyce", "ogden", "fibre", "holzapfel"]


def graded(places):
    """A stiff region beside the hole."""
    return 1 + 1.5 / (1 + np.exp(30 * (np.hypot(places[..., 0] - 0.75, places[..., 1] - 0.3) - 0.2)))


def make(out, name, level, seed):
    folder = out / f"plate-{name}-{level}-s{seed}"
    if (folder / "truth.json").exists():
        return
    rng = np.random.default_rng([seed, *map(ord, name + level)])
    radii, height = (between(rng, 0.15, 0.3), between(rng, 0.15, 0.3)), between(rng, 0.9, 1.1)
    known = laws(rng)
    law, numbers = known[name if name in known else "neo-hookean"]
    body = Plate(radii, height, 29, 26, True, *([graded] if name == "graded" else []))
    declared_mesh = Plate(radii, height, 26, 23, False)
    seen = body.interpolation(declared_mesh.points)
    states = {}
    for pull in sorted([*PULLS, *UNSEEN], key=sum):
        near = min(states, key=lambda other: np.hypot(other[0] - pull[0], other[1] - pull[1]), default=None)
        states[pull] = body.pulled(law, *pull, None if near is None else states[near][0])
    noise, share = LEVELS[level]
    force_noise = share * max(abs(f) for p in PULLS for f in states[p][1].values())
    folder.mkdir(parents=True, exist_ok=True)
    write_plane(folder / "plate.vtu", declared_mesh.points, declared_mesh.triangles)
    trials = {"experiment.json": [], "heldout.json": []}
    for k, pull in enumerate([*PULLS, *UNSEEN]):
        u, forces = states[pull]
        relaxed = 1 - 0.12 * (1 - np.exp(-k / 2)) if name == "relaxing" else 1.0
        field = seen @ u.reshape(-1, 2)
        field = field + rng.normal(0, noise, field.shape)
        (folder / f"l{k}.csv").write_text("point,ux,uy\n" + "".join("%d,%.9g,%.9g\n" % (i, *p) for i, p in enumerate(field)))
        rows = {side: relaxed * force + rng.normal(0, force_noise) for side, force in forces.items()}
        (folder / f"r{k}.csv").write_text("boundary,fx,fy\n" + "".join(
            f"{side},{force:.9g},\n" if side in ("left", "right") else f"{side},,{force:.9g}\n" for side, force in rows.items()))
        trials["experiment.json" if k < len(PULLS) else "heldout.json"].append(
            {"id": f"p{k}", "displacement": f"l{k}.csv", "reactions": f"r{k}.csv"})
    softer = {"null": 1.0, "stiffness-scale": 0.85}.get(name, 0.8)
    more = {"null": 1.0, "stiffness-scale": 0.85}.get(name, 1.1)
    for file, chosen in trials.items():
        (folder / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "full-field", "title": folder.name,
            "specimen": {"mesh": "plate.vtu", "thickness": 1, "state": "plane-strain"},
            "declared": {"law": "neo-hookean", "C10": numbers["C10"] * softer, "D": numbers["D"] * more},
            "noise": round(noise, 9), "noise_reaction": round(force_noise, 9), "trials": chosen}, indent=1) + "\n")
    (folder / "truth.json").write_text(json.dumps({
        "kinds": [] if name == "null" else [name], "outside": name in OUTSIDE, "parameters": numbers, "level": level},
        indent=1) + "\n")
    print(f"{folder.name}: a noise of {noise:.2g}, of forces {force_noise:.2g}", flush=True)


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("out", type=pathlib.Path)
    ask.add_argument("--laws", default=",".join([*INSIDE, *OUTSIDE]))
    ask.add_argument("--levels", default="low,high")
    ask.add_argument("--seed", type=int, default=1)
    asked = ask.parse_args()
    for level in asked.levels.split(","):
        for name in asked.laws.split(","):
            if name not in INSIDE + OUTSIDE:
                sys.exit(f"there is no law {name}: known are {', '.join([*INSIDE, *OUTSIDE])}")
            make(asked.out, name, level, asked.seed)


if __name__ == "__main__":
    main()
