"""What a model lacks, and how well the better one predicts trials it never saw.

    explain_and_predict.py EXPERIMENT.json HELD_OUT.json OUT

Prints a row of the table of docs/closed-loop.md and leaves report.html, report.json and model.json in OUT.
"""
import json
import pathlib
import sys

import glisson

experiment, held_out, out = map(pathlib.Path, sys.argv[1:4])
glisson.write_explanation(experiment, out)
report = json.loads((out / "report.json").read_text())
declared = glisson.predict(held_out)["error"]["rms"]
better = glisson.predict(held_out, out / "model.json")["error"]["rms"]
found = ", ".join(effect["kind"] for effect in report["effects"]) or "nothing"
print(f"{found}: unseen trials {declared:.3g} / {better:.2g} {report['unit']}, {report['verdict']}")
