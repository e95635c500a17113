#!/usr/bin/python3
"""False alarms as a rate: of judged nulls (judge.py leaves judged.json) how many were called explained, and how many not
"nothing missing", a row a sort of experiment and of noise, with the upper end of the one-sided 95 % interval of Clopper
and Pearson (1934, Biometrika 26:404).

    false_alarms.py JUDGED.json...
"""

import json
import pathlib
import sys
from collections import defaultdict
from math import exp, lgamma, log, log1p


def main():
    rows = defaultdict(list)
    for file in sys.argv[1:]:
        for case in json.loads(pathlib.Path(file).read_text()):
            if not case["truth"] and not case["outside"]:
                rows[case["sort"], case["noise"]].append(case)
    print("\n".join(table(rows)))


def table(rows):
    lines = ["| nulls | noise | called explained | called unexplained |", "|---|---|---|---|"]
    for (sort, noise), cases in sorted(rows.items()):
        explained = sum(c["verdict"] == "explained" for c in cases)
        unexplained = sum(c["verdict"] not in ("explained", "nothing-missing") for c in cases)
        lines.append(f"| {sort} | {noise} | {share(explained, len(cases))} | {share(unexplained, len(cases))} |")
    return lines


def share(found, of):
    return f"{found} of {of} (at most {100 * upper(found, of):.1f} %)"


def upper(found, of, confidence=0.95):
    """The rate at which so few or fewer would be found with 5 % probability."""
    if found >= of:
        return 1.0
    low, high = found / of, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        if below_or_at(found, of, middle) > 1 - confidence:
            low = middle
        else:
            high = middle
    return high


def below_or_at(found, of, rate):
    if rate <= 0 or rate >= 1:
        return float(rate <= 0)
    return sum(exp(lgamma(of + 1) - lgamma(k + 1) - lgamma(of - k + 1) + k * log(rate) + (of - k) * log1p(-rate))
               for k in range(found + 1))


if __name__ == "__main__":
    main()
