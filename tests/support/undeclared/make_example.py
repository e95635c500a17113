#!/usr/bin/python3
"""Makes the example that ships with Evidence: make_example.py OUT (resources/examples/tissue). SIMULATED: a cylinder of
tissue is compressed by plain time stepping (material.py), which shares nothing with the program that explains it.

What the tissue does and its file does not declare stands in OUT/truth.json, which neither the program nor its tests of
the window read. The same bytes every time."""

import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

from material import Effects, ramp_and_hold, ramps, stresses

TITLE = "SIMULATED: a sample of liver tissue in compression"
YOUNGS_KPA, NOISE_KPA = 9.0, 0.04
# As soft tissue does: stiffer the more it is pressed (Fung, Biomechanics, 1993, chapter 7), and giving way while it is
# held. The constants are chosen, not measured.
HIDDEN = Effects(law="yeoh", constants=(1.2, 1.0), relaxation=[(0.3, 12.0)])
FITTED = {"slow": ramps(0.004, [-0.3, 0], 80), "quick": ramps(0.08, [-0.3, 0], 80),
          "steps": ramps(0.03, [-0.12, 0, -0.22, 0, -0.3, 0], 140), "hold": ramp_and_hold(0.1, -0.25, 60, 80)}
HELD_OUT = {"again": ramps(0.02, [-0.26, 0, -0.26, 0], 100), "hold-less": ramp_and_hold(0.05, -0.15, 50, 70)}
ABOUT = """# A sample of tissue, compressed

SIMULATED, by `tests/support/undeclared/make_example.py`; nothing was measured. A cylinder (50 mm wide, 30 mm high) is
compressed by up to 30 % in four ways. Declared is one modulus, 9 kPa, which is what the tissue has at rest.

It does something else besides. What? `glisson-cli explain experiment.json --out DIR` (or *Evidence*, *Try the example*)
says what it finds; `glisson-cli predict heldout.json --with DIR/model.json` holds that against two more tests. The
answer stands in `truth.json`.
"""


def write_tests(out, trials, rng):
    for name, (times, stretches) in trials.items():
        shown = stresses(HIDDEN, YOUNGS_KPA, times, stretches) + rng.normal(0, NOISE_KPA, len(times))
        rows = "\n".join(f"{t:.3f},{x:.6f},{s:.5f}" for t, x, s in zip(times, stretches, shown))
        (out / f"{name}.csv").write_text("time_s,stretch,stress_kPa\n" + rows + "\n")
    return [{"id": name, "file": f"{name}.csv",
             "columns": {"time_s": "time_s", "stretch": "stretch", "stress_kPa": "stress_kPa"}} for name in trials]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    out, rng = pathlib.Path(sys.argv[1]), np.random.default_rng(2026)
    out.mkdir(parents=True, exist_ok=True)
    for file, trials in (("experiment.json", FITTED), ("heldout.json", HELD_OUT)):
        (out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "material", "title": TITLE,
            "specimen": {"shape": "cylinder", "diameter_mm": 50, "height_mm": 30}, "mode": "compression",
            "declared": {"law": "linear", "youngs_modulus_kPa": YOUNGS_KPA}, "noise_kPa": NOISE_KPA,
            "trials": write_tests(out, trials, rng)}, indent=1) + "\n")
    (out / "truth.json").write_text(json.dumps({
        "simulated": TITLE, "command": "tests/support/undeclared/make_example.py resources/examples/tissue",
        "kinds": ["strain-stiffening", "viscoelastic-creep"],
        "strain-stiffening": {"law": "Yeoh: E/3 (x - 1/x^2) (1 + 2 c2 i + 3 c3 i^2), x the stretch, i = x^2 + 2/x - 3",
                              "c2": HIDDEN.constants[0], "c3": HIDDEN.constants[1]},
        "viscoelastic-creep": {"amplitude": HIDDEN.relaxation[0][0], "time_s": HIDDEN.relaxation[0][1]}},
        indent=1) + "\n")
    (out / "README.md").write_text(ABOUT)


if __name__ == "__main__":
    main()
