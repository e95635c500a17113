#!/usr/bin/python3
"""What `explain` makes of real recordings, and how it predicts the trials that were left out: a row a recording.

    tests/benchmarks/recordings.py build/release/bin/glisson-cli            # nobody knows the answer
    tests/benchmarks/recordings.py --planes build/release/bin/glisson-cli   # published plates, whose law is known

tests/support/measured/NAME.py makes each experiment, and says what was declared and how the
noise was taken. Reads the shared data (tests/support/measured/recordings.py); needs python3-numpy."""

import json
import pathlib
import subprocess
import sys
import tempfile

MAKERS = pathlib.Path(__file__).resolve().parents[1] / "support" / "measured"
RECORDINGS = [("silicone in compression to 67 %", "silicone", ""), ("elastomer, relaxation and load-unload", "elastomer", ""),
              ("lithium cell at 2C and 4C from C/10, 1C and 3C", "battery", ""), ("Jetson TX2 playing video", "boards", "tx2"),
              ("Jetson Xavier at inference", "boards", "xavier"), ("Odroid N2+ at inference", "boards", "odroid"),
              ("silicone beam under its weight and 52 g", "softbeam", ""), ("da Vinci grasper's spindle", "davinci", "")]
PLANES = [(f"{law}, nominal noise {noise}", f"{law}_{level}", truth)
          for law, truth in (("isihara", "0.5, 1, 1, 1.5"), ("neohookean", "0.5, 1.5"))
          for noise, level in (("1e-4", "low"), ("1e-3", "high"))]


def main():
    if sys.argv[1] == "--planes":
        planes()
    else:
        recordings()


def ask(*words):
    return json.loads(subprocess.run([sys.argv[-1], *map(str, words), "--json", "--quiet"], check=True, capture_output=True,
                                     text=True).stdout)


def recordings():
    print("| recording | made by | named | unseen trials: declared / better model | verdict |\n|---|---|---|---|---|")
    for what, maker, part in RECORDINGS:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([MAKERS / f"{maker}.py", folder], check=True, stdout=subprocess.DEVNULL)
            case = pathlib.Path(folder) / part
            found = ask("explain", case / "experiment.json", "--out", case / "report")
            declared = ask("predict", case / "heldout.json")
            better = ask("predict", case / "heldout.json", "--with", case / "report" / "model.json")
        print(f"| {what} | `{maker}.py` | {', '.join(map(named, found['effects'])) or 'nothing'} | {errors(declared, better)} |"
              f" {found['verdict']} |", flush=True)


def planes():
    print("| plate | named | numbers (truth) | steps left out, noises |\n|---|---|---|---|")
    for what, case, truth in PLANES:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([MAKERS / "euclid_plane.py", folder, "--case", case], check=True, stdout=subprocess.DEVNULL)
            found = ask("explain", f"{folder}/experiment.json", "--out", f"{folder}/report")
        effect = found["effects"][0]
        numbers = ", ".join(f"{name} {value['value']:.3f}" for name, value in effect["parameters"].items() if name != "law")
        print(f"| {what} | {named(effect)} | {numbers} ({truth}) | {found['after']['held_out_rms']:.2f} |", flush=True)


def named(effect):
    """A kind, with its law where it has several, and with the one that the data cannot tell from it."""
    law = effect["parameters"].get("law", {}).get("value")
    said = [law] if law and law != effect["kind"] else []
    said += [f"alike {', '.join(effect['alike'])}"] if effect["alike"] else []
    return effect["kind"] + (f" ({'; '.join(said)})" if said else "")


def errors(declared, better):
    """Root mean squares, in each unit that the recording has."""
    units = {key: key.removeprefix("rms_").split("_")[-1] for key in declared if key.startswith("rms_")}
    units = units or {"rms": declared["unit"]}
    return "; ".join(f"{declared[key]:.3g} / {better[key]:.3g} {unit}" for key, unit in units.items())


if __name__ == "__main__":
    main()
