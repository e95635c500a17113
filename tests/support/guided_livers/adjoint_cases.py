#!/usr/bin/python3
"""Makes guidance cases of ../shared/data/guidance_adjoint: adjoint_cases.py OUT [--declare nothing|support|tool|seen-tool]
[--seed N]. The source's clouds have no noise and its pose is exact: here 0.5 mm of noise are added, the camera lies
anywhere, and the guess is off by 4 to 9 degrees and 6 to 14 mm. Declared are nothing besides; the fixed points; and the
tool too, without its force: the middle of the patch where it may pull, at rest, or (seen-tool) where it has gone,
with 1 mm of noise. The folders are what guidance_judge.py reads."""

import argparse
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True
import meshio
import numpy as np
from scipy.spatial.transform import Rotation

from make_guided_livers import unit, write_ply

SOURCE = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA", "../shared/data")) / "guidance_adjoint"
NOISE_MM = 0.5


def make(source, out, declare, seed):
    rng = np.random.default_rng([seed, *map(ord, source.name)])
    document, known, truth = (json.loads((source / name).read_text()) for name in ("guidance.json", "known.json", "truth/truth.json"))
    out.mkdir(parents=True, exist_ok=True)
    mesh = meshio.read(source / "liver.vtu")
    fixed = np.zeros(len(mesh.points))
    fixed[known["fixed_nodes"]] = 1
    mesh.point_data["fixed"] = fixed
    mesh.write(out / "liver.vtu")
    (out / "targets.csv").write_text((source / "targets.csv").read_text())
    if declare != "nothing":
        document["supports"] = [{"point_array": "fixed"}]
    region = mesh.points[known["force_region_nodes"]]
    middle = mesh.points.mean(axis=0)
    for frame, true in zip(document["frames"], truth["frames"]):
        turn = Rotation.random(random_state=int(rng.integers(1 << 30))).as_matrix()
        shift = np.array([0, 0, 200.0]) + rng.normal(0, 15, 3) - turn @ middle
        there = lambda points: points @ turn.T + shift
        off = Rotation.from_rotvec(unit(rng.normal(size=3)) * np.radians(rng.uniform(4, 9))).as_matrix()
        guess = np.eye(4)
        guess[:3, :3] = off @ turn
        guess[:3, 3] = off @ (shift - there(middle)) + there(middle) + unit(rng.normal(size=3)) * rng.uniform(6, 14)
        cloud = np.array(meshio.read(source / frame["points"]).points)
        write_ply(out / frame["points"], there(cloud) + rng.normal(0, NOISE_MM, cloud.shape))
        frame["noise_mm"], frame["pose_guess"] = NOISE_MM, guess.ravel().round(9).tolist()
        contact = region.mean(axis=0)
        if declare == "seen-tool":
            nodes = np.loadtxt(source / "truth" / f"{frame['id']}_nodes.csv", delimiter=",", skiprows=1)[:, -3:]
            contact = nodes[truth["tool_nodes_of_truth_mesh"]].mean(axis=0) + rng.normal(0, 1, 3)
        if declare.endswith("tool"):
            reach = 8.0 if declare == "seen-tool" else float(np.linalg.norm(region - region.mean(axis=0), axis=1).max())
            frame["tools"] = [{"id": "grasper", "contact_mm": there(contact).round(3).tolist(), "radius_mm": round(reach, 2)}]
        true["tools"] = [{"id": "grasper", "force_N": (turn @ true["tool_force_N"]).round(6).tolist()}]
        for target in true["targets"]:
            target["position_mm"] = there(np.array(target["position_mm"])).round(4).tolist()
    (out / "guidance.json").write_text(json.dumps(document, indent=1) + "\n")
    (out / "truth.json").write_text(json.dumps({"case": out.name, "frames": truth["frames"]}, indent=1) + "\n")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("out", type=pathlib.Path)
    words.add_argument("--declare", default="nothing", choices=["nothing", "support", "tool", "seen-tool"])
    words.add_argument("--seed", type=int, default=1)
    asked = words.parse_args()
    sources = sorted(path.parent for path in SOURCE.glob("*/guidance.json"))
    if not sources:
        sys.exit(f"{SOURCE} holds no guidance.json: say in GLISSON_SHARED_DATA where the data lie.")
    for source in sources:
        make(source, asked.out / f"{source.name}-{asked.declare}", asked.declare, asked.seed)


if __name__ == "__main__":
    main()
