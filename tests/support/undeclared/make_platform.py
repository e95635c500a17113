#!/usr/bin/python3
"""Makes recordings of a battery or a board with an undeclared effect: make_platform.py OUT [--kinds a,b] [--sizes 4,8]
[--seed N]. A cell is drawn empty at several currents (declared: a constant voltage until the capacity is spent); a board
runs through patterns of load (declared: idle and full-load power, one thermal resistance and time constant). By time
stepping, a second at a time.

Sources: Peukert 1897 (t = H (C / (I H))^k); second-order Thevenin model: e.g. He, Xiong, Fan 2011, Energies 4:582.
"""

import json
import math
import sys
from dataclasses import dataclass

sys.dont_write_bytecode = True
import numpy as np

from asked_cases import asked_cases
from noise import noise

NOMINAL_V, CAPACITY_AH = 3.7, 2.5
IDLE_W, FULL_W, THERMAL_C_PER_W, TIME_S, AMBIENT_C = 2.0, 8.0, 5.0, 120.0, 23.0
NOISE = {"voltage_V": 0.005, "power_W": 0.1, "temperature_C": 0.2}


@dataclass
class Effects:
    resistance_ohm: float = 0.0
    polarisation: tuple = ()              # (ohm, s) of a Thevenin model's slow pairs
    peukert: tuple = None                 # exponent, rated hours
    static_W: float = 0.0
    efficiency: float = 1.0
    per_C: float = 0.0                    # more power when warmer than the room
    limit_C: float = None
    # Outside the catalogue:
    fan_at_s: float = None                # from then on half of the thermal resistance
    job: tuple = None                     # every so many seconds, for so many, so many W more
    contact: tuple = None                 # ohm, and how often it comes and goes (s)


