#!/usr/bin/python3
"""Do `explain` and `predict` find what CalculiX did to a specimen? A null and three effects that share one truth, made
anew in a folder of their own: undeclared_effects.py GLISSON_CLI. Exit code 77 where CalculiX is not installed; the whole
table is tests/benchmarks/closed_loop.sh."""

import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from with_calculix import UNDECLARED

CASES = [("null", "0"), ("stiffness-scale", "8"), ("force-bias", "4"), ("frame-misalignment", "4")]


def main():
    with tempfile.TemporaryDirectory() as folder:
        env = {**os.environ, "GLISSON_TRUTH_CACHE": folder + "/cache", "OPENBLAS_NUM_THREADS": "1"}
        for kind, size in CASES:
            subprocess.run([sys.executable, UNDECLARED / "make_palpation.py", folder + "/cases", "--kinds", kind, "--sizes",
                            size, "--specimens", "tiny", "--seed", "3"], env=env, check=True)
        judged = subprocess.run([sys.executable, UNDECLARED / "judge.py", folder + "/cases", "--cli", sys.argv[1], "--out",
                                 folder + "/judged"], env=env, check=True, capture_output=True, text=True).stdout
    print(judged)
    lines = [line for line in judged.splitlines() if line.startswith(("ok ", "WRONG"))]
    wrong = [line for line in lines if line.startswith("WRONG")]
    sys.exit(len(lines) != len(CASES) or bool(wrong))


if __name__ == "__main__":
    main()
