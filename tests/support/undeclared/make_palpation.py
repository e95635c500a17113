#!/usr/bin/python3
"""Makes palpation experiments with an undeclared effect: make_palpation.py OUT [--kinds a,b] [--sizes 2,4,8,20] [--seed N]
[--specimens block,pillar,lobe,liver-SEED]. liver-SEED is cut from a generated liver, which wants glisson-cli. A case is named by its specimen, effect, size and seed."""

import os
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import calculix
from asked_cases import asked_cases
from palpation import Effects, setting, size_mm, write_case
from generated_liver import liver
from specimens import block, lobe, pillar

# Each with the grids of its truth: usually (within 1 % of a much finer one), and at large strain, which takes many solves.
SPECIMENS = {"block": (lambda: block((60, 60, 40), (6, 6, 4)), (10, 10, 7), (7, 7, 5)),
             "pillar": (lambda: pillar(60, 40, (8, 8, 4)), (10, 10, 7), (7, 7, 5)),
             "lobe": (lambda: lobe(110, 80, 45, (12, 9, 4)), (12, 10, 6), (9, 7, 4)),
             "tiny": (lambda: block((45, 45, 30), (4, 4, 3)), (6, 6, 5), (6, 6, 4)),
             "small": (lambda: block((45, 45, 30), (5, 5, 3)), (10, 10, 7), (7, 7, 5)),
             "large": (lambda: block((90, 90, 60), (10, 10, 10)), (12, 12, 8), (7, 7, 5))}
LIVER_GRIDS = ((12, 10, 7), (8, 7, 5))
MINIMUM_NOISE_MM = 0.04  # below this the flat faces and elements of either mesh show
REACH_MM = 6.0         # what a tool moves of a marker at most


def unit_vector(rng):
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def one_of(rng, *ranges):
    low, high = ranges[rng.integers(len(ranges))]
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def neo_hooke(scene, _):
    shear = scene.youngs_kPa / (2 + 2 * scene.poisson_ratio)
    bulk = scene.youngs_kPa / (3 - 6 * scene.poisson_ratio)
    return f"*HYPERELASTIC, NEO HOOKE\n{shear / 2:.8g}, {2 / bulk:.8g}"


def yeoh(scene, rng):
    shear = scene.youngs_kPa / (2 + 2 * scene.poisson_ratio)
    bulk = scene.youngs_kPa / (3 - 6 * scene.poisson_ratio)
    return (f"*HYPERELASTIC, YEOH\n{shear / 2:.8g}, {shear * one_of(rng, (0.5, 2)):.8g}, 0., {2 / bulk:.8g}, 0., 0.")


def ogden(scene, rng):
    shear = scene.youngs_kPa / (2 + 2 * scene.poisson_ratio)
    bulk = scene.youngs_kPa / (3 - 6 * scene.poisson_ratio)
    alpha = rng.uniform(4, 10)
    return f"*HYPERELASTIC, OGDEN, N=1\n{shear:.8g}, {alpha:.6g}, {2 / bulk:.8g}"


def stiffening(scene, rng):
    return Effects(hyperelastic=(neo_hooke, yeoh, ogden)[rng.integers(1, 3)](scene, rng))


def inclusion(scene, rng):
    low, high = scene.experiment.points.min(axis=0), scene.experiment.points.max(axis=0)
    radius = rng.uniform(0.28, 0.34) * (high - low)[2]
    under = scene.sites[int(rng.integers(0, 5))].center_mm
    center = [under[0] * 0.8 + 0.2 * (low + high)[0] / 2, under[1] * 0.8 + 0.2 * (low + high)[1] / 2,
              under[2] - radius - rng.uniform(2, 6)]
    return Effects(inclusion=(np.round(center, 2).tolist(), round(radius, 2), round(rng.uniform(4, 10), 2)))


def foam(scene, rng):
    """A layer that shears more easily than it is pressed together, as confined foam and rubber do."""
    across = scene.youngs_kPa * one_of(rng, (0.05, 0.3))
    return Effects(foundation_kPa_per_mm=across, sideways_kPa_per_mm=across * one_of(rng, (0.05, 0.35)))


def grain_that_shears(scene, rng):
    """Fibres whose matrix shears otherwise along them than across."""
    return Effects(fibres=(unit_vector(rng).round(4).tolist(), one_of(rng, (1.6, 4)), one_of(rng, (0.4, 0.7), (1.5, 2.5))))


