#!/usr/bin/python3
"""Benchmarks of two builds in turn, so that a machine that becomes slower does so for both: medians and their ratio.

    tests/benchmarks/compare.py OLD/bin NEW/bin [--rounds 3] [--seconds 0.5] PROGRAM=FILTER...

PROGRAM is a Google Benchmark program that stands in both folders, FILTER a regular expression of its names. Where a program
does not know a name, it is left out. Times are of the processor, which a busy machine spoils least.
"""

import argparse
import json
import pathlib
import statistics
import subprocess


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("old", type=pathlib.Path)
    ask.add_argument("new", type=pathlib.Path)
    ask.add_argument("programs", nargs="+", metavar="PROGRAM=FILTER")
    ask.add_argument("--rounds", type=int, default=3)
    ask.add_argument("--seconds", default="0.5", help="that each benchmark takes at least")
    asked = ask.parse_args()
    times = {}
    for program, _, names in (one.partition("=") for one in asked.programs):
        for turn in range(asked.rounds):
            for folder in (asked.old, asked.new) if turn % 2 == 0 else (asked.new, asked.old):
                for name, ms in measured(folder / program, names or ".*", asked.seconds):
                    times.setdefault(name, {}).setdefault(folder, []).append(ms)
    print("\n".join(table(times, asked.old, asked.new)))


def measured(program, names, seconds):
    said = subprocess.run([program, f"--benchmark_filter={names}", "--benchmark_format=json", f"--benchmark_min_time={seconds}"],
                          capture_output=True, text=True, check=True).stdout
    scale = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    return [(b["name"], b["cpu_time"] * scale[b["time_unit"]]) for b in json.loads(said)["benchmarks"]
            if b.get("run_type") != "aggregate"]


def table(times, old, new):
    yield "| benchmark | before, ms | now, ms | ratio |"
    yield "|---|---|---|---|"
    for name, of in times.items():
        if len(of) == 2:
            before, now = statistics.median(of[old]), statistics.median(of[new])
            yield f"| {name} | {before:.3g} | {now:.3g} | {now / before:.2f} |"


if __name__ == "__main__":
    main()
