#!/usr/bin/python3
"""Does making the trials that `explain` asks for lead to the right name? On a specimen whose support gives, pressed once and
then as asked, by CalculiX, and on a material test: asked_trials.py GLISSON_CLI. Exit code 77 where something is missing; the
whole comparison of rules is tests/support/undeclared/lab.py."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from with_calculix import UNDECLARED

CASES = [("palpation", "support-compliance", "4"), ("material", "stiffness-scale", "3")]
AT_MOST = 3


def main():
    with tempfile.TemporaryDirectory() as folder:
        env = {**os.environ, "GLISSON_TRUTH_CACHE": folder + "/cache"}
        wrong = [case for case in CASES if not named(folder, env, *case)]
    sys.exit(bool(wrong))


def named(folder, env, sort, kind, size):
    """After one trial or more than that, and not from the start: else no trial was asked for."""
    out = pathlib.Path(folder) / sort
    print(subprocess.run([sys.executable, UNDECLARED / "lab.py", out, "--cli", sys.argv[1], "--sorts", sort, "--kinds", kind,
                          "--sizes", size, "--seeds", "3", "--rules", "information", "--at-most", str(AT_MOST)],
                         env=env, check=True, capture_output=True, text=True).stdout)
    took = json.loads((out / "lab.json").read_text())[0]["took"]["information"]
    return took is not None and 1 <= took <= AT_MOST


if __name__ == "__main__":
    main()
