"""How far hidden targets are from where they truly are, frame by frame.   guidance_table.py FOLDER [FOLDER ...]

A FOLDER holds guidance.json and truth.json. Prints the table of docs/guidance.md: the mean error of the targets, that
of the best rigid motion (which knows the truth), and the share of targets within 2.5 stated standard deviations.
"""
import json
import pathlib
import sys

import numpy as np

import glisson

for folder in map(pathlib.Path, sys.argv[1:]):
    truth = {frame["id"]: frame for frame in json.loads((folder / "truth.json").read_text())["frames"]}
    for frame in glisson.guide(folder / "guidance.json")["frames"]:
        known = truth[frame["id"]]
        true_mm = {target["id"]: target["position_mm"] for target in known["targets"]}
        found_mm = np.array([target["position_mm"] for target in frame["targets"]])
        off_mm = np.linalg.norm(found_mm - [true_mm[target["id"]] for target in frame["targets"]], axis=1)
        within = off_mm < 2.5 * np.array([target["sd_mm"] for target in frame["targets"]])
        print(f"| {folder.name} | {frame['id']} | {off_mm.mean():.2f} | {known['best_rigid_tre_mm']['mean']:.2f} | "
              f"{100 * within.mean():.0f}% |")
