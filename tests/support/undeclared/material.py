"""Test curves of a small specimen with an effect that its file does not declare, by plain time stepping in steps much
finer than the samples. Uniaxial, nominal stress, incompressible.

Sources: Ogden, Non-linear Elastic Deformations (1984) 7.2; Yeoh 1993, Rubber Chem. Technol. 66:754; Fung,
Biomechanics (1993) 7.6 (quasi-linear relaxation); Ogden and Roxburgh 1999, Proc. R. Soc. A 455:2861; Bouc-Wen: Ikhouane
and Rodellar, Systems with Hysteresis (2007) 2.
"""

import math
from dataclasses import dataclass, field

import numpy as np

SUBSTEPS = 16


@dataclass
class Effects:
    stiffness_factor: float = 1.0
    law: str = "linear"                     # of the elastic answer: linear, yeoh, ogden, fung
    constants: tuple = ()
    compression_factor: float = 1.0         # beside tension
    relaxation: list = field(default_factory=list)   # (share of the instantaneous stress, time_s)
    mullins: tuple = None                   # r, m / E, beta
    loop: tuple = None                      # Bouc-Wen: its stress kPa, the strain it takes to turn
    gain: float = 1.0
    zero_kPa: float = 0.0
    # Outside the catalogue:
    drift_kPa_per_s: float = 0.0            # of the load cell
    grip_slip: tuple = None                 # strain lost each time the stress passes a further level kPa
    ringing: tuple = None                   # kPa, Hz: the machine's own


def elastic(effects, youngs, stretch):
    e, factor = stretch - 1, youngs * effects.stiffness_factor
    if effects.law == "linear":
        stress = factor * e
    elif effects.law == "yeoh":
        c2, c3 = effects.constants
        i = stretch ** 2 + 2 / stretch - 3
        stress = factor / 3 * (stretch - stretch ** -2) * (1 + 2 * c2 * i + 3 * c3 * i * i)
    elif effects.law == "ogden":
        a, = effects.constants
        stress = 2 * factor / 3 / a * (stretch ** (a - 1) - stretch ** (-a / 2 - 1))
    else:  # fung
        b, = effects.constants
        stress = factor * e * math.exp(b * e * e)
    return stress * (effects.compression_factor if e < 0 else 1)


def energy(effects, youngs, stretch, steps=24):
    """Of the elastic law from rest, by the trapezoidal rule."""
    path = np.linspace(1, stretch, steps + 1)
    stress = np.array([elastic(effects, youngs, x) for x in path])
    return float(np.sum((stress[1:] + stress[:-1]) / 2 * np.diff(path)))


def stresses(effects, youngs, times, stretches):
    """What the load cell shows at each sample."""
    memory = [0.0] * len(effects.relaxation)   # relaxed part of each term
    loop, largest_energy, slipped, passed = 0.0, 0.0, 0.0, 0.0
    last_e, last_elastic = 0.0, 0.0
    shown = []
    for k, time in enumerate(times):
        fine = [stretches[k]] if k == 0 else np.linspace(stretches[k - 1], stretches[k], SUBSTEPS + 1)[1:]
        dt = 0.0 if k == 0 else (time - times[k - 1]) / SUBSTEPS
        for stretch in fine:
            if effects.grip_slip:
                while abs(last_elastic) > passed + effects.grip_slip[1]:
                    passed += effects.grip_slip[1]
                    slipped += effects.grip_slip[0]
            stretch = stretch - math.copysign(slipped, stretch - 1) if slipped else stretch
            stress = elastic(effects, youngs, stretch)
            last_elastic = stress
            if effects.mullins:
                r, m, beta = effects.mullins
                now = energy(effects, youngs, stretch)
                largest_energy = max(largest_energy, now)
                stress *= 1 - math.erf((largest_energy - now) / (m * youngs + beta * largest_energy)) / r
            if effects.loop:
                height, width = effects.loop
                de = (stretch - 1 - last_e) / width
                loop += de - abs(de) * loop if de * loop >= 0 else de + abs(de) * -loop
                loop = max(-1.0, min(1.0, loop))
            last_e = stretch - 1
            relaxed = 0.0
            for i, (share, tau) in enumerate(effects.relaxation):
                memory[i] += (share * stress - memory[i]) * (1 - math.exp(-dt / tau))
                relaxed += memory[i]
            answer = stress - relaxed + (effects.loop[0] * loop if effects.loop else 0)
        answer = effects.gain * answer + effects.zero_kPa + effects.drift_kPa_per_s * time
        if effects.ringing:
            answer += effects.ringing[0] * math.sin(2 * math.pi * effects.ringing[1] * time)
        shown.append(answer)
    return np.array(shown)


# What the machine does: straight lines between (strain, rate or duration).

def ramps(rate, strains, samples):
    """From one strain to the next at this rate; about so many samples in all."""
    length = sum(abs(b - a) for a, b in zip([0, *strains], strains))
    times, stretches, at, time = [0.0], [1.0], 0.0, 0.0
    for strain in strains:
        n = max(4, round(samples * abs(strain - at) / length))
        for j in range(1, n + 1):
            times.append(time + abs(strain - at) / rate * j / n)
            stretches.append(1 + at + (strain - at) * j / n)
        time, at = times[-1], strain
    return times, stretches


def ramp_and_hold(rate, strain, hold_s, samples):
    times, stretches = ramps(rate, [strain], samples // 3)
    later = times[-1] + hold_s * np.geomspace(0.004, 1, samples - len(times))
    return times + later.tolist(), stretches + [1 + strain] * len(later)
