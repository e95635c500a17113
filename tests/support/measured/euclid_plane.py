#!/usr/bin/python3
"""A published plate with a hole as a full-field experiment: euclid_plane.py OUT [--case isihara_low] [--data DIR]
[--declared neo-hookean] [--held-out 30,50]

DIR is euclid_plane of the shared data (its SOURCE.txt says what it is: simulated, with the law known). Declared is a
neo-Hookean law with numbers that are nobody's (C10 = 1, D = 1), the noise is the nominal one. Each load step is a trial;
those of --held-out go to heldout.json in place of experiment.json. truth.json is what judge.py takes."""

import csv
import json
import pathlib
import sys

sys.dont_write_bytecode = True
from recordings import asked_for

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "undeclared"))
from plane import write_plane

KINDS = {"neohookean": "neo-hookean", "isihara": "isihara", "gentthomas": "gent-thomas", "haineswilson": "haines-wilson",
         "arrudaboyce": "arruda-boyce", "ogden": "ogden", "anisotropy": "fibre", "holzapfel": "holzapfel"}
NOMINAL = {"low": 1e-4, "high": 1e-3}


def main():
    def more(ask):
        ask.add_argument("--case", default="isihara_low")
        ask.add_argument("--declared", default='{"law": "neo-hookean", "C10": 1, "D": 1}')
        ask.add_argument("--held-out", default="")

    asked = asked_for(__doc__, "euclid_plane", more)
    folder = asked.data / asked.case
    if not folder.is_dir():
        sys.exit(f"no fields at {folder}")
    nodes, triangles = read(asked.data / "mesh_nodes.csv"), read(asked.data / "mesh_triangles.csv")
    write_plane(asked.out / "plate.vtu", [(n["x"], n["y"]) for n in nodes],
                [[int(t[k]) for k in ("node1", "node2", "node3")] for t in triangles],
                {name: [int(n[name]) for n in nodes] for name in ("group_x", "group_y")})
    law, level = asked.case.rsplit("_", 1)
    held_out = [int(step) for step in asked.held_out.split(",") if step]
    trials = {"experiment.json": [], "heldout.json": []}
    for row in read(folder / "reactions.csv"):
        step = int(row["step"])
        field = read(folder / f"step_{step}.csv")
        (asked.out / f"l{step}.csv").write_text(
            "point,ux,uy\n" + "".join(f"{int(n['node'])},{n['ux']!r},{n['uy']!r}\n" for n in field))
        (asked.out / f"r{step}.csv").write_text(
            f"boundary,fx,fy\n1,{row['F1_x']!r},\n2,{row['F2_x']!r},\n3,,{row['F3_y']!r}\n4,,{row['F4_y']!r}\n")
        trials["heldout.json" if step in held_out else "experiment.json"].append(
            {"id": f"step-{step}", "displacement": f"l{step}.csv", "reactions": f"r{step}.csv"})
    for file, chosen in trials.items():
        if chosen:
            (asked.out / file).write_text(json.dumps({
                "format": "glisson-experiment/1", "kind": "full-field", "title": f"Plate with a hole, {asked.case}",
                "specimen": {"mesh": "plate.vtu", "thickness": 1, "state": "plane-strain"},
                "declared": json.loads(asked.declared), "noise": NOMINAL[level], "trials": chosen}, indent=1) + "\n")
    (asked.out / "truth.json").write_text(json.dumps({"kinds": [KINDS[law]], "outside": False, "level": level}) + "\n")


def read(file):
    with file.open() as lines:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(lines)]


if __name__ == "__main__":
    main()
