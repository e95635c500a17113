#!/usr/bin/python3
"""Judges `glisson-cli guide` on cases whose truth is known.

    tests/support/guidance_judge.py GLISSON_CLI CASE [CASE ...]

A CASE is a folder with guidance.json and truth.json (or truth/truth.json). For each frame: the mean and the largest
error of the targets, the error of the best rigid motion that knows the truth, and how many targets lie within 2.5 of
the stated standard deviations (90 % should). Below each case and all of them: the mean and median of the error over the
best rigid motion's, over frames that are deformed, and the median error of the tools' forces (as vectors, and of their
size) where they are known, with how many of them lie within 2.5 of their standard deviations. At last, of all cases: how
many targets lie within 2.5 standard deviations by thirds of how far they are from what was seen, and of the visible share.
"""
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

import meshio
import numpy as np

DEFORMED_MM = 0.1


def judged(program, folder, bands):
    truth_file = folder / "truth.json" if (folder / "truth.json").exists() else folder / "truth" / "truth.json"
    truth = {frame["id"]: frame for frame in json.loads(truth_file.read_text())["frames"]}
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "guide", folder / "guidance.json", "--out", out], check=True, capture_output=True)
        frames = json.loads((pathlib.Path(out) / "guidance.json").read_text())["frames"]
    for frame in frames:
        known = truth[frame["id"]]
        at = {target["id"]: target["position_mm"] for target in known["targets"]}
        errors = [math.dist(target["position_mm"], at[target["id"]]) for target in frame["targets"]]
        within = [error < 2.5 * target["sd_mm"] for error, target in zip(errors, frame["targets"])]
        forces = {tool["id"]: tool["force_N"] for tool in known.get("tools", [])}
        off = [(math.dist(tool["force_N"], forces[tool["id"]]) / math.hypot(*forces[tool["id"]]),
                abs(math.hypot(*tool["force_N"]) / math.hypot(*forces[tool["id"]]) - 1),
                math.dist(tool["force_N"], forces[tool["id"]]) < 2.5 * tool["sd_N"])
               for tool in frame.get("tools", []) if tool["id"] in forces]
        cloud = meshio.read(folder / f"{frame['id']}.ply").points
        depths = [np.linalg.norm(cloud - at[target["id"]], axis=1).min() for target in frame["targets"]]
        bands.extend(zip(depths, [frame["visible_share"]] * len(depths), within))
        yield frame, known["best_rigid_tre_mm"]["mean"], errors, within, off


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print(f"{'case':16}{'frame':6}{'mean mm':>8}{'max mm':>8}{'best rigid':>11}{'within':>8}{'seconds':>8}")
    everything, bands = [], []
    for case in map(pathlib.Path, sys.argv[2:]):
        of_case = []
        for frame, best_rigid, errors, within, off in judged(sys.argv[1], case, bands):
            if not errors:
                print(f"{case.name:16}{frame['id']:6}not answered: {frame.get('note', '')}", flush=True)
                continue
            print(f"{case.name:16}{frame['id']:6}{sum(errors) / len(errors):8.2f}{max(errors):8.2f}{best_rigid:11.2f}"
                  f"{100 * sum(within) / len(within):7.0f}%{frame['seconds']:8.1f}", flush=True)
            of_case.append((best_rigid, errors, within, off))
        print_sum(case.name, of_case)
        everything += of_case
    print_sum("all", everything)
    for what, by in (("distance from what was seen", 0), ("visible share", 1)):
        ordered = sorted(bands, key=lambda band: band[by])
        thirds = [ordered[k * len(ordered) // 3:(k + 1) * len(ordered) // 3] for k in range(3)]
        print(f"within, by thirds of {what}: "
              + ", ".join(f"{100 * statistics.mean(within for *_, within in third):.0f}%" for third in thirds if third))


def print_sum(name, frames):
    """One line of ratios, one of forces, each where there is any."""
    ratios = [statistics.mean(errors) / best_rigid for best_rigid, errors, _, _ in frames if best_rigid > DEFORMED_MM]
    inside = [one for _, _, within, _ in frames for one in within]
    forces = [force for _, _, _, off in frames for force in off]
    if ratios:
        print(f"{name}: of the best rigid motion's: mean {statistics.mean(ratios):.2f},"
              f" median {statistics.median(ratios):.2f}; within {100 * statistics.mean(inside):.0f}%")
    if forces:
        print(f"{name}: tools' forces off by {100 * statistics.median(vector for vector, _, _ in forces):.0f} %,"
              f" their size by {100 * statistics.median(size for _, size, _ in forces):.0f} % (medians);"
              f" within {100 * statistics.mean(within for _, _, within in forces):.0f}%", flush=True)


if __name__ == "__main__":
    main()
