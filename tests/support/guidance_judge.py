#!/usr/bin/python3
"""Judges `glisson-cli guide` on cases whose truth is known.

    tests/support/guidance_judge.py GLISSON_CLI CASE [CASE ...]

A CASE is a folder with guidance.json and truth.json (or truth/truth.json). For each frame: the mean and the largest
error of the targets, the error of the best rigid motion that knows the truth, and how many targets lie within 2.5 of
the stated standard deviations (90 % should). Below each case and all of them: the mean and median of the error over the
best rigid motion's, over frames that are deformed, and the median error of the tools' forces (as vectors, and of their
size) where they are known, with how many of them lie within 2.5 of their standard deviations. At last, of all cases: how
many targets lie within 2.5 standard deviations by thirds of how far they are from what was seen, and of the visible share,
each with its 95 % interval where livers are drawn anew (targets of one liver err together), and how wide 2.5 standard
deviations are beside the errors.
"""
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import typing

import meshio
import numpy as np

DEFORMED_MM = 0.1
DRAWS = 2000


class Target(typing.NamedTuple):
    liver: str
    depth_mm: float
    visible_share: float
    error_mm: float
    reach_mm: float  # that 90 % should lie within

    @property
    def within(self):
        return self.error_mm < self.reach_mm


def judged(program, folder, everything):
    truth_file = folder / "truth.json" if (folder / "truth.json").exists() else folder / "truth" / "truth.json"
    told = json.loads(truth_file.read_text())
    truth = {frame["id"]: frame for frame in told["frames"]}
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "guide", folder / "guidance.json", "--out", out], check=True, capture_output=True)
        frames = json.loads((pathlib.Path(out) / "guidance.json").read_text())["frames"]
    for frame in frames:
        known = truth[frame["id"]]
        at = {target["id"]: target["position_mm"] for target in known["targets"]}
        errors = [math.dist(target["position_mm"], at[target["id"]]) for target in frame["targets"]]
        reaches = [2.5 * target["sd_mm"] for target in frame["targets"]]
        within = [error < reach for error, reach in zip(errors, reaches)]
        forces = {tool["id"]: tool["force_N"] for tool in known.get("tools", [])}
        off = [(math.dist(tool["force_N"], forces[tool["id"]]) / math.hypot(*forces[tool["id"]]),
                abs(math.hypot(*tool["force_N"]) / math.hypot(*forces[tool["id"]]) - 1),
                math.dist(tool["force_N"], forces[tool["id"]]) < 2.5 * tool["sd_N"])
               for tool in frame.get("tools", []) if tool["id"] in forces]
        cloud = meshio.read(folder / f"{frame['id']}.ply").points
        depths = [np.linalg.norm(cloud - at[target["id"]], axis=1).min() for target in frame["targets"]]
        everything.extend(Target(told.get("liver", folder.name), depth, frame["visible_share"], error, reach)
                          for depth, error, reach in zip(depths, errors, reaches))
        yield frame, known["best_rigid_tre_mm"]["mean"], errors, within, off


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print(f"{'case':16}{'frame':6}{'mean mm':>8}{'max mm':>8}{'best rigid':>11}{'within':>8}{'seconds':>8}")
    frames, targets = [], []
    for case in map(pathlib.Path, sys.argv[2:]):
        of_case = []
        for frame, best_rigid, errors, within, off in judged(sys.argv[1], case, targets):
            if not errors:
                print(f"{case.name:16}{frame['id']:6}not answered: {frame.get('note', '')}", flush=True)
                continue
            print(f"{case.name:16}{frame['id']:6}{sum(errors) / len(errors):8.2f}{max(errors):8.2f}{best_rigid:11.2f}"
                  f"{100 * sum(within) / len(within):7.0f}%{frame['seconds']:8.1f}", flush=True)
            of_case.append((best_rigid, errors, within, off))
        print_sum(case.name, of_case)
        frames += of_case
    print_sum("all", frames)
    print_bands(targets)


def print_bands(targets):
    """How many lie within, of all and by thirds of what is known of them; how wide that is."""
    if not targets:
        return
    print(f"within, all: {share_and_interval(targets)}")
    for what, by in (("distance from what was seen", "depth_mm"), ("visible share", "visible_share")):
        ordered = sorted(targets, key=lambda target: getattr(target, by))
        thirds = [ordered[k * len(ordered) // 3:(k + 1) * len(ordered) // 3] for k in range(3)]
        print(f"within, by thirds of {what}: " + ", ".join(share_and_interval(third) for third in thirds if third))
    reaches = [target.reach_mm for target in targets]
    errors = [target.error_mm for target in targets]
    print(f"2.5 standard deviations: {statistics.mean(reaches):.1f} mm on average, {np.percentile(reaches, 10):.1f} to"
          f" {np.percentile(reaches, 90):.1f} for most; errors: {statistics.mean(errors):.1f} on average,"
          f" {np.percentile(errors, 90):.1f} at the 90th percentile")


def share_and_interval(targets):
    """The share that lies within, and between which it lies in 95 of 100 draws of as many livers."""
    livers = sorted({target.liver for target in targets})
    of_liver = np.array([[sum(target.within for target in targets if target.liver == liver),
                          sum(target.liver == liver for target in targets)] for liver in livers])
    drawn = np.random.default_rng(1).integers(len(livers), size=(DRAWS, len(livers)))
    sums = of_liver[drawn].sum(axis=1)
    low, high = np.percentile(100 * sums[:, 0] / sums[:, 1], [2.5, 97.5])
    return f"{100 * statistics.mean(target.within for target in targets):.0f}% ({low:.0f} to {high:.0f})"


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
