"""What a person reads of judged cases (judge.py): a line each, then how often what was answered, a row a kind."""

import math
import statistics
from collections import Counter, defaultdict

# What counts as a size: an effect of 1.7 to 2.6 noises is one of about 2.
SIZES = {"2": (0.0, 2.6), "4": (2.6, 5.3), "8 and more": (5.3, math.inf)}
LEVELS = ("low", "high")  # of noise, where a case is told by that and has no size


def line(r):
    mark = "ok   " if r["right"] else "WRONG"
    of_noise = f"{r['level']:>6s}" if r.get("level") else f"{r['size']:5.1f}x"
    return (f"{mark} {r['case']:44s} {of_noise} {r['verdict']:16s} {'+'.join(r['named']) or '-':36s}"
            f" fitted {number(r.get('fitted_before'))} ->{number(r.get('fitted_after'))}"
            f" unseen {number(r.get('unseen_before'))} ->{number(r.get('unseen_after'))}"
            f"  {r['seconds']:5.1f} s, {r['processor_seconds']:5.1f} s of processor"
            f"{'  ' + r['problem'] if 'problem' in r else ''}")


def number(x):
    return "   -  " if x is None or math.isnan(x) else f"{x:6.2f}"


def summary(results):
    nulls = [r for r in results if not r["truth"] and not r["outside"]]
    inside = [r for r in results if r["truth"] and not r["outside"]]
    singles = [r for r in inside if len(r["truth"]) == 1]
    outside = [r for r in results if r["outside"]]
    clear = [r for r in singles if r.get("level") or r["size"] >= 3.9]
    close = unseen(inside, "unseen_after")
    parts = ["", *confusion(results), ""]
    which = "" if any(r.get("level") for r in clear) else " of 4 noises and more"
    parts.append(f"right name, single effects{which}: {share(clear, 'right')}"
                 f" ({share(clear, 'exact')} without the help of `alike`)")
    parts.append(f"right names, pairs: {share([r for r in inside if len(r['truth']) > 1], 'right')}")
    parts.append(f"false alarms in nulls: {sum(not r['right'] for r in nulls)} of {len(nulls)}")
    parts.append(f"wrong confident names of effects in the catalogue: {sum(bool(r.get('wrong_confident')) for r in inside)}"
                 f" of {len(inside)}; outside it: {sum(not r['right'] for r in outside)} of {len(outside)}")
    if close:
        parts.append(f"unseen trials after, in noises: median {statistics.median(close):.2f}; within 1.3 in"
                     f" {sum(c <= 1.3 for c in close)} of {len(inside)}")
    parts.append(f"time: {max(r['seconds'] for r in results):.1f} s at most,"
                 f" {max(r['processor_seconds'] for r in results):.1f} s of processor")
    return "\n".join([*parts, "", *table(results)])


def confusion(results):
    """A row a truth; how often each answer came."""
    rows = defaultdict(Counter)
    for r in results:
        answer = "+".join(sorted(r["named"])) if r["verdict"] == "explained" else r["verdict"]
        rows["+".join(r["truth"]) or "null"][answer] += 1
    return [f"  {row:44s} {', '.join(f'{n} {answer}' for answer, n in count.most_common())}"
            for row, count in sorted(rows.items())]


def table(results):
    """In Markdown: a row a truth, its right answers by size or by level of noise (there also how many without the help of
    `alike`), the smallest size found in 90 % of the cases of that size and larger, the error on unseen trials (medians
    over cases, in noises), and that of hidden targets, where there are any. A column that says nothing is left out."""
    rows = defaultdict(list)
    for r in results:
        rows[(r["outside"], len(r["truth"]), "+".join(r["truth"]) or "null")].append(r)
    groups = columns(results)
    lines = [["undeclared", *groups, "named itself", "found in 90 % from", "other answers",
              "unseen trials: declared / better model, noises", "hidden targets: declared / better model, mm"]]
    for (outside, count, name), cases in sorted(rows.items(), key=lambda row: (row[0][0], row[0][1], row[0][2])):
        cells = [name + (" (outside the catalogue)" if outside else "")]
        for belongs in groups.values():
            inside = [r for r in cases if belongs(r)]
            cells.append(share(inside, "right") if inside else "")
        of_level = any(r.get("level") for r in cases)
        cells.append(share(cases, "exact") if of_level and count == 1 and not outside else "")
        sized = count == 1 and not outside and not of_level
        smallest = smallest_found(cases) if sized else None
        cells.append("" if not sized else "-" if smallest is None else f"{smallest:.1f} noises")
        wrong = Counter("+".join(sorted(r["named"])) if r["verdict"] == "explained" else r["verdict"]
                        for r in cases if not r["right"])
        cells.append(", ".join(f"{n} {answer}" for answer, n in wrong.most_common()))
        for where in ("unseen", "hidden"):
            before, after = unseen(cases, f"{where}_before"), unseen(cases, f"{where}_after")
            cells.append(f"{statistics.median(before):.2f} / {statistics.median(after):.2f}" if before and after else "")
        lines.append(cells)
    said = [i for i in range(len(lines[0])) if any(cells[i] for cells in lines[1:])]
    rows = ["| " + " | ".join(cells[i] for i in said) + " |" for cells in lines]
    return [rows[0], "|" + "---|" * len(said), *rows[1:]]


def columns(results):
    """{heading: whether a case belongs there}"""
    if any(r.get("level") for r in results):
        return {f"right at the {level} noise": lambda r, level=level: r["level"] == level for level in LEVELS}
    return {f"right at {name} noises": lambda r, low=low, high=high: low <= r["size"] < high
            for name, (low, high) in SIZES.items()}


def smallest_found(cases):
    cases = sorted(cases, key=lambda r: r["size"])
    return next((r["size"] for i, r in enumerate(cases)
                 if sum(x["right"] for x in cases[i:]) >= 0.9 * len(cases[i:])), None)


def unseen(cases, name):
    return [r[name] for r in cases if r.get(name) is not None]


def share(cases, key):
    return f"{sum(bool(r.get(key)) for r in cases)} of {len(cases)}"