# Each kind of the catalogue, drawn anew for every case.
INSIDE = {
    "stiffness-scale": lambda s, r: Effects(stiffness_factor=one_of(r, (0.5, 0.85), (1.2, 2))),
    "support-compliance": lambda s, r: Effects(foundation_kPa_per_mm=s.youngs_kPa * one_of(r, (0.02, 0.15))),
    "stiff-inclusion": inclusion,
    "viscoelastic-creep": lambda s, r: Effects(creep=[(one_of(r, (0.15, 0.8)), one_of(r, (2, 15)))]),
    "force-bias": lambda s, r: Effects(gain=one_of(r, (0.8, 0.92), (1.08, 1.25)), zero_N=float(r.choice([-1, 1])) *
                                       r.uniform(0.1, 0.3) * np.mean([x.largest_N for x in s.sites])),
    "frame-misalignment": lambda s, r: Effects(rotation_deg=tuple(r.uniform(0.3, 1.5) * unit_vector(r)),
                                               translation_mm=tuple(r.uniform(0.2, 1) * unit_vector(r))),
    "anisotropy": lambda s, r: Effects(fibres=(unit_vector(r).round(4).tolist(), one_of(r, (1.6, 4)))),
    "capsule": lambda s, r: Effects(capsule_N_per_mm=one_of(r, (0.03, 0.3))),
    "preload": lambda s, r: (Effects(gravity_m_s2=tuple(9.81 * unit_vector(r))) if r.random() < 0.6 else
                             Effects(pressure_kPa=float(r.choice([-1, 1]) * s.youngs_kPa * r.uniform(0.03, 0.1)))),
    "strain-stiffening": stiffening,
}
OUTSIDE = {
    "cut": lambda s, r: Effects(cut=(int(r.integers(0, 2)), 0.5, 0.7)),
    "slipping-tool": lambda s, r: Effects(slip_mm=tuple(r.uniform(8, 12) * np.array([np.cos(a := r.uniform(0, 6.28)),
                                                                                     np.sin(a), 0]))),
    "tilting-force": lambda s, r: Effects(tilt_deg=float(r.uniform(25, 45))),
    "drying": lambda s, r: Effects(drying_per_s=float(r.uniform(0.0008, 0.002))),
}
# Other forms of a kind: made where they are asked for.
FORMS = {"support-compliance.layer": foam, "anisotropy.three-moduli": grain_that_shears}
PAIRS = [("stiffness-scale", "support-compliance"), ("stiff-inclusion", "frame-misalignment"),
         ("viscoelastic-creep", "force-bias"), ("support-compliance", "preload"), ("anisotropy", "stiffness-scale"),
         ("viscoelastic-creep", "support-compliance"), ("capsule", "frame-misalignment")]


def together(a, b):
    both = Effects(**vars(a))
    for name, value in vars(b).items():
        if value != getattr(Effects(), name):
            setattr(both, name, value)
    return both


def added_mm(scene, parts):
    """What the weakest of the effects adds to the others."""
    if len(parts) == 1:
        return size_mm(scene, parts[0])
    whole = together(*parts)
    return min(size_mm(scene, whole, without) for without in parts)


def make(folder, specimen, kinds, size, seed, noise_is):
    if (folder / "truth.json").exists():
        return
    scene = scene_of(specimen, "strain-stiffening" in kinds)
    rng = np.random.default_rng([seed, *map(ord, "".join(kinds))])
    parts = [(INSIDE | OUTSIDE | FORMS)[kind](scene, rng) for kind in kinds]
    outside = any(kind in OUTSIDE for kind in kinds)
    if not parts:
        noise, size, effects = float(rng.choice([0.05, 0.1, 0.2])), 0.0, Effects()
    else:
        effects = together(*parts) if len(parts) == 2 else parts[0]
        effect = added_mm(scene, parts)
        noise = round(max(effect / size, MINIMUM_NOISE_MM), 4)
        if effect / noise < 0.7 * size:
            return print(f"{folder.name}: is not made, it would take a noise of {effect / size:.3f} mm", flush=True)
        size = effect / noise
    shown = {k: v for k, v in vars(effects).items() if v != getattr(Effects(), k)}
    write_case(folder, scene, effects, noise, seed, {"kinds": [kind.split(".")[0] for kind in kinds], "outside": outside, "size": round(size, 2),
                                                     "noise": noise_is, "parameters": shown})
    print(f"{folder.name}: {size:.1f} times a noise of {noise} mm", flush=True)


SCENES = {}


def scene_of(specimen, grid):
    if (specimen, grid) not in SCENES:
        if specimen.startswith("liver-"):
            body, grids = liver(int(specimen.removeprefix("liver-")), (10, 9, 5)), LIVER_GRIDS
        else:
            maker, *grids = SPECIMENS[specimen]
            body = maker()
        SCENES[specimen, grid] = setting(body, seed=len(specimen), truth_cells=grids[grid], reach_mm=REACH_MM)
    return SCENES[specimen, grid]


def main():
    if not calculix.available():
        sys.exit("CalculiX (ccx) is not installed: apt-get install calculix-ccx")
    for case in asked_cases(__doc__, [*INSIDE, *OUTSIDE], PAIRS, "specimens", "block"):
        make(*case)


if __name__ == "__main__":
    main()
