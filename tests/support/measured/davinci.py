#!/usr/bin/python3
"""A surgical robot's grasper, driven to and fro, as a material experiment in shear: davinci.py OUT [--data DIR]

DIR is davinci_grip_torque of the shared data (its SOURCE.txt says what was measured). The spindle is turned (as shear,
1 rad from the middle of its way, counted the way its torque is) and its torque read (as stress, 1 "kPa" for 1 mN m), the
jaw working against a resistance of 10 %: 0.1 and 0.2 Hz are fitted, 0.4 Hz is held out. The fourth recording is against
another resistance and is left out. The jaw's own angle says less: it rests for half a second at each turn while the
torque turns over, so that no law in it alone can say what the torque was.

1 kHz is averaged to 20 readings a second. The noise is how well a cycle repeats: the standard deviation of torque
between the cycles of a recording at the same part of the period. Declared: an elastic grasper without friction, of the
least-squares slope of the slowest recording's first cycle.
"""

import json
import sys

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for

MNM_PER_COUNT = 1000 * 3.9811e-5
RAD_PER_COUNT = -2 * np.pi / 8192
PERIOD_S = {"00": 10.0, "10": 5.0, "30": 2.5}


def recorded(file, block=50):
    """Time, the spindle's angle (rad) and torque (mN m)."""
    rows = [line.split(",") for line in file.read_text(errors="replace").splitlines() if line and line[0] != "%"]
    table = np.array([[float(x) for x in row[:9]] for row in rows if len(row) >= 9])
    means = table[:len(table) // block * block].reshape(-1, block, 9).mean(axis=1)
    return means[:, 0], means[:, 1] * RAD_PER_COUNT, means[:, 2] * MNM_PER_COUNT


def repeats_to(time, torque, period_s):
    """Standard deviation between cycles, over the middle of them (at the turning points the friction flips)."""
    whole = int(time[-1] / period_s + 0.05)
    phase = np.linspace(0, period_s, 100, endpoint=False)
    cycles = np.array([np.interp(phase + c * period_s, time, torque) for c in range(whole)])
    return float(np.sqrt(np.median(cycles.var(axis=0, ddof=1))))


def main():
    asked = asked_for(__doc__, "davinci_grip_torque")
    recordings = {name: recorded(asked.data / f"{name}.TXT") for name in PERIOD_S}
    time, angle, torque = recordings["00"]
    middle = (angle.min() + angle.max()) / 2
    first = time < PERIOD_S["00"]
    slope = np.polyfit(angle[first] - middle, torque[first], 1)[0]
    noise = float(np.mean([repeats_to(t, m, PERIOD_S[name]) for name, (t, _, m) in recordings.items()]))
    print(f"cycles repeat to {noise:.2f} mN m; declared stiffness {slope:.1f} mN m / rad; way {np.ptp(angle):.2f} rad")
    for file, names in (("experiment.json", ["00", "10"]), ("heldout.json", ["30"])):
        trials = []
        for name in names:
            t, a, m = recordings[name]
            rows = "\n".join(f"{x:.4f},{1 + y - middle:.6f},{z:.4f}" for x, y, z in zip(t, a, m))
            (asked.out / f"{name}.csv").write_text("time_s,one_plus_angle_rad,torque_mNm\n" + rows + "\n")
            trials.append({"id": f"{1 / PERIOD_S[name]:g} Hz", "file": f"{name}.csv",
                           "columns": {"time_s": "time_s", "stretch": "one_plus_angle_rad", "stress_kPa": "torque_mNm"}})
        (asked.out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "material", "title": "Grasper: torque of its spindle against the angle",
            "specimen": {"shape": "cylinder", "diameter_mm": 10, "height_mm": 10}, "mode": "shear",
            # Shear by g gives E/3 g.
            "declared": {"law": "linear", "youngs_modulus_kPa": round(3 * slope, 2)}, "noise_kPa": round(noise, 3),
            "trials": trials}, indent=1) + "\n")


if __name__ == "__main__":
    main()
