"""Are probabilities what they say? Of judged cases (judge.py) each explanation's probability beside whether it was the
truth: a table, and the expected calibration error (Naeini, Cooper, Hauskrecht 2015, AAAI 29:2901; ten bins of equal
width). An explanation is right when its kinds are those that were switched on, none more and none less, without the help
of `alike`; "nothing is missing" for a null; "something else" for an effect outside of the catalogue."""

import math
import random

BINS = 10
WORTH_COUNTING = 0.01
NEARLY_TWO = 1.8  # what was asked for comes out a little smaller or larger


def is_truth(explanation, case):
    if explanation["kinds"] is None:
        return case["outside"]
    return not case["outside"] and sorted(explanation["kinds"]) == sorted(case["truth"])


def reliability(results):
    """Lines for a person; nothing where no case has probabilities."""
    cases = [r for r in results if r.get("posterior")]
    if not cases:
        return []
    leading = [(r["posterior"][0]["probability"], is_truth(r["posterior"][0], r)) for r in cases]
    all_of_them = [(e["probability"], is_truth(e, r)) for r in cases for e in r["posterior"]
                   if e["probability"] >= WORTH_COUNTING]
    of_truth = [next((e["probability"] for e in r["posterior"] if is_truth(e, r)), 0.0) for r in cases]
    return ["", f"probabilities, {len(cases)} cases: expected calibration error of the likeliest explanation"
                f" {error(leading):.3f}, of all that were given 1 % and more {error(all_of_them):.3f};"
                f" the likeliest is right in {sum(right for _, right in leading)} of {len(cases)};"
                f" mean of -ln (probability of the truth) {sum(-math.log(max(p, 1e-3)) for p in of_truth) / len(cases):.2f}",
            "", "| sort | cases | expected calibration error of the likeliest | were it calibrated: median, 95th percentile |"
            " likeliest is right |", "|---|---|---|---|---|", *sorts(cases, leading),
            "", "| probability given | likeliest: right | mean given | all: right | mean given |", "|---|---|---|---|---|",
            *rows(leading, all_of_them),
            "", "| undeclared | right name | wrong name | unexplained | nothing missing |", "|---|---|---|---|---|",
            *verdicts(cases)]


def verdicts(cases):
    """What follows of them (judge.py), by what was put in; sizes in noises."""
    of = {"nothing": [], "under 2 noises": [], "2 noises and more": [], "outside of the catalogue, under 2": [],
          "outside of the catalogue, 2 and more": []}
    for case in cases:
        large = (case.get("size") or 0) >= NEARLY_TWO
        name = ("2 noises and more" if large else "under 2 noises") if case["truth"] else "nothing"
        if case["outside"]:
            name = f"outside of the catalogue, {'2 and more' if large else 'under 2'}"
        of[name].append(case)
    for name, inside in of.items():
        explained = [r for r in inside if r["verdict"] == "explained"]
        counts = [sum(r["right"] for r in explained), sum(not r["right"] for r in explained)]
        counts += [sum(r["verdict"] == verdict for r in inside) for verdict in ("unexplained", "nothing-missing")]
        if inside:
            yield f"| {name} | {' | '.join(str(count) for count in counts)} |"


def sorts(cases, leading):
    """A row for all, and one a sort of experiment where there are several."""
    of = {"all": leading}
    for case, pair in zip(cases, leading):
        of.setdefault(case.get("sort", "cases"), []).append(pair)
    for sort, pairs in of.items():
        if sort == "all" or len(of) > 2:
            median, high = by_chance([p for p, _ in pairs])
            yield (f"| {sort} | {len(pairs)} | {error(pairs):.3f} | {median:.3f}, {high:.3f} |"
                   f" {sum(right for _, right in pairs)} |")


def by_chance(given, draws=2000):
    """The error that so few cases would show if probabilities were what they say: median and 95th percentile."""
    chance = random.Random(1)
    errors = sorted(error([(p, chance.random() < p) for p in given]) for _ in range(draws))
    return errors[draws // 2], errors[draws * 95 // 100]


def bins(pairs):
    sorted_in = [[] for _ in range(BINS)]
    for probability, right in pairs:
        sorted_in[min(BINS - 1, int(probability * BINS))].append((probability, right))
    return sorted_in


def error(pairs):
    return sum(abs(sum(right for _, right in inside) - sum(p for p, _ in inside)) for inside in bins(pairs)) / len(pairs)


def rows(leading, all_of_them):
    return [f"| {100 * i // BINS} to {100 * (i + 1) // BINS} % | {told(of_leading)} | {told(of_all)} |"
            for i, (of_leading, of_all) in enumerate(zip(bins(leading), bins(all_of_them))) if of_leading or of_all]


def told(inside):
    if not inside:
        return " | "
    return f"{sum(right for _, right in inside)} of {len(inside)} | {100 * sum(p for p, _ in inside) / len(inside):.0f} %"
