#!/usr/bin/python3
"""Does `explain` find in a guided sequence what CalculiX did to the organ or to the camera, and are hidden targets then
nearer to where they are, on pulls that it never saw? A null, effects of the catalogue, and one outside of it, which must
not be called one of them; of an organ that a ligament ties besides, an adhesion that nobody declared, and the ligament
declared where there is none: undeclared_guidance.py GLISSON_CLI. Exit code 77 where CalculiX is not installed. Nothing
was tuned on this seed."""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from with_calculix import UNDECLARED

SEED = "7"
CASES = {"tiny": "null,stiffness-scale,support-compliance,frame-misalignment,stiff-inclusion,cut",
         "tied": "null,undeclared-attachment,missing-attachment"}


def main():
    with tempfile.TemporaryDirectory() as folder:
        env = {**os.environ, "GLISSON_TRUTH_CACHE": folder + "/cache", "OPENBLAS_NUM_THREADS": "1"}
        for specimen, kinds in CASES.items():
            subprocess.run([sys.executable, UNDECLARED / "make_guidance.py", folder + "/cases", "--specimens", specimen,
                            "--kinds", kinds, "--sizes", "8", "--seed", SEED], env=env, check=True)
        judged = subprocess.run([sys.executable, UNDECLARED / "judge.py", folder + "/cases", "--cli", sys.argv[1], "--out",
                                 folder + "/judged"], env=env, check=True, capture_output=True, text=True).stdout
        targets_come_nearer(pathlib.Path(folder) / "judged")
        refuses(sys.argv[1], pathlib.Path(folder) / "cases" / f"tiny-null-s{SEED}")
    print(judged)
    lines = [line for line in judged.splitlines() if line.startswith(("ok ", "WRONG"))]
    wrong = [line for line in lines if line.startswith("WRONG")]
    sys.exit(len(lines) != sum(len(kinds.split(",")) for kinds in CASES.values()) or bool(wrong))


def targets_come_nearer(judged):
    """On pulls that were never seen, where an effect was explained; where what was found takes them farther off, it is said."""
    for result in json.loads((judged / "judged.json").read_text()):
        before, after = result["hidden_before"], result["hidden_after"]
        print(f"{result['case']}: hidden targets of unseen pulls {before:.3f} mm before, {after:.3f} after")
        if result["verdict"] == "explained":
            assert after < 0.5 * before, f"{result['case']}: the targets are no nearer"
        if result["verdict"] == "nothing-missing":
            assert after <= 1.05 * before, f"{result['case']}: the targets are farther off"
        report = json.loads((judged / result["case"] / "report.json").read_text())
        seen = report["hidden_targets"]
        farther = seen["after"]["mean_mm"] > seen["before"]["mean_mm"]
        assert farther == any("farther off with what was found" in note for note in report["notes"]), result["case"]


def refuses(cli, case):
    """What cannot be an experiment gets its sentence."""
    good = json.loads((case / "experiment.json").read_text())

    def sentence(change):
        bad = copy.deepcopy(good)
        change(bad)
        (case / "bad.json").write_text(json.dumps(bad))
        done = subprocess.run([cli, "explain", case / "bad.json", "--out", case / "bad", "--json", "--quiet"],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 1, f"exit code {done.returncode}"
        return json.loads(done.stdout)["error"]["message"]

    frame = good["frames"][0]["id"]
    mirrored = [x if i else -x for i, x in enumerate(good["frames"][0]["pose_guess"])]
    for change, expected in [
            (lambda e: e["frames"][0].update(pose_guess=mirrored), f"frame {frame}, pose_guess must be a rigid motion"),
            (lambda e: e["frames"][0].update(pose_guess=[1, 0, 0, 900, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
             f"In frame {frame} most points"),
            (lambda e: e["frames"][0].update(tools=2 * e["frames"][0]["tools"]), "more than one tool"),
            (lambda e: e["frames"][1].update(id=frame), f'Two frames have the id "{frame}"'),
            (lambda e: e["trials"][0]["frames"].append("x"), 'names the frame "x", which is not there'),
            (lambda e: e["trials"][1]["frames"].append(frame), "belongs to two trials"),
            (lambda e: e["trials"].pop(), "belong to no trial"),
            (lambda e: e["frames"].clear(), "at least one frame"),
            (lambda e: e.pop("supports"), "supports")]:
        said = sentence(change)
        assert expected in said, f"{said!r} does not say {expected!r}"


if __name__ == "__main__":
    main()
