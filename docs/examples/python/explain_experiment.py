"""What does a model lack that measurements show?   explain_experiment.py resources/examples/tissue/experiment.json OUT

Prints the verdict and its evidence, and leaves the better model in OUT.
"""
import json
import pathlib
import sys

import glisson

explained = glisson.explain(sys.argv[1])
found = explained["report"]
before, after = found["before"], found["after"]
print(f"{found['verdict']}: the declared model is off by {before['rms']:.2f} {found['unit']}, the better one by "
      f"{after['rms']:.2f}, noise is {after['noise']:.2f}.")
if "held_out_rms" in after:
    low, high = after["held_out_interval"]
    print(f"Trials that a fit never saw: {after['held_out_rms']:.2f} {found['unit']} ({low:.2f} to {high:.2f}).")
for effect in found["effects"]:
    print(f"{effect['kind']}: {effect['sentence']}")
    for name, value in effect["parameters"].items():
        if name == "law":
            continue
        print(f"    {name} = {value['value']:.3g} (95 %: {value['interval'][0]:.3g} to {value['interval'][1]:.3g})")
    for kind in effect["alike"]:
        print(f"    these data cannot tell it from {kind}")
for note in found["notes"]:
    print("-", note)

out = pathlib.Path(sys.argv[2])
out.mkdir(parents=True, exist_ok=True)
(out / "model.json").write_text(json.dumps(explained["model"]))
