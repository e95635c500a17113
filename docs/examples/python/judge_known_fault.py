"""Does SIRGn find a fault whose place is known?   judge_known_fault.py FOLDER [FOLDER ...]

A FOLDER holds a registered sequence as sequence.json (with a benchmark) and alone.json (without), and truth.csv: points at
rest with the mean error there. Prints for SIRGn against the benchmark, SIRGn by itself, doubt_mm and the landmarks' error:
rank correlation with the true error of triangles / area under the ROC curve for 5 mm.
"""
import pathlib
import sys

import numpy as np

import glisson

for folder in map(pathlib.Path, sys.argv[1:]):
    truth, cells = np.loadtxt(folder / "truth.csv", delimiter=",", skiprows=1), []
    for file, values in {"sequence.json": ["correlation"], "alone.json": ["correlation", "doubt_mm", "error_mm"]}.items():
        judged = glisson.sirgn_of_sequence(folder / file, "given")
        middles_mm = judged["mesh"].points_mm[judged["mesh"].triangles].mean(axis=1)
        nearest = np.linalg.norm(truth[:, :3] - middles_mm[:, None], axis=2).argsort(axis=1)[:, :10]
        error_mm = truth[nearest, 3].mean(axis=1)
        for value in values:
            rated_bad = judged[value] * (-1 if value == "correlation" else 1)
            rank = np.corrcoef(*(each.argsort().argsort() for each in (rated_bad, error_mm)))[0, 1]
            wins = np.sign(rated_bad[error_mm >= 5][:, None] - rated_bad[error_mm < 5])
            cells.append(f"{rank:.2f} / {(1 + wins.mean()) / 2:.2f}")
    print(folder.name, *cells, sep=" | ")
