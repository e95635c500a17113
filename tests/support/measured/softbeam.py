#!/usr/bin/python3
"""A clamped silicone beam under gravity and a hung weight, as a palpation experiment: softbeam.py OUT [--data DIR]

DIR is softbeam_mocap_eth of the shared data (its SOURCE.txt says what was measured). OUT gets experiment.json (trials
a) and heldout.json (trials b, the same two loads put on again), in the frame of the authors' model: x along the beam
from the clamp (-100 mm) to the tip (0), z up.

Each trial gives one settled state: the mean of its last half second. Rest is the beam held level before it is let go.
The reflecting spheres stand 6 mm off the beam's faces; the three at the tip are taken as fixed to its end, which turns
as one (the script says how well their triangle keeps its shape), and the turned end is read off at the points of the beam under
them. The noise is what the two trials of a load differ by, over the root of two: how well the experiment repeats, far
more than the camera's own 0.01 mm. Declared: Young's modulus of the silicone's data sheet (100 % modulus, 151.7 kPa).
"""

import json
import pathlib
import sys

sys.dont_write_bytecode = True
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "undeclared"))
from recordings import asked_for
from specimens import block, experiment_mesh, write_vtu


# Where the spheres are in the authors' model, mm: three at the tip, three at the clamp, in the order of the columns.
SPHERES_MM = np.array([[0, 15, 36], [0, -6, 24], [0, 36, 6], [-94, -10, -1], [-94, 40, 27.5], [-94, 40, 0]], float)
# The points of the beam that the first three stand on.
UNDER_MM = np.array([[0, 15, 30], [0, 0, 24], [0, 30, 6]], float)
TRIALS = {"gravity": ("beam_gravity_V2", 0.0), "load52": ("beam_load52_V2", 0.052 * 9.81)}


def recorded(data, name):
    table = np.loadtxt(data / "csv" / f"{name}.csv", delimiter=",", skiprows=1)
    return table[:, 1:].reshape(len(table), 6, 3)


def rigid(source, target):
    """Rotation and translation that take one set of points nearest to another (Kabsch 1976)."""
    a, b = source.mean(axis=0), target.mean(axis=0)
    u, _, vt = np.linalg.svd((source - a).T @ (target - b))
    turn = vt.T @ np.diag([1, 1, np.sign(np.linalg.det(vt.T @ u.T))]) @ u.T
    return turn, b - turn @ a


def settled(data, name):
    """Where the points of the beam are at the end, in the model's frame."""
    frames = recorded(data, name)
    fall = np.linalg.norm(np.diff(frames[:, :3].mean(axis=1), axis=0), axis=1)
    start = 20 + int(np.argmax(fall[20:] > 0.1)) - 3   # in the first frames the trigger shows; then nothing moves
    rest = frames[start - 10:start].mean(axis=0)
    turn, shift = rigid(rest, SPHERES_MM)
    before, after = rest @ turn.T + shift, frames[-50:].mean(axis=0) @ turn.T + shift
    turned, moved = rigid(before[:3], after[:3])
    print(f"{name}: let go at {start / 100:.2f} s; at rest the spheres are up to"
          f" {np.abs(before - SPHERES_MM).max():.2f} mm from where the model has them; the tip's triangle keeps its shape"
          f" to {np.abs(before[:3] @ turned.T + moved - after[:3]).max():.2f} mm")
    return UNDER_MM @ turned.T + moved


def main():
    asked = asked_for(__doc__, "softbeam_mocap_eth")
    write_beam(asked.out)
    ends = {(load, take): settled(asked.data, f"{stem}_{take}") for load, (stem, _) in TRIALS.items() for take in "ab"}
    apart = np.concatenate([ends[load, "a"] - ends[load, "b"] for load in TRIALS])
    noise_mm = round(float(np.sqrt(np.mean(apart ** 2) / 2)), 3)
    print(f"the noise is {noise_mm} mm; two trials of one load differ by up to {np.abs(apart).max():.2f} mm")
    for file, take in (("experiment.json", "a"), ("heldout.json", "b")):
        trials = [trial(asked.out, f"{load}_{take}", force, ends[load, take]) for load, (_, force) in TRIALS.items()]
        (asked.out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "palpation", "title": "Silicone beam, clamped, let go under its weight",
            "specimen": {"mesh": "specimen.vtu", "youngs_modulus_kPa": 151.7, "poisson_ratio": 0.49,
                         "density_kg_m3": 1070},
            "supports": [{"point_array": "fixed"}], "gravity_m_s2": [0, 0, -9.81], "noise_mm": noise_mm,
            "trials": trials}, indent=1) + "\n")


def write_beam(out):
    upright = block((30, 30, 100), (4, 4, 12))
    mesh = experiment_mesh(upright)
    along, across, up = mesh.points[:, 2] - 100, mesh.points[:, 0], mesh.points[:, 1]
    fixed = np.zeros(len(mesh.points))
    fixed[mesh.held_nodes()] = 1
    mesh.points = np.column_stack([along, across, up])
    write_vtu(out / "specimen.vtu", mesh, fixed=fixed)


def trial(out, name, force_N, end):
    rows = [",".join([f"tip{i}", *(f"{x:.4f}" for x in (*rest, *now))]) for i, (rest, now) in enumerate(zip(UNDER_MM, end), 1)]
    (out / f"{name}.csv").write_text("id,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")
    return {"id": name, "tool": {"center_mm": [-4, 15, 30], "radius_mm": 8, "direction": [0, 0, -1]},
            "samples": [{"time_s": 0, "force_N": 0},
                        {"time_s": 4, "force_N": round(force_N, 5), "markers": f"{name}.csv"}]}


if __name__ == "__main__":
    main()
