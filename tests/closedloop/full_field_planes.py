#!/usr/bin/python3
"""Does `explain` name the law of a plate that a solver of its own pulled, and `predict` a path that was not among its trials? Two laws
of the library, what is as declared, and a stress that relaxes, which is no law; what cannot be an experiment gets its sentence:
full_field_planes.py GLISSON_CLI. Nothing was tuned on this seed."""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
UNDECLARED = pathlib.Path(__file__).parents[1] / "support" / "undeclared"
try:
    import scipy  # noqa: F401
except ModuleNotFoundError as missing:
    print(f"skipped: {missing.name} is not installed")
    sys.exit(77)

LAWS, LEVEL, SEED = "null,isihara,holzapfel,relaxing", "high", "7"


def main():
    with tempfile.TemporaryDirectory() as folder:
        env = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        cases = pathlib.Path(folder) / "cases"
        subprocess.run([sys.executable, UNDECLARED / "make_plane.py", cases, "--laws", LAWS, "--levels", LEVEL, "--seed", SEED],
                       env=env, check=True)
        judged = subprocess.run([sys.executable, UNDECLARED / "judge.py", cases, "--cli", sys.argv[1], "--out",
                                 folder + "/judged"], env=env, check=True, capture_output=True, text=True).stdout
        case = cases / f"plate-isihara-{LEVEL}-s{SEED}"
        predicts_what_was_only_said(sys.argv[1], case, pathlib.Path(folder) / "judged" / case.name / "model.json")
        refuses(sys.argv[1], case)
    print(judged)
    lines = [line for line in judged.splitlines() if line.startswith(("ok ", "WRONG"))]
    sys.exit(len(lines) != len(LAWS.split(",")) or any(line.startswith("WRONG") for line in lines))


def predicts_what_was_only_said(cli, case, model):
    """A trial that names what the grips do and nothing that was measured is predicted as the one that was."""
    experiment = json.loads((case / "heldout.json").read_text())
    rows = [line.split(",") for line in (case / "r5.csv").read_text().splitlines()[1:]]
    experiment["trials"] = [{"id": "said", "prescribed": {"left": {"ux": 0}, "bottom": {"uy": 0}, "right": {"ux": 0.16},
                                                         "top": {"uy": 0.16}}}]
    (case / "said.json").write_text(json.dumps(experiment))
    done = subprocess.run([cli, "predict", case / "said.json", "--with", model, "--values", case / "values.csv", "--json", "--quiet"],
                          capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["trials"][0]["not_compared"]
    forces = {}
    for line in (case / "values.csv").read_text().splitlines()[1:]:
        cells = line.rsplit(",", 4)
        if cells[1] in ("fx", "fy"):
            forces[cells[1]] = float(cells[2])
    measured = {name: float(x or y) for name, x, y in rows}
    for quantity, side in (("fx", "right"), ("fy", "top")):
        assert abs(forces[quantity] - measured[side]) < 0.01 * abs(measured[side]), (quantity, forces, measured)


def refuses(cli, case):
    good = json.loads((case / "experiment.json").read_text())

    def sentence(change):
        bad = copy.deepcopy(good)
        change(bad)
        (case / "bad.json").write_text(json.dumps(bad))
        done = subprocess.run([cli, "explain", case / "bad.json", "--out", case / "bad", "--json", "--quiet"],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 1, f"exit code {done.returncode}"
        return json.loads(done.stdout)["error"]["message"]

    (case / "nowhere.csv").write_text("boundary,fx,fy\nmiddle,1,\n")
    (case / "beyond.csv").write_text("point,ux,uy\n100000,0,0\n")
    for change, expected in [
            (lambda e: e["declared"].update(law="steel"), 'The declared law "steel" is not known'),
            (lambda e: e["declared"].update(C99=1), 'no number called "C99"'),
            (lambda e: e["declared"].pop("D"), "lacks some of its numbers"),
            (lambda e: e["specimen"].update(state="plane-stress"), "plane-strain"),
            (lambda e: e["trials"][0].update(reactions="nowhere.csv"), 'the boundary "middle"'),
            (lambda e: e["trials"][0].update(displacement="beyond.csv"), "names no point of the mesh"),
            (lambda e: e["trials"][0].pop("reactions"), "reactions"),
            (lambda e: e.update(noise=0), "noise")]:
        said = sentence(change)
        assert expected in said, f"{said!r} does not say {expected!r}"


if __name__ == "__main__":
    main()
