#!/usr/bin/python3
"""Runs experiments with a known answer through `glisson-cli explain`, then `predict` on trials it never saw, and counts.

    judge.py CASES... --cli build/release/bin/glisson-cli --out DIR [--threads N] [--explain-only]

A case is a folder with experiment.json, heldout.json and truth.json (what make_palpation.py, make_material.py and
make_platform.py leave), or a folder of such folders. Prints the table; DIR keeps each case's report and judged.json.
What the program said of a case is kept in DIR/CASE/answers.json with the SHA-256 of the program and of the case: asked
again, only what was not asked of this program yet is run, so that a long judging can be stopped and taken up again.

Right means: the kinds named are those switched on, where each may instead stand in the `alike` of the one named. A wrong
confident name is verdict `explained` with a cause in it that was not switched on and is not alike; a smooth correction
claims no cause. At the end it says how far the probabilities can be relied on (reliability.py); for that alone
--explain-only spares the predictions.
"""

import argparse
import hashlib
import json
import math
import pathlib
import resource
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from judged_table import line, summary
from reliability import reliability


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("cases", nargs="+", type=pathlib.Path)
    ask.add_argument("--cli", type=pathlib.Path, required=True)
    ask.add_argument("--out", type=pathlib.Path, required=True)
    ask.add_argument("--threads", default=None)
    ask.add_argument("--explain-only", action="store_true")
    asked = ask.parse_args()
    folders = sorted({f.parent for c in asked.cases for f in [*c.glob("truth.json"), *c.glob("*/truth.json")]})
    if not folders:
        sys.exit("no case: a folder with truth.json is asked for")
    results = []
    for folder in folders:
        result = judge(folder, answers(folder, asked))
        results.append(result)
        print(line(result), flush=True)
    (asked.out / "judged.json").write_text(json.dumps(results, indent=1) + "\n")
    print(summary(results))
    print("\n".join(reliability(results)))


# What the program says.

def answers(folder, asked):
    """Of `explain` and of `predict` on the unseen trials without and with what was found; kept from an earlier run of the
    same program on the same files."""
    out = asked.out / folder.name
    kept = out / "answers.json"
    of = {"program": sha256([asked.cli]), "case": sha256(sorted(f for f in folder.iterdir() if f.is_file()))}
    if kept.exists():
        said = json.loads(kept.read_text())
        if said["of"] == of and (asked.explain_only or "unseen_after" in said or "problem" in said):
            return said
    said = {"of": of}
    started, worked = time.monotonic(), processor_seconds()
    said["report"], problem = cli(asked, ["explain", folder / "experiment.json", "--out", out])
    said["seconds"], said["processor_seconds"] = time.monotonic() - started, processor_seconds() - worked
    if not problem and not asked.explain_only:
        for name, extra in (("unseen_before", []), ("unseen_after", ["--with", out / "model.json"])):
            prediction, trouble = cli(asked, ["predict", folder / "heldout.json", *extra])
            said[name] = None if trouble else rms(prediction)
            said[name.replace("unseen", "hidden")] = (prediction or {}).get("hidden_targets", {}).get("mean_mm")
            problem = problem or trouble
    if problem:
        said["problem"] = problem
    out.mkdir(parents=True, exist_ok=True)
    kept.write_text(json.dumps(said) + "\n")
    return said


def sha256(files):
    digest = hashlib.sha256()
    for file in files:
        digest.update(file.read_bytes())
    return digest.hexdigest()


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def cli(asked, words):
    threads = ["--threads", asked.threads] if asked.threads else []
    done = subprocess.run([asked.cli, *map(str, words), "--json", "--quiet", *threads], capture_output=True, text=True,
                          check=False)
    try:
        document = json.loads(done.stdout)
    except json.JSONDecodeError:
        return None, f"exit code {done.returncode}, no JSON: {done.stderr[-300:]}"
    if done.returncode != 0:
        return None, f"exit code {done.returncode}: {document.get('error', {}).get('message', '')}"
    return document, None


def rms(document):
    return next((document[k] for k in ("rms_mm", "rms") if k in document), math.nan)


# Whether that is right.

def judge(folder, said):
    truth = json.loads((folder / "truth.json").read_text())
    result = {"case": folder.name, "truth": truth["kinds"], "outside": truth["outside"],
              "size": truth.get("size"), "level": truth.get("level"),
              "sort": sort_of(folder), "noise": truth.get("noise", "stated"),
              "seconds": said["seconds"], "processor_seconds": said["processor_seconds"]}
    if "problem" in said:
        result["problem"] = said["problem"]
    report = said["report"]
    if not report:
        return {**result, "verdict": "failed", "named": [], "right": False}
    result["verdict"] = report["verdict"]
    causes = [e for e in report["effects"] if e["kind"] != "smooth-correction"]
    result["named"] = [e["kind"] for e in causes]
    result["corrected"] = len(causes) < len(report["effects"])
    alike = {r["kind"]: set(r.get("alike", [])) for r in report["ranking"]}
    for e in causes:
        alike[e["kind"]] = alike.get(e["kind"], set()) | set(e.get("alike", []))
    result["posterior"] = report.get("posterior", {}).get("explanations", [])
    result["exact"] = sorted(set(result["named"])) == sorted(truth["kinds"])
    result["right"] = matches(truth, result, alike)
    result["wrong_confident"] = result["verdict"] == "explained" and not result["right"]
    result["alike"] = {k: sorted(alike[k]) for k in result["named"] if alike[k]}
    result["parameters"] = {e["kind"]: {k: v.get("value") if isinstance(v, dict) else v
                                        for k, v in e["parameters"].items()} for e in causes}
    noises = noise_units(folder, report)
    result["fitted_before"], result["fitted_after"] = (rms(report[k]) / noises for k in ("before", "after"))
    for name in ("unseen_before", "unseen_after"):
        result[name] = None if said.get(name) is None else said[name] / noises
    for name in ("hidden_before", "hidden_after"):  # mm, on the unseen trials; guidance alone
        result[name] = said.get(name)
    return result


def matches(truth, result, alike):
    if truth["outside"]:
        return result["verdict"] != "explained" or not result["named"]
    if not truth["kinds"]:
        return result["verdict"] == "nothing-missing" and not result["named"]
    if result["verdict"] != "explained" or len(result["named"]) != len(truth["kinds"]):
        return False
    left = list(result["named"])
    for kind in truth["kinds"]:
        found = kind if kind in left else next((n for n in left if kind in alike.get(n, ())), None)
        if found is None:
            return False
        left.remove(found)
    return True


def sort_of(folder):
    return json.loads((folder / "experiment.json").read_text())["kind"]


def noise_units(folder, report):
    """What one standard deviation of the noise is in the report's unit: 1 where it is divided by it already."""
    experiment = json.loads((folder / "experiment.json").read_text())
    key = {"palpation": "noise_mm", "guidance": "noise_mm", "material": "noise_kPa"}.get(experiment["kind"])
    return experiment.get(key, 1.0)


if __name__ == "__main__":
    main()
