#!/usr/bin/python3
"""Makes material tests with an undeclared effect: make_material.py OUT [--kinds a,b] [--sizes 2,4,8,20] [--seed N]
[--modes compression,tension]. Declared is the linear law with the modulus at rest."""

import json
import os
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

from asked_cases import asked_cases
from material import Effects, ramp_and_hold, ramps, stresses
from noise import noise as noise_of

YOUNGS_KPA = 30.0


def one_of(rng, *ranges):
    low, high = ranges[rng.integers(len(ranges))]
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def stiffening(rng):
    which = rng.integers(3)
    if which == 0:
        return Effects(law="yeoh", constants=(one_of(rng, (0.5, 2)), one_of(rng, (0.05, 0.3))))
    return Effects(law="ogden", constants=(one_of(rng, (6, 14)),)) if which == 1 else Effects(
        law="fung", constants=(one_of(rng, (4, 12)),))


def relaxing(rng):
    terms = [(rng.uniform(0.2, 0.5), one_of(rng, (2, 30)))]
    return Effects(relaxation=terms if rng.random() < 0.5 else [*terms, (rng.uniform(0.1, 0.25), terms[0][1] * 8)])


INSIDE = {
    "stiffness-scale": lambda r: Effects(stiffness_factor=one_of(r, (0.5, 0.85), (1.2, 2))),
    "strain-stiffening": stiffening,
    "viscoelastic-creep": relaxing,
    "softening": lambda r: Effects(mullins=(r.uniform(1.5, 3), r.uniform(0.005, 0.03), r.uniform(0, 0.2))),
    "hysteresis": lambda r: Effects(loop=(YOUNGS_KPA * r.uniform(0.02, 0.06), r.uniform(0.008, 0.02))),
    "tension-compression-asymmetry": lambda r: Effects(compression_factor=one_of(r, (0.4, 0.75), (1.3, 2.5))),
    "force-bias": lambda r: Effects(gain=one_of(r, (0.8, 0.92), (1.08, 1.25)),
                                    zero_kPa=YOUNGS_KPA * float(r.choice([-1, 1])) * r.uniform(0.03, 0.08)),
}
OUTSIDE = {
    "drifting-cell": lambda r: Effects(drift_kPa_per_s=float(r.choice([-1, 1])) * YOUNGS_KPA * 0.002),
    "slipping-grip": lambda r: Effects(grip_slip=(0.012, YOUNGS_KPA * r.uniform(0.03, 0.06))),
    "ringing-machine": lambda r: Effects(ringing=(YOUNGS_KPA * 0.05, r.uniform(0.15, 0.3))),
}
PAIRS = [("strain-stiffening", "viscoelastic-creep"), ("stiffness-scale", "hysteresis"),
         ("strain-stiffening", "softening"), ("viscoelastic-creep", "force-bias")]


def protocol(sign, both, rng):
    """Several rates and peaks; those whose name begins with h are held out."""
    other = -sign if both else 0
    peak = lambda x: sign * x * rng.uniform(0.95, 1.05)
    back = [0] if not both else [0, -0.2 * sign, 0]
    return {"slow": ramps(0.004, [peak(0.25), *back], 90), "quick": ramps(0.08, [peak(0.25), *back], 90),
            "cycles": ramps(0.03, [peak(0.12), 0, peak(0.12), 0, peak(0.25), *back, peak(0.25), *back], 160),
            "hold": ramp_and_hold(0.1, peak(0.2), 60, 90),
            "other": ramp_and_hold(0.02, other * 0.15 or peak(0.1), 40, 70),
            "h-middle": ramps(0.02, [peak(0.22), *back, peak(0.22), *back], 120),
            "h-hold": ramp_and_hold(0.05, peak(0.15), 50, 80)}


def together(parts):
    both = Effects()
    for part in parts:
        for name, value in vars(part).items():
            if value != getattr(Effects(), name):
                setattr(both, name, value)
    return both


def curves(effects, trials):
    return {name: stresses(effects, YOUNGS_KPA, *trial) for name, trial in trials.items()}


def size_kPa(found, without):
    return float(np.sqrt(np.mean(np.concatenate([found[t] - without[t] for t in found if not t.startswith("h")]) ** 2)))


def make(folder, mode, kinds, size, seed, noise_is):
    if (folder / "truth.json").exists():
        return
    rng = np.random.default_rng([seed, *map(ord, mode + "".join(kinds))])
    parts = [(INSIDE | OUTSIDE)[kind](rng) for kind in kinds]
    trials = protocol(-1 if mode == "compression" else 1, "tension-compression-asymmetry" in kinds, rng)
    found = curves(together(parts), trials)
    if kinds:
        effect = min(size_kPa(found, curves(together([p for p in parts if p is not part]), trials)) for part in parts)
        noise = effect / size
    else:
        noise = float(rng.choice([0.05, 0.2, 0.5]))
    folder.mkdir(parents=True)
    written = []
    for trial, (times, stretches) in trials.items():
        noisy = found[trial] + noise_of(rng, noise, len(times), noise_is)
        written.append(write_trial(folder, trial, times, stretches, noisy))
    for file, held_out in (("experiment.json", False), ("heldout.json", True)):
        write_experiment(folder, file, mode, noise, [t for t in written if t["id"].startswith("h-") == held_out])
    shown = {k: v for k, v in vars(together(parts)).items() if v != getattr(Effects(), k)}
    (folder / "truth.json").write_text(json.dumps(
        {"kinds": list(kinds), "outside": any(k in OUTSIDE for k in kinds), "size": size if kinds else 0,
         "noise_kPa": noise, "noise": noise_is, "parameters": shown}, indent=1) + "\n")


def write_trial(folder, name, times, stretches, stress_kPa):
    """What an experiment's file says of it."""
    rows = "\n".join(f"{t:.5f},{x:.7f},{s:.6f}" for t, x, s in zip(times, stretches, stress_kPa))
    (folder / f"{name}.csv").write_text("Time,Stretch,Stress\n" + rows + "\n")
    return {"id": name, "file": f"{name}.csv",
            "columns": {"time_s": "Time", "stretch": "Stretch", "stress_kPa": "Stress"}}


def write_experiment(folder, file, mode, noise_kPa, trials):
    (folder / file).write_text(json.dumps({
        "format": "glisson-experiment/1", "kind": "material", "title": folder.name,
        "specimen": {"shape": "cylinder", "diameter_mm": 50, "height_mm": 30}, "mode": mode,
        "declared": {"law": "linear", "youngs_modulus_kPa": YOUNGS_KPA}, "noise_kPa": round(noise_kPa, 6),
        "trials": trials}, indent=1) + "\n")


def main():
    for case in asked_cases(__doc__, [*INSIDE, *OUTSIDE], PAIRS, "modes", "compression"):
        make(*case)


if __name__ == "__main__":
    main()
