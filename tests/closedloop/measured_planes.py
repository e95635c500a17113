#!/usr/bin/python3
"""Does `explain` give a published plate whose field was smoothed (Joshi and others 2022; euclid_plane of the shared data) the plain
law that made it, and not a freer one that follows what smoothing left: measured_planes.py GLISSON_CLI. The case was looked at
while the rule was made. Exit code 77 where the data is absent."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve()
MAKER = HERE.parents[1] / "support" / "measured" / "euclid_plane.py"
SHARED = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA", HERE.parents[2].parent / "shared" / "data"))


def main():
    data = SHARED / "euclid_plane"
    if not data.is_dir():
        print(f"skipped: no real data at {data}")
        sys.exit(77)
    truth = json.loads((data / "truth" / "neohookean.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "plane"
        subprocess.run([sys.executable, MAKER, made, "--case", "neohookean_low", "--data", data], check=True)
        found = json.loads(subprocess.run(
            [sys.argv[1], "explain", str(made / "experiment.json"), "--out", folder + "/report", "--json", "--quiet"],
            check=True, capture_output=True, text=True).stdout)
    (effect,) = found["effects"]
    print(f"plane: {found['verdict']}, {effect['kind']}, of {truth['law']}")
    assert found["verdict"] == "explained", found["verdict"]
    assert effect["kind"] == "neo-hookean", effect
    for name, right in (("C10", truth["parameters"]["K1"]), ("D", truth["parameters"]["(J-1)^2"])):
        assert abs(effect["parameters"][name]["value"] - right) < 0.005 * right, effect["parameters"]


if __name__ == "__main__":
    main()
