#!/usr/bin/python3
"""How often guidance says that an organ is another patient's: other_patients.py GLISSON_CLI CASE [CASE ...]

Each CASE is one of make_guided_livers.py, of different livers. Its cloud is laid on its own model, and on the models of
the three cases after it in the order given (round the end), once with the features that both have and once without. The
guess is its own, moved so that the models' middles meet. Printed: how many frames were answered of right patients, which
should be all, and of others, which should be none.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import meshio
import numpy as np

OTHERS = 3


def answered(program, case, frames_of=None, features=True):
    """Of each frame whether it was answered, by the model of `case`."""
    document = json.loads((case / "guidance.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        there = pathlib.Path(folder)
        for file in case.iterdir():
            shutil.copy(file, there / file.name)
        if frames_of:
            document["frames"] = frames_on(there, document, case, frames_of)
        if not features:
            document["features"] = []
            for frame in document["frames"]:
                frame["features"] = []
        (there / "guidance.json").write_text(json.dumps(document))
        subprocess.run([program, "guide", there / "guidance.json", "--out", there / "out"], check=True, capture_output=True)
        frames = json.loads((there / "out" / "guidance.json").read_text())["frames"]
    return [frame["converged"] for frame in frames]


def frames_on(there, document, case, seen):
    """The frames of another case, begun where its model would lie."""
    shift = middle(seen) - middle(case)
    known = {feature["id"] for feature in document["features"]}
    frames = json.loads((seen / "guidance.json").read_text())["frames"]
    for frame in frames:
        frame["features"] = [feature for feature in frame["features"] if feature["id"] in known]
        for used in [frame, *frame["features"]]:
            shutil.copy(seen / used["points"], there / ("seen-" + used["points"]))
            used["points"] = "seen-" + used["points"]
        pose = np.array(frame["pose_guess"]).reshape(4, 4)
        pose[:3, 3] += pose[:3, :3] @ shift
        frame["pose_guess"] = pose.ravel().tolist()
    return frames


def middle(case):
    return meshio.read(case / "liver.vtu").points.mean(axis=0)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, cases = sys.argv[1], list(map(pathlib.Path, sys.argv[2:]))
    right, told, alone = [], [], []
    for k, seen in enumerate(cases):
        right += answered(program, seen)
        for after in range(1, OTHERS + 1):
            other = cases[(k + after) % len(cases)]
            told += answered(program, other, seen)
            alone += answered(program, other, seen, features=False)
            print(f"{seen.name:24} on {other.name:24} answered {sum(told[-2:])} with features, {sum(alone[-2:])} by the cloud alone",
                  flush=True)
    print(f"right patients: {sum(right)} of {len(right)} frames answered")
    print(f"other patients, with features: {sum(told)} of {len(told)} frames answered")
    print(f"other patients, by the cloud alone: {sum(alone)} of {len(alone)} frames answered")


if __name__ == "__main__":
    main()