def cell(effects, currents, _ambient_C=AMBIENT_C):
    """(time, current, voltage) at every tenth second; the voltage is 0 when nothing is left. The room changes nothing."""
    spent, pairs, rows = 0.0, [0.0] * len(effects.polarisation), []
    for t, current in enumerate(currents):
        rate = 1.0
        if effects.peukert and current > 0:
            exponent, hours = effects.peukert
            rate = (current * hours / CAPACITY_AH) ** (exponent - 1)
        drop = current * effects.resistance_ohm
        for i, (ohm, tau) in enumerate(effects.polarisation):
            pairs[i] += (current * ohm - pairs[i]) * (1 - math.exp(-1 / tau))
            drop += pairs[i]
        if effects.contact and (t // effects.contact[1]) % 3 == 1:
            drop += current * effects.contact[0]
        if t % 10 == 0:
            rows.append((t, current, NOMINAL_V - drop if spent < CAPACITY_AH else 0.0))
        spent += current * rate / 3600
    return {"time_s": 0, "current_A": 1, "voltage_V": 2}, np.array(rows)


def board(effects, loads, ambient_C=AMBIENT_C):
    """(time, load asked for, power, temperature) at every fifth second."""
    temperature, speed, rows = ambient_C, 1.0, []
    for t, load in enumerate(loads):
        if effects.limit_C:   # a governor in small steps
            speed = min(1.0, speed + 0.004) if temperature < effects.limit_C else max(0.05, speed - 0.008)
        power = (IDLE_W + FULL_W * load * speed + effects.static_W) * (1 + effects.per_C * (temperature - ambient_C))
        power /= effects.efficiency
        if effects.job and t % effects.job[0] < effects.job[1]:
            power += effects.job[2]
        if t % 5 == 0:
            rows.append((t, load, power, temperature))
        resistance = THERMAL_C_PER_W * (0.5 if effects.fan_at_s and t > effects.fan_at_s else 1)
        temperature += (ambient_C + resistance * power - temperature) * (1 - math.exp(-1 / TIME_S))
    return {"time_s": 0, "load": 1, "power_W": 2, "temperature_C": 3}, np.array(rows)


INSIDE = {
    "internal-resistance": (cell, lambda r: Effects(resistance_ohm=r.uniform(0.03, 0.1),
                                                   polarisation=((0.006, 4.0), (0.006, 12.0)))),
    "rate-capacity": (cell, lambda r: Effects(peukert=(r.uniform(1.05, 1.25), float(r.choice([1, 5, 20]))))),
    "static-power": (board, lambda r: Effects(static_W=r.uniform(0.5, 2))),
    "supply-loss": (board, lambda r: Effects(efficiency=r.uniform(0.75, 0.92))),
    "self-heating": (board, lambda r: Effects(per_C=r.uniform(0.003, 0.01))),
    "thermal-throttling": (board, lambda r: Effects(limit_C=r.uniform(50, 60))),
}
OUTSIDE = {
    "fan": (board, lambda r: Effects(fan_at_s=r.uniform(300, 500))),
    "background-job": (board, lambda r: Effects(job=(int(r.integers(80, 140)), 30, r.uniform(1, 2)))),
    "loose-contact": (cell, lambda r: Effects(contact=(r.uniform(0.05, 0.1), int(r.integers(100, 300))))),
}


def patterns(kind, rng):
    if kind is cell:
        hours = lambda c: int(3600 * 1.12 / c)
        drawn = {f"{c:g}C": [c * CAPACITY_AH] * hours(c) for c in (0.5, 1, 2)}
        pulses = lambda a, b: [CAPACITY_AH * (a if (t // 300) % 2 else b) for t in range(int(3600 * 1.12 / ((a + b) / 2)))]
        return {**drawn, "pulses": pulses(0.3, 1.5), "h-1.5C": [1.5 * CAPACITY_AH] * hours(1.5), "h-pulses": pulses(0.6, 1.8)}
    steps = lambda levels, length: np.repeat(levels, length).tolist()
    return {"steps": steps([0, 0.4, 0.8, 1, 0.5, 0], 160), "full": steps([1, 1, 0], 300),
            "waves": [0.5 + 0.4 * math.sin(t / 70) for t in range(900)], "light": steps([0.2, 0.5, 0.3], 300),
            "h-steps": steps([0.6, 1, 0.1, 0.9], 220), "h-bursts": [1.0 if t % 120 < 70 else 0.15 for t in range(900)]}


def make(folder, kinds, size, seed, noise_is, null_of):
    if (folder / "truth.json").exists():
        return
    rng = np.random.default_rng([seed, *map(ord, "".join(kinds))])
    kind, effects = null_of, Effects()
    for k in kinds:
        kind, draw = (INSIDE | OUTSIDE)[k]
        effects = Effects(**{**vars(effects), **{n: v for n, v in vars(draw(rng)).items() if v != getattr(Effects(), n)}})
    trials = patterns(kind, rng)
    found, plain = ({t: kind(e, p) for t, p in trials.items()} for e in (effects, Effects()))
    columns = found[next(iter(found))][0]
    measured = {q: columns[q] for q in NOISE if q in columns}
    factor = size_in_noises(found, plain) / size if kinds else 1.0
    folder.mkdir(parents=True)
    written = []
    for trial, (_, rows) in found.items():
        noisy = rows.copy()
        for q, c in measured.items():
            noisy[:, c] += noise(rng, factor * NOISE[q], len(rows), noise_is)
        written.append(write_trial(folder, trial, columns, noisy, AMBIENT_C))
    for file, held_out in (("experiment.json", False), ("heldout.json", True)):
        write_experiment(folder, file, kind, factor, [t for t in written if t["id"].startswith("h-") == held_out])
    shown = {k: v for k, v in vars(effects).items() if v != getattr(Effects(), k)}
    (folder / "truth.json").write_text(json.dumps(
        {"kinds": list(kinds), "outside": any(k in OUTSIDE for k in kinds), "size": size if kinds else 0,
         "noise": noise_is, "parameters": shown}, indent=1) + "\n")


def size_in_noises(found, plain):
    """How far the fitted trials are from those without the effect: root mean square, in NOISE."""
    away = np.concatenate([(found[t][1][:, c] - plain[t][1][:, c]) / NOISE[q] for t in found if t[0] != "h"
                           for q, c in found[t][0].items() if q in NOISE])
    return float(np.sqrt(np.mean(away ** 2)))


def write_trial(folder, name, columns, rows, ambient_C):
    """What an experiment's file says of it."""
    (folder / f"{name}.csv").write_text(",".join(columns) + "\n" + "\n".join(
        ",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")
    return {"id": name, "file": f"{name}.csv", "columns": {c: c for c in columns}, "ambient_C": ambient_C}


def write_experiment(folder, file, kind, factor, trials):
    """`factor`: of NOISE."""
    declared = {"law": "constant", "nominal_voltage_V": NOMINAL_V, "capacity_Ah": CAPACITY_AH} if kind is cell else {
        "law": "constant", "idle_W": IDLE_W, "full_load_W": FULL_W, "thermal_resistance_C_per_W": THERMAL_C_PER_W,
        "time_constant_s": TIME_S}
    measured = [q for q in NOISE if q in trials[0]["columns"]]
    (folder / file).write_text(json.dumps({
        "format": "glisson-experiment/1", "kind": "platform", "title": folder.name, "declared": declared,
        "noise": {q: float(f"{factor * NOISE[q]:.6g}") for q in measured}, "trials": trials}, indent=1) + "\n")


def main():
    for folder, _, kinds, size, seed, noise_is in asked_cases(__doc__, [*INSIDE, *OUTSIDE]):
        for null_of in (board,) if kinds else (cell, board):
            make(folder if kinds else folder.with_name(f"{null_of.__name__}-{folder.name}"), kinds, size, seed, noise_is, null_of)


if __name__ == "__main__":
    main()
