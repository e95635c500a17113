#!/usr/bin/python3
"""Runs experiments with a known answer through `glisson-cli explain`, then `predict` on trials it never saw, and counts.

    judge.py CASES... --cli build/release/bin/glisson-cli --out DIR [--threads N]

A case is a folder with experiment.json, heldout.json and truth.json (what make_palpation.py, make_material.py and
make_platform.py leave), or a folder of such folders. Prints the table; DIR keeps each case's report and judged.json.

Right means: the kinds named are those switched on, where each may instead stand in the `alike` of the one named. A wrong
confident name is verdict `explained` with a cause in it that was not switched on and is not alike; a smooth correction
claims no cause.
"""

import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys
import time
from collections import Counter, defaultdict


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("cases", nargs="+", type=pathlib.Path)
    ask.add_argument("--cli", type=pathlib.Path, required=True)
    ask.add_argument("--out", type=pathlib.Path, required=True)
    ask.add_argument("--threads", default=None)
    asked = ask.parse_args()
    folders = sorted({f.parent for c in asked.cases for f in [*c.glob("truth.json"), *c.glob("*/truth.json")]})
    if not folders:
        sys.exit("no case: a folder with truth.json is asked for")
    results = []
    for folder in folders:
        result = judge(folder, asked)
        results.append(result)
        print(line(result), flush=True)
    asked.out.mkdir(parents=True, exist_ok=True)
    (asked.out / "judged.json").write_text(json.dumps(results, indent=1) + "\n")
    print(summary(results))


def judge(folder, asked):
    truth = json.loads((folder / "truth.json").read_text())
    out = asked.out / folder.name
    result = {"case": folder.name, "truth": truth["kinds"], "outside": truth["outside"], "size": truth["size"]}
    started, worked = time.monotonic(), processor_seconds()
    report, problem = cli(asked, ["explain", folder / "experiment.json", "--out", out])
    result["seconds"], result["processor_seconds"] = time.monotonic() - started, processor_seconds() - worked
    if problem:
        return {**result, "verdict": "failed", "named": [], "right": False, "problem": problem}
    result["verdict"] = report["verdict"]
    causes = [e for e in report["effects"] if e["kind"] != "smooth-correction"]
    result["named"] = [e["kind"] for e in causes]
    result["corrected"] = len(causes) < len(report["effects"])
    alike = {r["kind"]: set(r.get("alike", [])) for r in report["ranking"]}
    for e in causes:
        alike[e["kind"]] = alike.get(e["kind"], set()) | set(e.get("alike", []))
    result["exact"] = sorted(set(result["named"])) == sorted(truth["kinds"])
    result["right"] = matches(truth, result, alike)
    result["wrong_confident"] = result["verdict"] == "explained" and not result["right"]
    result["alike"] = {k: sorted(alike[k]) for k in result["named"] if alike[k]}
    result["parameters"] = {e["kind"]: {k: v.get("value") if isinstance(v, dict) else v
                                        for k, v in e["parameters"].items()} for e in causes}
    noises = noise_units(folder, report)
    result["fitted_before"], result["fitted_after"] = (rms(report[k]) / noises for k in ("before", "after"))
    for name, extra in (("unseen_before", []), ("unseen_after", ["--with", out / "model.json"])):
        prediction, problem = cli(asked, ["predict", folder / "heldout.json", *extra])
        result[name] = None if problem else rms(prediction) / noises
        if problem:
            result["problem"] = problem
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


def noise_units(folder, report):
    """What one standard deviation of the noise is in the report's unit: 1 where it is divided by it already."""
    experiment = json.loads((folder / "experiment.json").read_text())
    return {"palpation": experiment.get("noise_mm"), "material": experiment.get("noise_kPa")}.get(experiment["kind"], 1.0)


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def rms(document):
    return next((document[k] for k in ("rms_mm", "rms") if k in document), math.nan)


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


# What a person reads.

def line(r):
    number = lambda x: "   -  " if x is None or math.isnan(x) else f"{x:6.2f}"
    mark = "ok   " if r["right"] else "WRONG"
    return (f"{mark} {r['case']:44s} {r['size']:5.1f}x {r['verdict']:16s} {'+'.join(r['named']) or '-':36s}"
            f" fitted {number(r.get('fitted_before'))} ->{number(r.get('fitted_after'))}"
            f" unseen {number(r.get('unseen_before'))} ->{number(r.get('unseen_after'))}  {r['seconds']:5.1f} s, {r['processor_seconds']:5.1f} s of processor"
            f"{'  ' + r['problem'] if 'problem' in r else ''}")


def summary(results):
    parts = []
    nulls = [r for r in results if not r["truth"] and not r["outside"]]
    inside = [r for r in results if r["truth"] and not r["outside"]]
    singles = [r for r in inside if len(r["truth"]) == 1]
    outside = [r for r in results if r["outside"]]
    clear = [r for r in singles if r["size"] >= 3.9]
    close = [r["unseen_after"] for r in inside if r.get("unseen_after") is not None]
    parts.append("")
    parts += confusion(results)
    parts.append(f"\nright name, single effects of 4 noises and more: {share(clear, 'right')}"
                 f" ({share(clear, 'exact')} without the help of `alike`)")
    parts.append(f"right names, pairs: {share([r for r in inside if len(r['truth']) > 1], 'right')}")
    parts.append(f"false alarms in nulls: {sum(not r['right'] for r in nulls)} of {len(nulls)}")
    parts.append(f"wrong confident names outside the catalogue: {sum(not r['right'] for r in outside)} of {len(outside)}")
    if close:
        parts.append(f"unseen trials after, in noises: median {sorted(close)[len(close) // 2]:.2f}; within 1.3 in"
                     f" {sum(c <= 1.3 for c in close)} of {len(inside)}")
    parts.append(f"time: {max(r['seconds'] for r in results):.1f} s at most,"
                 f" {max(r['processor_seconds'] for r in results):.1f} s of processor")
    parts.append("\nsmallest size found in 90 % of the cases of that size and larger:")
    for kind in sorted({r["truth"][0] for r in singles}):
        of_kind = sorted((r for r in singles if r["truth"] == [kind]), key=lambda r: r["size"])
        smallest = next((r["size"] for i, r in enumerate(of_kind)
                         if sum(x["right"] for x in of_kind[i:]) >= 0.9 * len(of_kind[i:])), None)
        parts.append(f"  {kind:30s} {'-' if smallest is None else f'{smallest:.1f} noises'}  ({len(of_kind)} cases)")
    return "\n".join(parts)


def share(cases, key):
    return f"{sum(bool(r.get(key)) for r in cases)} of {len(cases)}"


def confusion(results):
    """A row a truth; how often each answer came."""
    rows = defaultdict(Counter)
    for r in results:
        answer = "+".join(sorted(r["named"])) if r["verdict"] == "explained" else r["verdict"]
        rows["+".join(r["truth"]) or "null"][answer] += 1
    return [f"  {row:44s} {', '.join(f'{n} {answer}' for answer, n in count.most_common())}"
            for row, count in sorted(rows.items())]


if __name__ == "__main__":
    main()
